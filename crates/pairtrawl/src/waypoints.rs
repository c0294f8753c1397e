use crate::PlanOptions;
use pairtrawl_model::Scene;

/// A proof that the fixed number of waypoints cannot do: no robot covers more than `max_step` in a step, so with N
/// waypoints none comes farther than (N - 1) max_step, not even on a straight line.
pub(crate) fn too_few(scene: &Scene, options: &PlanOptions) -> Option<String> {
    let waypoints = options.waypoints.or(scene.planner.waypoints)?;
    let max_step = scene.planner.max_step;
    let reach = waypoints.saturating_sub(1) as f64 * max_step;
    let robots = [
        ("left", scene.start.left, scene.end.left),
        ("right", scene.start.right, scene.end.right),
    ];
    robots.into_iter().find_map(|(name, start, end)| {
        let distance = start.position().distance(end.position());
        // Ends may be off by the certificate's 1e-6 m.
        (distance > reach + 1e-5).then(|| {
            let needed = (distance / max_step).ceil() as usize + 1;
            format!(
                "with {waypoints} waypoints and steps of at most {max_step} m a robot comes {reach:.3} m far, but the \
                 {name} robot's end is {distance:.3} m from its start: give at least {needed} waypoints"
            )
        })
    })
}
