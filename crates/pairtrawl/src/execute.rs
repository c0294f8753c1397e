//! Executing a plan: controllers drive both robots in the simulated world, several trials in parallel.

mod recording;

pub use pairtrawl_execution::*;
#[cfg(feature = "fs")]
pub use recording::write_recording;
pub use recording::{WriteRecordingError, recording};

use crate::check::without_left;
use pairtrawl_model::{Certificate, Claim, Execution, PairTrajectory, Plan, Scene, Warning};
use pairtrawl_reference::Reference;

/// Drives a plan in full physics, several trials in parallel on the current thread pool.
///
/// A drive that goes wrong is a result. When the observer interrupts, trials that are finished are kept and
/// `Execution::interrupted` is set. Results depend on the seed, not on the number of threads, but for `Trial::seconds`.
///
/// # Errors
/// When scene, plan or options cannot be used, and when a claim of the plan's certificate fails, unless the options allow it.
pub fn execute(
    scene: &Scene,
    plan: &Plan,
    options: &ExecutionOptions,
    observer: &dyn ExecutionObserver,
) -> Result<Execution, ExecutionError> {
    let claims = failed(&plan.certificate);
    if !options.unproven && !claims.is_empty() {
        return Err(ExecutionError::Unproven { claims });
    }
    let scene = &*without_left(scene, &plan.left_out);
    execute_trajectory(scene, plan.net_length, &plan.trajectory, options, observer)
}

/// Compares the control laws over many random runs of a plan: [`monte_carlo`] in the scene as the plan leaves it.
///
/// # Errors
/// When the trajectory or an option cannot be used.
pub fn compare_laws(
    scene: &Scene,
    plan: &Plan,
    options: &MonteCarloOptions,
    observer: &dyn ExecutionObserver,
) -> Result<MonteCarlo, ExecutionError> {
    let scene = &*without_left(scene, &plan.left_out);
    monte_carlo(scene, &plan.trajectory, options, observer)
}

/// As [`execute`], for a net length (m) and a trajectory from anywhere.
///
/// # Errors
/// When scene, trajectory or options cannot be used, and when a claim about the trajectory fails, unless the options allow it.
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
    let failed = failed(&reference_certificate);
    if !options.unproven && !failed.is_empty() {
        return Err(ExecutionError::Unproven { claims: failed });
    }
    let warnings = failed.iter().map(unproven_warning).collect();
    let task = Task {
        scene,
        net_length,
        trajectory,
        reference: &reference,
        options,
    };
    let host = Host {
        clock: &crate::clock::seconds,
        cost: &|driven| pairtrawl_trajopt::evaluate(scene, driven, net_length),
        observer,
    };
    let trials = drive_trials(&task, &host)?;
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

fn failed(certificate: &Certificate) -> Vec<Claim> {
    let failed = certificate.claims.iter().filter(|claim| !claim.holds);
    failed.cloned().collect()
}

fn unproven_warning(claim: &Claim) -> Warning {
    Warning::CurveFails {
        claim: claim.id,
        margin: claim.margin,
        detail: claim.detail.clone(),
    }
}
