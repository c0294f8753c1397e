//! Executing a plan: controllers drive both robots in the simulated world, several trials in parallel.

mod collector;
mod control_loop;
mod error;
mod monte_carlo;
mod observer;
mod options;
mod plant;
mod recording;
mod reduced_run;
mod sensing;
mod statistics;
mod trial;

pub use control_loop::{PairLoop, Truth};
pub use error::ExecutionError;
pub use monte_carlo::{GrowingDrag, MonteCarlo, MonteCarloOptions, MonteCarloRow, monte_carlo};
pub use observer::ExecutionObserver;
pub use options::{ExecutionOptions, NominalInertia, controller_parameters};
pub use plant::{Drag, PlantParameters, ReducedPlant};
pub use recording::{WriteRecordingError, recording, write_recording};
pub use reduced_run::{ReducedOutcome, ReducedRun};
pub use sensing::{Normal, Sensing, Sensors, TORQUE_PERIOD, TRACKER_TICKS};
pub use statistics::{mixed_seed, quantile};

use crate::reference::Reference;
use pairtrawl_model::{Execution, PairTrajectory, Plan, Scene, Trial};
use rayon::prelude::*;
use trial::Course;

/// Drives a plan in full physics, several trials in parallel on the current thread pool.
///
/// A drive that goes wrong is a result. When the observer interrupts, trials that are finished are kept and
/// `Execution::interrupted` is set. Results depend on the seed, not on the number of threads, but for `Trial::seconds`.
///
/// # Errors
/// When scene, plan or options cannot be used.
pub fn execute(
    scene: &Scene,
    plan: &Plan,
    options: &ExecutionOptions,
    observer: &dyn ExecutionObserver,
) -> Result<Execution, ExecutionError> {
    execute_trajectory(scene, plan.net_length, &plan.trajectory, options, observer)
}

/// As [`execute`], for a net length (m) and a trajectory from anywhere.
///
/// # Errors
/// When scene, trajectory or options cannot be used.
pub fn execute_trajectory(
    scene: &Scene,
    net_length: f64,
    trajectory: &PairTrajectory,
    options: &ExecutionOptions,
    observer: &dyn ExecutionObserver,
) -> Result<Execution, ExecutionError> {
    options.validate()?;
    let reference = Reference::of_scene(scene, trajectory)?;
    let reference_certificate =
        pairtrawl_certificate::certify(scene, net_length, trajectory, Some(&reference));
    let warnings = reference_certificate
        .claims
        .iter()
        .filter(|claim| !claim.holds)
        .map(|claim| {
            let (name, margin) = (claim.id, claim.margin);
            format!(
                "on the smooth reference the claim {name} misses by {:.6}: {}",
                -margin, claim.detail
            )
        })
        .collect();
    let course = Course {
        scene,
        net_length,
        trajectory,
        reference: &reference,
        options,
    };
    let trials = (0..options.trials)
        .into_par_iter()
        .map(|index| {
            if observer.interrupted() {
                return Ok(None);
            }
            let trial = trial::run(&course, index, observer)?;
            if trial.is_some() {
                observer.finished(index);
            }
            Ok(trial)
        })
        .collect::<Result<Vec<Option<Trial>>, ExecutionError>>()?;
    let trials: Vec<Trial> = trials.into_iter().flatten().collect();
    Ok(Execution {
        controller: options.controller,
        net_length,
        reference_duration: reference.duration(),
        reference_certificate,
        interrupted: trials.len() < options.trials,
        trials,
        trials_wanted: options.trials,
        warnings,
    })
}
