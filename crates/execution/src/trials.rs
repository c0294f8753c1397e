use crate::{ExecutionError, ExecutionObserver, ExecutionOptions, trial};
use pairtrawl_model::{Cost, PairTrajectory, Scene, Trial};
use pairtrawl_parallel::prelude::*;
use pairtrawl_reference::Reference;

/// What is driven, and how.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    /// The world; trials change what their conditions say.
    pub scene: &'a Scene,
    /// d_max, m.
    pub net_length: f64,
    /// The plan's waypoints.
    pub trajectory: &'a PairTrajectory,
    /// The plan's reference.
    pub reference: &'a Reference,
    /// How it is driven.
    pub options: &'a ExecutionOptions,
}

/// What the caller brings along.
#[derive(Clone, Copy)]
pub struct Host<'a> {
    /// Seconds since some instant; only `Trial::seconds` comes from it.
    pub clock: &'a (dyn Fn() -> f64 + Sync),
    /// J of a driven path.
    pub cost: &'a (dyn Fn(&PairTrajectory) -> Cost + Sync),
    /// Watches, and may stop.
    pub observer: &'a dyn ExecutionObserver,
}

/// Drives a plan in full physics, several trials in parallel on the current thread pool.
///
/// A drive that goes wrong is a result. When the observer interrupts, fewer trials come back than the options ask for: those
/// that are finished, in the order of their index.
///
/// # Errors
/// When scene or options cannot be used.
pub fn drive_trials(task: &Task, host: &Host) -> Result<Vec<Trial>, ExecutionError> {
    task.options.validate()?;
    let trials = (0..task.options.trials)
        .into_par_iter()
        .map(|index| {
            if host.observer.interrupted() {
                return Ok(None);
            }
            let trial = trial::run(task, host, index)?;
            if trial.is_some() {
                host.observer.finished(index);
            }
            Ok(trial)
        })
        .collect::<Result<Vec<Option<Trial>>, ExecutionError>>()?;
    Ok(trials.into_iter().flatten().collect())
}
