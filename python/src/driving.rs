//! Rehearsing a plan in physics, and driving it by controllers.

use crate::errors::{bad_input, file_error};
use crate::plan::Plan;
use crate::python_class::{fields, python_class};
use crate::results::{Rehearsal, cost_object, event_object, frames_into, rehearsal_object};
use crate::run_files::write_run;
use crate::run_options::run_options;
use crate::samples::samples_into;
use crate::scene::Scene;
use crate::typed::{AnyDict, Progress};
use crate::work::watched;
use pairtrawl::execute::{execute, rehearse_while};
use pairtrawl::files::execution_json;
use pairtrawl::model::Trial as LibraryTrial;
use pairtrawl::reference::Reference;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::path::PathBuf;

python_class!(
    /// Drives of a plan.
    Execution
);
python_class!(
    /// One drive.
    Trial
);

/// Drives the smooth curve of a plan in physics, closely, and says whether the plan is at fault for anything. It is no proof.
#[pyfunction]
#[pyo3(signature = (scene, plan, *, time_step=None, frame_interval=None))]
pub fn rehearse<'py>(
    py: Python<'py>,
    scene: &Scene,
    plan: &Plan,
    time_step: Option<f64>,
    frame_interval: Option<f64>,
) -> PyResult<Rehearsal<'py>> {
    let state = scene.state();
    let mut options = pairtrawl::simulation::Options::default();
    for (name, given, option) in [
        ("time_step", time_step, &mut options.time_step),
        (
            "frame_interval",
            frame_interval,
            &mut options.frame_interval,
        ),
    ] {
        match given {
            Some(given) if given > 0.0 && given.is_finite() => *option = given,
            Some(given) => {
                return Err(bad_input(
                    py,
                    &format!("{name} is {given}, it must be a number of seconds above 0"),
                ));
            }
            None => {}
        }
    }
    let record = watched(py, Some(1), None, |watch| {
        let left = plan.plan.left_out.iter().map(|left| left.object);
        let scene = state.loaded.scene.leaving(left);
        let trajectory = &plan.plan.trajectory;
        let reference = Reference::of_scene(&scene, trajectory).map_err(|e| e.to_string())?;
        let net_length = plan.plan.net_length;
        let may_go_on = || !watch.is_stopped();
        rehearse_while(&scene, net_length, &reference, &options, &may_go_on)
            .map_err(|e| e.to_string())
    })?;
    rehearsal_object(
        py,
        &record.map_err(|error| bad_input(py, &error.to_string()))?,
    )
}

/// Lets controllers drive a plan in physics, several trials in parallel. `pairtrawl.run` has the options by keyword.
#[pyfunction]
#[pyo3(signature = (scene, plan, options, output, threads, progress))]
pub fn run<'py>(
    py: Python<'py>,
    scene: &Scene,
    plan: &Plan,
    options: AnyDict<'py>,
    output: Option<PathBuf>,
    threads: Option<usize>,
    progress: Progress<'py>,
) -> PyResult<Execution<'py>> {
    let (state, options) = (scene.state(), run_options(&options.0)?);
    let loaded = &state.loaded;
    let executed = watched(py, threads, progress.callable(), |watch| {
        execute(&loaded.scene, &plan.plan, &options, watch)
    })?;
    let execution = executed.map_err(|error| bad_input(py, &error.to_string()))?;
    if let Some(folder) = output {
        let written = py.detach(|| write_run(&folder, loaded, &plan.plan, &options, &execution));
        written.map_err(|error| match error {
            Ok(file) => file_error(py, &file, true),
            Err(words) => bad_input(py, &words),
        })?;
    }
    let trials = execution.trials.iter().map(|trial| trial_object(py, trial));
    let warnings: Vec<String> = execution.warnings.iter().map(ToString::to_string).collect();
    let fields = fields!(py; controller: execution.controller.name(), net_length: execution.net_length,
        reference_duration: execution.reference_duration, trials_wanted: execution.trials_wanted,
        interrupted: execution.interrupted, gathered_everything: execution.gathered_everything(),
        trials: PyTuple::new(py, trials.collect::<PyResult<Vec<_>>>()?)?,
        warnings: PyTuple::new(py, warnings)?,
        json: execution_json(&execution, &options, &loaded.reference));
    Execution::make(py, &fields)
}

fn trial_object<'py>(py: Python<'py>, trial: &LibraryTrial) -> PyResult<Trial<'py>> {
    let events = trial.events.iter();
    let events =
        events.map(|event| event_object(py, event.time, event.place, &event.kind.describe()));
    let tracking = trial
        .tracking
        .map(|robot| (robot.rms, robot.max, robot.settled_rms, robot.settled_max));
    let pair = |[left, right]: [f64; 2]| (left, right);
    let conditions = &trial.conditions;
    let conditions = fields!(py; robot_mass_factor: conditions.robot_mass_factor,
        robot_inertia_factor: conditions.robot_inertia_factor, object_masses: conditions.object_masses.clone(),
        friction_factor: conditions.friction_factor, pose_delay: conditions.pose_delay,
        velocity_delay: conditions.velocity_delay, odometry_scale: pair(conditions.odometry_scale));
    let fields = fields!(py; index: trial.index, seed: trial.seed, conditions: conditions,
        gathered: PyTuple::new(py, &trial.gathered)?, left_out: PyTuple::new(py, &trial.left)?,
        gathered_everything: trial.gathered_everything(),
        events: PyTuple::new(py, events.collect::<PyResult<Vec<_>>>()?)?,
        tracking_rms: pair(tracking.map(|(rms, ..)| rms)), tracking_max: pair(tracking.map(|(_, max, ..)| max)),
        settled_rms: pair(tracking.map(|(_, _, rms, _)| rms)), settled_max: pair(tracking.map(|(.., max)| max)),
        cost: cost_object(py, trial.cost)?, mean_drag: pair(trial.drag.map(|drag| drag.mean)),
        max_drag: pair(trial.drag.map(|drag| drag.max)), max_torque: pair(trial.max_torque),
        duration: trial.duration, seconds: trial.seconds);
    frames_into(&fields, &trial.frames)?;
    samples_into(&fields, &trial.samples)?;
    Trial::make(py, &fields)
}
