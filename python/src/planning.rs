//! Planning, one scene and many; planning again; checking.

use crate::batch::all;
use crate::errors::{bad_input, internal, plan_error};
use crate::options::{Given, options};
use crate::plan::Plan;
use crate::results::{Certificate, certificate_object};
use crate::scene::Scene;
use crate::scene_state::SceneState;
use crate::typed::{AnyDict, Progress};
use crate::work::{PlanWatch, watched};
use pairtrawl::{Candidate, PlanError, Planned, Planner};
use pyo3::inspect::PyStaticExpr;
use pyo3::prelude::*;
use pyo3::types::PyList;
use pyo3::{type_hint_identifier, type_hint_subscript, type_hint_union};
use std::convert::Infallible;
use std::sync::Arc;

fn made(
    py: Python<'_>,
    planned: Result<Planned, PlanError>,
    scene: Arc<SceneState>,
    given: &Given,
) -> PyResult<Plan> {
    match planned {
        Ok(planned) => Ok(Plan::of(
            planned.plan,
            planned.rehearsal,
            planned.stages,
            scene,
        )),
        Err(error) => Err(plan_error(py, error, &scene, given)),
    }
}

/// Plans a scene. `pairtrawl.plan` has the options by keyword.
#[pyfunction]
#[pyo3(signature = (scene, options, threads, progress))]
pub fn plan(
    py: Python<'_>,
    scene: &Scene,
    options: AnyDict<'_>,
    threads: Option<usize>,
    progress: Progress<'_>,
) -> PyResult<Plan> {
    let (state, given) = (scene.state(), self::options(&options.0)?);
    let planned = watched(py, threads, progress.callable(), |watch| {
        let loaded = &state.loaded;
        pairtrawl::plan(
            &loaded.scene,
            &loaded.reference,
            &given.plan,
            &mut PlanWatch(watch),
        )
    })?;
    made(py, planned, state, &given)
}

/// Plans a scene that has changed since `before` was planned, from the waypoint `passed` of it on.
#[pyfunction]
#[pyo3(signature = (before, scene, passed, options, threads, progress))]
pub fn replan(
    py: Python<'_>,
    before: &Plan,
    scene: &Scene,
    passed: usize,
    options: AnyDict<'_>,
    threads: Option<usize>,
    progress: Progress<'_>,
) -> PyResult<Plan> {
    let (state, given) = (scene.state(), self::options(&options.0)?);
    let planner = Planner::new(given.plan.clone());
    let planned = watched(py, threads, progress.callable(), |watch| {
        let loaded = &state.loaded;
        planner.replan(
            &before.plan,
            passed,
            &loaded.scene,
            &loaded.reference,
            &mut PlanWatch(watch),
        )
    })?;
    made(py, planned, state, &given)
}

/// Derives every claim anew, from the scene and the two trajectories alone.
#[pyfunction]
pub fn check<'py>(py: Python<'py>, scene: &Scene, plan: &Plan) -> PyResult<Certificate<'py>> {
    let state = scene.state();
    let certificate = watched(py, Some(1), None, |_| {
        let plan = &plan.plan;
        let candidate = Candidate {
            net_length: plan.net_length,
            trajectory: &plan.trajectory,
            scene: Some(&plan.scene),
            overrides: &plan.overrides,
            time_law: (!plan.time_law.is_empty()).then_some(&plan.time_law),
            left_out: &plan.left_out,
        };
        pairtrawl::check(&state.loaded.scene, &state.loaded.reference, &candidate)
    })?;
    certificate_object(py, &certificate)
}

/// Plans and the exceptions that stand for those that were not found, in order.
pub struct PlansAndErrors<'py>(Bound<'py, PyList>);

impl<'py> IntoPyObject<'py> for PlansAndErrors<'py> {
    type Target = PyList;
    type Output = Bound<'py, PyList>;
    type Error = Infallible;

    const OUTPUT_TYPE: PyStaticExpr = type_hint_subscript!(
        type_hint_identifier!("builtins", "list"),
        type_hint_union!(
            <Plan as pyo3::PyTypeInfo>::TYPE_HINT,
            type_hint_identifier!("pairtrawl.errors", "PairtrawlError")
        )
    );

    fn into_pyobject(self, _: Python<'py>) -> Result<Self::Output, Self::Error> {
        Ok(self.0)
    }
}

/// Plans scenes in parallel, each with its own options. The answers come in order, and each is the same, bit for bit, as if its
/// scene was planned alone.
#[pyfunction]
#[pyo3(signature = (scenes, options, threads, progress))]
pub fn plan_batch<'py>(
    py: Python<'py>,
    scenes: Vec<PyRef<'py, Scene>>,
    options: Vec<AnyDict<'py>>,
    threads: Option<usize>,
    progress: Progress<'py>,
) -> PyResult<PlansAndErrors<'py>> {
    if scenes.len() != options.len() {
        let words = format!(
            "there are {} scenes, but options for {}",
            scenes.len(),
            options.len()
        );
        return Err(bad_input(py, &words));
    }
    let options = options.iter().map(|options| self::options(&options.0));
    let given = options.collect::<PyResult<Vec<_>>>()?;
    let states: Vec<_> = scenes.iter().map(|scene| scene.state()).collect();
    let jobs: Vec<_> = states.iter().map(AsRef::as_ref).zip(&given).collect();
    let answers = watched(py, threads, progress.callable(), |watch| all(watch, &jobs))?;
    let results = PyList::empty(py);
    for (((answer, seconds), state), given) in answers.into_iter().zip(states).zip(&given) {
        let plan = match answer {
            Ok(planned) => made(py, planned, state, given),
            Err(words) => Err(internal(py, &words)),
        };
        match plan {
            Ok(plan) => results.append(plan)?,
            Err(error) => {
                error.value(py).setattr("seconds", seconds)?;
                results.append(error)?;
            }
        }
    }
    Ok(PlansAndErrors(results))
}

/// Panics, so that a test can see what becomes of it.
#[pyfunction]
pub fn _panic(py: Python<'_>, words: String) -> PyResult<()> {
    watched(py, Some(1), None, |_| panic!("{words}"))
}
