use super::proof::{Proof, ProofKind};
use crate::limits::CAUTION;
use pairtrawl_model::{Scene, Side, numbers};

/// Looks for a proof that a given number of waypoints cannot do: no robot covers more than `max_step` in a step, so that
/// with N waypoints none comes farther than (N - 1) max_step, not even on a straight line.
pub fn too_few_waypoints(scene: &Scene, waypoints: usize) -> Option<Proof> {
    let max_step = scene.planner.max_step;
    let reach = waypoints.saturating_sub(1) as f64 * max_step;
    Side::BOTH.into_iter().find_map(|side| {
        let (start, end) = (scene.start.robot(side), scene.end.robot(side));
        let distance = start.position().distance(end.position());
        (distance > reach + CAUTION).then(|| {
            let needed = (distance / max_step).ceil() as usize + 1;
            let kind = ProofKind::TooFewWaypoints {
                waypoints,
                robot: side,
                distance,
                needed,
            };
            let [max_step, reach, distance] = [max_step, reach, distance].map(numbers::length);
            Proof {
                kind,
                least_move: None,
                message: format!(
                    "with {waypoints} waypoints and steps of at most {max_step} a robot comes {reach} far, but the end of \
                     the {side} is {distance} from its start: give at least {needed} waypoints"
                ),
            }
        })
    })
}
