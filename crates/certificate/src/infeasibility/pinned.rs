use super::proof::{CAUTION, Proof, ProofKind};
use super::things::{Thing, Things};
use pairtrawl_geometry::{Point, Segment};
use pairtrawl_model::numbers::{enough_length, length, place};
use pairtrawl_model::{PairPose, Scene};
use std::f64::consts::FRAC_PI_2;

/// The objects closer to an obstacle than two robot radii, or closer to the edge of the area than one, where neither the
/// first nor the last line passes between.
pub(super) fn prove(things: &Things<'_>) -> Vec<Proof> {
    let scene = things.scene;
    if !always_forward(scene) {
        return Vec::new();
    }
    let line = |pair: PairPose| Segment::new(pair.left.position(), pair.right.position());
    let lines = [line(scene.start), line(scene.end)];
    let wanted = (0..scene.objects.len()).filter(|&i| !scene.objects[i].leave);
    wanted
        .filter_map(|object| pinned(things, &lines, object))
        .collect()
}

/// The proof about one object, by the first obstacle that pins it.
fn pinned(things: &Things<'_>, lines: &[Segment], i: usize) -> Option<Proof> {
    let scene = things.scene;
    let wide = 2.0 * scene.robot.radius;
    let object = &scene.objects[i];
    let (center, rho) = (object.position, object.footprint_radius());
    let passes = |foot: Point| {
        let shortest = Segment::new(center, foot);
        (lines.iter()).any(|line| line.gap_to_segment(&shortest).distance <= CAUTION)
    };
    let (to_edge, foot) = nearest_edge(scene, center);
    let gap = to_edge - rho;
    if gap < scene.robot.radius - CAUTION && to_edge > 0.0 && !passes(foot) {
        return Some(at_edge(scene, i, gap));
    }
    let near = things.obstacles.distances(center, wide + rho - CAUTION);
    near.into_iter().find_map(|(distance, part)| {
        if distance <= 0.0 || !has_inside(things, Thing::Obstacle(part)) {
            return None; // The object is inside the obstacle: bad input. An obstacle without inside proves nothing.
        }
        if passes(things.nearest_point(Thing::Obstacle(part), center)) {
            return None;
        }
        let gap = distance - rho;
        Some(Proof {
            kind: ProofKind::ObjectPinned { object: i, gap },
            message: format!(
                "object {i} at {} cannot be swept: {} between its footprint circle and {part}, where a robot needs {} to \
                 pass, so both robots pass on the same side of it, and the line between them passes there neither at \
                 the start nor at the end; move the object at least {} away from the obstacle",
                place(center),
                room(gap),
                length(wide),
                enough_length(wide - gap),
            ),
        })
    })
}

/// How far a point is from the edge of the area, and the nearest point there.
fn nearest_edge(scene: &Scene, p: Point) -> (f64, Point) {
    let (min, max) = (scene.area.min, scene.area.max);
    let feet = [
        (p.x - min.x, Point::new(min.x, p.y)),
        (max.x - p.x, Point::new(max.x, p.y)),
        (p.y - min.y, Point::new(p.x, min.y)),
        (max.y - p.y, Point::new(p.x, max.y)),
    ];
    feet.into_iter()
        .fold((f64::INFINITY, p), |a, b| if b.0 < a.0 { b } else { a })
}

/// Words for an object that no robot passes between it and the edge of the area.
fn at_edge(scene: &Scene, object: usize, gap: f64) -> Proof {
    let radius = scene.robot.radius;
    Proof {
        kind: ProofKind::ObjectAtEdge { object, gap },
        message: format!(
            "object {object} at {} cannot be swept: {} between its footprint circle and the edge of the area, where a robot's \
             center needs {} to pass, so both robots pass on the same side of it; move the object at least {} away from \
             the edge, or make the area larger",
            place(scene.objects[object].position),
            room(gap),
            length(radius),
            enough_length(radius - gap),
        ),
    }
}

/// Words for a gap.
fn room(gap: f64) -> String {
    if gap > 0.0 {
        format!("there is only {}", length(gap))
    } else {
        "there is no room".to_owned()
    }
}

/// True when every valid plan moves each point of the line between the robots forward at every instant: headings stay
/// within a right angle of the line's normal also between waypoints, and there is at least one inner waypoint.
fn always_forward(scene: &Scene) -> bool {
    let (planner, start, end) = (&scene.planner, scene.start, scene.end);
    let turn_of_line = 2.0 * libm::asin(planner.max_step / (2.0 * scene.robot.radius));
    let greatest_angle = planner.max_skew.abs() + 0.5 * planner.max_turn.abs() + turn_of_line;
    let farthest = start.left.position().distance(end.left.position());
    let farthest = farthest.max(start.right.position().distance(end.right.position()));
    // A NaN (a step longer than the separation) fails both comparisons' intent.
    greatest_angle < FRAC_PI_2 && farthest > planner.max_step + CAUTION
}

/// False for a disc of radius zero.
fn has_inside(things: &Things<'_>, thing: Thing) -> bool {
    let Thing::Obstacle(part) = thing else {
        return false;
    };
    let (segments, radius) = things.obstacles.outline(part);
    segments.iter().any(|s| s.length() > 0.0) || radius > CAUTION
}
