//! Drives of plans by control laws, and what is read off them.

use crate::lab::{Lab, Stopped};
use pairtrawl::execute::{ExecutionOptions, execute_trajectory};
use pairtrawl::geometry::Polygon;
use pairtrawl::model::{
    ExecutionEventKind, PairTrajectory, RehearsalEventKind, RehearsalFrame, Scene, Trial,
};

/// A robot this far from its reference is lost: the default limit of the supervisor, m.
pub const LOST: f64 = 0.25;
/// A limit that no drive reaches, m or N: drives go on when robots are lost, as the paper's did.
pub const UNLIMITED: f64 = 1e3;

/// Drives a trajectory (net in m) and returns all trials.
///
/// # Errors
/// When it cannot be driven, or the host stops it.
pub fn drive(
    lab: &Lab,
    scene: &Scene,
    (trajectory, net_length): (&PairTrajectory, f64),
    options: &ExecutionOptions,
) -> Result<Vec<Trial>, Stopped> {
    let watch = lab.watch();
    let execution = execute_trajectory(scene, net_length, trajectory, options, &watch)
        .map_err(|error| Stopped::failed(&scene.name, error))?;
    match execution.interrupted {
        true => Err(Stopped::Interrupted),
        false => Ok(execution.trials),
    }
}

/// When a robot was first [`LOST`], s.
pub fn lost_at(trial: &Trial) -> Option<f64> {
    let lost = |error: &[f64; 2]| error[0].max(error[1]) > LOST;
    let sample = trial.samples.iter().find(|s| lost(&s.error));
    sample.map(|s| s.time)
}

/// The first collision: of the robots with each other, an obstacle or an object from outside. In words, and when, s.
pub fn first_collision(trial: &Trial) -> Option<(String, f64)> {
    let event = trial.events.iter().find(|event| {
        matches!(
            event.kind,
            ExecutionEventKind::Physical(
                RehearsalEventKind::RobotsTouch
                    | RehearsalEventKind::RobotTouchesObject { .. }
                    | RehearsalEventKind::RobotTouchesObstacle { .. }
            )
        )
    })?;
    Some((event.kind.describe(), event.time))
}

/// How many objects are inside the net in the last frame before a time, s.
pub fn in_the_net(trial: &Trial, time: f64) -> usize {
    let after = trial.frames.partition_point(|frame| frame.time <= time);
    let Some(frame) = trial.frames.get(after.saturating_sub(1)) else {
        return 0;
    };
    count_inside(frame)
}

fn count_inside(frame: &RehearsalFrame) -> usize {
    let region = Polygon::new(frame.net.clone());
    let inside = |o: &&pairtrawl::geometry::Pose| region.contains(o.position());
    frame.objects.iter().filter(inside).count()
}

/// Root mean square and greatest error of the worse robot after the first second, m.
pub fn errors(trial: &Trial) -> (f64, f64) {
    let [left, right] = &trial.tracking;
    (
        left.settled_rms.max(right.settled_rms),
        left.settled_max.max(right.settled_max),
    )
}
