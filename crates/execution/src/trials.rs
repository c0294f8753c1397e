use crate::{ExecutionError, Host, Task, trial};
use pairtrawl_model::Trial;
use pairtrawl_parallel::prelude::*;

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
