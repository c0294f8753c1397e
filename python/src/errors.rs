//! Errors of the library as exceptions of `pairtrawl.errors`, with everything that they know.

use crate::failure::Failure;
use crate::options::Given;
use crate::plan::Plan;
use crate::python_class::fields;
use crate::results::{claim_object, place, proof_object};
use crate::scene_state::SceneState;
use pairtrawl::files::FileError;
use pairtrawl::{NotFound, PlanError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyList, PyModule};
use std::sync::Arc;

static ERRORS: PyOnceLock<Py<PyModule>> = PyOnceLock::new();

/// An exception of a class of `pairtrawl.errors`.
fn exception<'py>(
    py: Python<'py>,
    class: &str,
    message: &str,
    keywords: &Bound<'py, PyDict>,
) -> PyErr {
    let made = ERRORS
        .get_or_try_init(py, || {
            PyModule::import(py, "pairtrawl.errors").map(Bound::unbind)
        })
        .and_then(|errors| errors.bind(py).getattr(class))
        .and_then(|class| class.call((message,), Some(keywords)));
    made.map_or_else(|error| error, PyErr::from_value)
}

/// A fault of the library.
pub fn internal(py: Python<'_>, message: &str) -> PyErr {
    exception(py, "InternalError", message, &PyDict::new(py))
}

/// An argument that cannot be used.
pub fn bad_input(py: Python<'_>, message: &str) -> PyErr {
    exception(py, "InputError", message, &PyDict::new(py))
}

/// A file that cannot be read or written, or does not say what it must. `named` is false for what never was a file.
pub fn file_error(py: Python<'_>, error: &FileError, named: bool) -> PyErr {
    let make = || {
        let details = PyDict::new(py);
        if !named {
            let message = error.problem.to_string();
            return Ok(exception(
                py,
                "InputError",
                &message,
                &fields!(py; details: details),
            ));
        }
        details.set_item("file", error.path.display().to_string())?;
        if let Some(line) = error.line {
            details.set_item("line", line)?;
        }
        let class = match error.is_from_system() {
            true => "FileAccessError",
            false => "InputError",
        };
        Ok(exception(
            py,
            class,
            &error.to_string(),
            &fields!(py; details: details),
        ))
    };
    make().unwrap_or_else(|error| error)
}

/// A search, a proof or a limit that ended without a plan.
pub fn plan_error(
    py: Python<'_>,
    error: PlanError,
    scene: &Arc<SceneState>,
    given: &Given,
) -> PyErr {
    planning_exception(py, error, scene, given).unwrap_or_else(|error| error)
}

fn planning_exception(
    py: Python<'_>,
    error: PlanError,
    scene: &Arc<SceneState>,
    given: &Given,
) -> PyResult<PyErr> {
    let message = error.to_string();
    let keywords = fields!(py; help: error.remedy(), details: PyDict::new(py));
    let class = match &error {
        PlanError::BadInput(_) => return Ok(exception(py, "InputError", &message, &keywords)),
        PlanError::Interrupted => {
            return Ok(pyo3::exceptions::PyKeyboardInterrupt::new_err(()));
        }
        PlanError::Infeasible(infeasible) => {
            let proofs = infeasible
                .proofs
                .iter()
                .map(|proof| proof_object(py, proof));
            let proofs = proofs.collect::<PyResult<Vec<_>>>()?;
            keywords.set_item("proofs", PyList::new(py, proofs)?)?;
            "InfeasibleError"
        }
        PlanError::TimeLimit { limit, stage } => {
            keywords.set_item("details", fields!(py; limit: *limit, stage: stage.name()))?;
            "TimeLimitError"
        }
        PlanError::NoPlan(not_found) => {
            search(py, &keywords, not_found, scene)?;
            "NoPlanError"
        }
    };
    let failure = Failure::new(error, Arc::clone(scene), given.plan.clone());
    keywords.set_item("failure", failure)?;
    Ok(exception(py, class, &message, &keywords))
}

/// What is known of a search that found nothing.
fn search(
    py: Python<'_>,
    keywords: &Bound<'_, PyDict>,
    not_found: &NotFound,
    scene: &Arc<SceneState>,
) -> PyResult<()> {
    let missing = &not_found.missing;
    let claim = missing.claim().map(|claim| claim_object(py, claim));
    keywords.set_item("claim", claim.transpose()?)?;
    keywords.set_item("place", missing.place().map(place))?;
    let tried = not_found.tried.iter();
    let tried = tried.map(|tried| (tried.start.clone(), tried.missing.to_string()));
    keywords.set_item("tried", tried.collect::<Vec<_>>())?;
    keywords.set_item("could_leave", not_found.could_leave.clone())?;
    let best = not_found.best.as_deref();
    let best = best.map(|best| Plan::of(best.clone(), None, Vec::new(), Arc::clone(scene)));
    keywords.set_item("best", best)
}
