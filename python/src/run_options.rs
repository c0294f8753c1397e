//! Options of driving by keyword.

use crate::errors::bad_input;
use pairtrawl::execute::{AdaptedParts, ExecutionOptions, NominalInertia};
use pairtrawl::model::ControllerKind;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// A number stands for itself, a pair for what is drawn between.
fn range(value: &Bound<'_, PyAny>) -> PyResult<[f64; 2]> {
    match value.extract::<f64>() {
        Ok(both) => Ok([both, both]),
        Err(_) => value.extract(),
    }
}

/// Reads keywords; None stands for the default. The library checks their ranges.
pub fn run_options(given: &Bound<'_, PyDict>) -> PyResult<ExecutionOptions> {
    let mut options = ExecutionOptions::default();
    for (key, value) in given {
        let key: String = key.extract()?;
        if value.is_none() {
            continue;
        }
        let kind = match key.as_str() {
            "robot_mass" | "robot_inertia" | "object_mass" | "friction" | "pose_delay"
            | "velocity_delay" | "odometry_scale" => "a number, or a pair: the lower first",
            "controller" => "\"mrac\", \"integral\" or \"model-based\"",
            "nominal_inertia" => "\"table\" or \"robot\"",
            "adapt" => "a list of \"state\", \"input\" and \"bias\", perhaps empty",
            "trials" | "seed" => "a whole number, 0 or more",
            "unproven" => "True or False",
            _ => "a number",
        };
        set(&mut options, &key, &value).map_err(|error| {
            if error.is_instance_of::<PyTypeError>(given.py())
                && error.to_string().contains("no option")
            {
                return error;
            }
            let shown = value
                .repr()
                .map_or_else(|_| "?".to_owned(), |shown| shown.to_string());
            bad_input(given.py(), &format!("{key} is {shown}, it must be {kind}"))
        })?;
    }
    Ok(options)
}

fn set(options: &mut ExecutionOptions, key: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
    match key {
        "controller" => {
            let name: String = value.extract()?;
            let kind = ControllerKind::ALL
                .into_iter()
                .find(|kind| kind.name() == name);
            options.controller = kind.ok_or_else(|| PyTypeError::new_err(name))?;
        }
        "nominal_inertia" => {
            options.nominal_inertia = match value.extract::<String>()?.as_str() {
                "table" => NominalInertia::PaperTable,
                "robot" => NominalInertia::Robot,
                other => return Err(PyTypeError::new_err(other.to_owned())),
            };
        }
        "trials" => options.trials = value.extract()?,
        "seed" => options.seed = value.extract()?,
        "robot_mass" => options.robot_mass = range(value)?,
        "robot_inertia" => options.robot_inertia = range(value)?,
        "object_mass" => options.object_mass = Some(range(value)?),
        "payload" => options.payload = Some(value.extract()?),
        "friction" => options.friction = range(value)?,
        "pose_delay" => options.pose_delay = range(value)?,
        "velocity_delay" => options.velocity_delay = range(value)?,
        "odometry_scale" => options.odometry_scale = range(value)?,
        "position_noise" => options.sensing.position_noise = value.extract()?,
        "heading_noise" => options.sensing.heading_noise = value.extract()?,
        "feedback" => options.law.feedback = value.extract()?,
        "rates" => options.law.rates = value.extract()?,
        "adapt" => options.law.adapts = adapted(&value.extract::<Vec<String>>()?)?,
        "torque_limit" => options.law.torque_limit = Some(value.extract()?),
        "stop_error" => options.supervisor.tracking_error = value.extract()?,
        "sample_interval" => options.sample_interval = value.extract()?,
        "unproven" => options.unproven = value.extract()?,
        _ => return Err(PyTypeError::new_err(format!("there is no option {key}"))),
    }
    Ok(())
}

/// What the adaptive law adapts, by name.
fn adapted(names: &[String]) -> PyResult<AdaptedParts> {
    let mut parts = AdaptedParts::NONE;
    for name in names {
        match name.as_str() {
            "state" => parts.state = true,
            "input" => parts.input = true,
            "bias" => parts.bias = true,
            other => return Err(PyTypeError::new_err(other.to_owned())),
        }
    }
    Ok(parts)
}
