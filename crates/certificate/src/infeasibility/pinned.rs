use super::least_move::{advice, least_move};
use super::proof::{Proof, ProofKind};
use super::things::Things;
use crate::limits::CAUTION;
use crate::obstacles::Part;
use pairtrawl_geometry::{Point, Segment};
use pairtrawl_model::Scene;
use pairtrawl_model::numbers::{length, place};
use std::f64::consts::FRAC_PI_2;

/// The objects closer to an obstacle than two robot radii, or closer to the edge of the area than one, where neither the
/// first nor the last line passes between.
pub(super) fn prove<'a>(things: &'a Things<'_>) -> impl Iterator<Item = Proof> + 'a {
    let objects = &things.scene.objects;
    let wanted = (0..objects.len()).filter(|&i| !objects[i].leave);
    wanted.filter_map(|object| about(things, object))
}

/// The proof about one object.
pub(super) fn about(things: &Things<'_>, object: usize) -> Option<Proof> {
    let scene = things.scene;
    if !always_forward(things) {
        return None;
    }
    let center = scene.objects[object].position;
    let pin = pin(things, object, center)?;
    let least_move = least_move(things, object, |p| pin_at(things, object, p).is_none());
    let advice = advice(least_move);
    let (gap, foot) = (pin.gap, pin.foot);
    let wide = things.gap_to_pass(scene.objects[object].footprint_radius());
    let head = format!(
        "object {object} at {} cannot be swept: {} between its footprint circle and",
        place(center),
        room(gap)
    );
    let (kind, message) = match pin.part {
        None => (
            ProofKind::ObjectAtEdge {
                object,
                foot,
                gap,
                needed: things.keep,
            },
            format!(
                "{head} the edge of the area, where a robot's center needs {} to pass, so both robots pass on the same \
                 side of it; {advice}, or make the area larger",
                length(things.keep),
            ),
        ),
        Some(part) => (
            ProofKind::ObjectPinned {
                object,
                foot,
                gap,
                needed: wide,
            },
            format!(
                "{head} {part}, where a robot needs {} to pass, so both robots pass on the same side of it, and the line \
                 between them passes there neither at the start nor at the end; {advice}",
                length(wide),
            ),
        ),
    };
    Some(Proof {
        kind,
        message,
        least_move,
    })
}

/// True when nothing pins an object that lies at a place instead.
pub(super) fn is_free(things: &Things<'_>, object: usize, p: Point) -> bool {
    !always_forward(things) || pin_at(things, object, p).is_none()
}

/// What holds an object.
struct Pin {
    /// The obstacle; `None`: the edge of the area.
    part: Option<Part>,
    /// Its nearest point.
    foot: Point,
    /// Distance between it and the footprint circle, m.
    gap: f64,
}

/// What pins an object where it lies: the edge of the area, or the first obstacle that does.
fn pin(things: &Things<'_>, object: usize, center: Point) -> Option<Pin> {
    if things.obstacles.distance(center, CAUTION).is_some() {
        return None; // The object is in an obstacle: bad input.
    }
    pin_at(things, object, center)
}

/// What pins an object that lies at a place.
fn pin_at(things: &Things<'_>, object: usize, center: Point) -> Option<Pin> {
    let scene = things.scene;
    let rho = scene.objects[object].footprint_radius();
    let wide = things.gap_to_pass(rho);
    let lines = [scene.start, scene.end]
        .map(|pair| Segment::new(pair.left.position(), pair.right.position()));
    let passes = |foot: Point| {
        let shortest = Segment::new(center, foot);
        (lines.iter()).any(|line| line.gap_to_segment(&shortest).distance <= CAUTION)
    };
    let (to_edge, foot) = nearest_edge(scene, center);
    let gap = to_edge - rho;
    if gap < things.keep - CAUTION && to_edge > 0.0 && !passes(foot) {
        return Some(Pin {
            part: None,
            foot,
            gap,
        });
    }
    let near = things.obstacles.distances(center, wide + rho - CAUTION);
    near.into_iter().find_map(|(distance, part)| {
        // An obstacle without inside proves nothing.
        if distance <= 0.0 || !has_inside(things, part) {
            return None;
        }
        let foot = things.nearest_point_of(part, center);
        (!passes(foot)).then_some(Pin {
            part: Some(part),
            foot,
            gap: distance - rho,
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
fn always_forward(things: &Things<'_>) -> bool {
    let scene = things.scene;
    let (planner, start, end) = (&scene.planner, scene.start, scene.end);
    let turn_of_line = 2.0 * libm::asin(planner.max_step / (2.0 * things.keep));
    let greatest_angle = planner.max_skew.abs() + 0.5 * planner.max_turn.abs() + turn_of_line;
    let farthest = start.left.position().distance(end.left.position());
    let farthest = farthest.max(start.right.position().distance(end.right.position()));
    // A NaN (a step longer than the separation) fails both comparisons' intent.
    greatest_angle < FRAC_PI_2 && farthest > planner.max_step + CAUTION
}

/// False for a disc of radius zero.
fn has_inside(things: &Things<'_>, part: Part) -> bool {
    let (segments, radius) = things.obstacles.outline(part);
    segments.iter().any(|s| s.length() > 0.0) || radius > CAUTION
}
