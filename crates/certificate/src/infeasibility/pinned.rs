use super::things::{Thing, Things};
use super::{CAUTION, Proof, ProofKind, rounded_up};
use pairtrawl_geometry::{Point, Segment};
use pairtrawl_model::{PairPose, Scene};
use std::f64::consts::FRAC_PI_2;

/// An object closer to an obstacle than two robot radii, and neither the first nor the last line passes between.
pub(super) fn prove(things: &Things<'_>) -> Option<Proof> {
    let scene = things.scene;
    if !always_forward(scene) {
        return None;
    }
    let line = |pair: PairPose| Segment::new(pair.left.position(), pair.right.position());
    let lines = [line(scene.start), line(scene.end)];
    let wide = 2.0 * scene.robot.radius;
    scene.objects.iter().enumerate().find_map(|(i, object)| {
        let (center, rho) = (object.position, object.footprint_radius());
        let near = things.obstacles.distances(center, wide + rho - CAUTION);
        near.into_iter().find_map(|(distance, part)| {
            if distance <= 0.0 || !has_inside(things, Thing::Obstacle(part)) {
                return None; // The object is inside the obstacle: bad input. An obstacle without inside proves nothing.
            }
            let foot = things.nearest_point(Thing::Obstacle(part), center);
            let shortest = Segment::new(center, foot);
            if lines.iter().any(|line| line.gap_to_segment(&shortest).distance <= CAUTION) {
                return None;
            }
            let gap = distance - rho;
            let Point { x, y } = center;
            Some(Proof {
                kind: ProofKind::ObjectPinned { object: i, gap },
                message: format!(
                    "object {i} at ({x:.3}, {y:.3}) cannot be swept: {} between its footprint circle and {part}, where a \
                     robot needs {wide:.3} m to pass, so both robots pass on the same side of it, and the line between \
                     them passes there neither at the start nor at the end; move the object at least {:.3} m away \
                     from the obstacle",
                    if gap > 0.0 { format!("there is only {gap:.3} m") } else { "there is no room".to_owned() },
                    rounded_up(wide - gap),
                ),
            })
        })
    })
}

/// True when every valid plan moves each point of the line between the robots forward at every instant: headings stay
/// within a right angle of the line's normal also between waypoints, and there is at least one inner waypoint.
fn always_forward(scene: &Scene) -> bool {
    let (planner, start, end) = (&scene.planner, scene.start, scene.end);
    let turn_of_line = 2.0 * (planner.max_step / (2.0 * scene.robot.radius)).asin();
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
