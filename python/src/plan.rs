//! The class `Plan`.

use crate::arrays::{Floats, Lazy};
use crate::errors::{bad_input, file_error};
use crate::pickle::{Reduced, reduce, restore};
use crate::plan_files::{in_folder, one_file};
use crate::plan_state::PlanState;
use crate::results::{
    Certificate, Circle, Cost, Curve, LeftOut, Rehearsal, Solver, Verdict, certificate_object,
    circle_object, cost_object, curve_object, left_out_object, rehearsal_object, solver_object,
    verdict_object,
};
use crate::scene::Scene;
use crate::scene_state::SceneState;
use crate::typed::AnyDict;
use pairtrawl::files::{FileError, plan_json, read_plan, sha256_hex};
use pairtrawl::model::{Plan as LibraryPlan, RehearsalRecord, SolverReport, StageTime, Summary};
use pairtrawl::{judge, report, summarize};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyModule};
use std::path::PathBuf;
use std::sync::Arc;

#[derive(Default)]
struct Arrays {
    left: Lazy,
    right: Lazy,
    times: Lazy,
    centerline: Lazy,
    baseline_left: Lazy,
    baseline_right: Lazy,
}

/// A planned run: what both robots drive, and how it came about.
///
/// Arrays are read-only and made once: two reads of `plan.left` give the same array, slices are views, and an array that is
/// kept outlives its plan. SI units, radians, map frame; left and right as seen by someone who walks behind the pair.
#[pyclass(frozen, module = "pairtrawl")]
pub struct Plan {
    /// The plan.
    pub plan: LibraryPlan,
    /// What happened in its rehearsal.
    pub record: Option<RehearsalRecord>,
    /// Seconds by stage.
    pub stages: Vec<StageTime>,
    /// The scene that it is for.
    pub scene: Arc<SceneState>,
    arrays: Arrays,
}

impl Plan {
    /// A plan of a scene.
    pub fn of(
        plan: LibraryPlan,
        record: Option<RehearsalRecord>,
        stages: Vec<StageTime>,
        scene: Arc<SceneState>,
    ) -> Self {
        let arrays = Arrays::default();
        Self {
            plan,
            record,
            stages,
            scene,
            arrays,
        }
    }

    /// The plan file.
    pub fn json(&self) -> String {
        // It never fails for a plan that fits into memory.
        plan_json(&self.plan).unwrap_or_default()
    }

    /// Everything that pictures and pages show.
    pub fn summary(&self) -> Summary {
        summarize(
            &self.scene.loaded.scene,
            &self.plan,
            &self.stages,
            self.record.as_ref(),
        )
    }

    /// The plan file without the seconds, the one number that differs between runs.
    fn same_bits(&self) -> String {
        let solver = SolverReport {
            seconds: 0.0,
            ..self.plan.solver.clone()
        };
        let plan = LibraryPlan {
            solver,
            ..self.plan.clone()
        };
        plan_json(&plan).unwrap_or_default()
    }
}

#[pymethods]
impl Plan {
    /// Reads a plan file, and judges it against a scene: its certificate and cost are derived anew.
    #[staticmethod]
    fn from_file(py: Python<'_>, path: PathBuf, scene: &Scene) -> PyResult<Self> {
        let state = scene.state();
        let judged = py.detach(|| {
            let file = read_plan(&path)?;
            Ok::<_, FileError>(judge(&state.loaded.scene, &state.loaded.reference, &file))
        });
        let plan = judged.map_err(|error| file_error(py, &error, true))?;
        Ok(Self::of(plan, None, Vec::new(), state))
    }

    /// Poses of the left robot, N x 3: x and y in m, heading in rad.
    #[getter]
    fn left(&self, py: Python<'_>) -> PyResult<Floats> {
        let poses = self.plan.trajectory.left.iter().copied();
        self.arrays.left.get(py, |py| Floats::poses(py, poses))
    }

    /// Poses of the right robot, N x 3; row i belongs to the same instant as row i of `left`.
    #[getter]
    fn right(&self, py: Python<'_>) -> PyResult<Floats> {
        let poses = self.plan.trajectory.right.iter().copied();
        self.arrays.right.get(py, |py| Floats::poses(py, poses))
    }

    /// When the pair passes each waypoint, N, s.
    #[getter]
    fn times(&self, py: Python<'_>) -> PyResult<Floats> {
        self.arrays
            .times
            .get(py, |py| Floats::list(py, self.plan.times()))
    }

    /// The pair's centerline, M x 3.
    #[getter]
    fn centerline(&self, py: Python<'_>) -> PyResult<Floats> {
        let poses = self.plan.centerline.iter().copied();
        self.arrays
            .centerline
            .get(py, |py| Floats::poses(py, poses))
    }

    /// What the optimization of the left robot started from, N x 3.
    #[getter]
    fn baseline_left(&self, py: Python<'_>) -> PyResult<Floats> {
        let poses = self.plan.baseline.left.iter().copied();
        self.arrays
            .baseline_left
            .get(py, |py| Floats::poses(py, poses))
    }

    /// What the optimization of the right robot started from, N x 3.
    #[getter]
    fn baseline_right(&self, py: Python<'_>) -> PyResult<Floats> {
        let poses = self.plan.baseline.right.iter().copied();
        self.arrays
            .baseline_right
            .get(py, |py| Floats::poses(py, poses))
    }

    /// Length of the net, d_max, m.
    #[getter]
    fn net_length(&self) -> f64 {
        self.plan.net_length
    }

    /// Time from one waypoint to the next where the file format is linear in time, s. The drive itself follows `times`.
    #[getter]
    fn step_time(&self) -> f64 {
        self.plan.trajectory.step_time
    }

    /// Time to drive, s.
    #[getter]
    fn duration(&self) -> f64 {
        self.plan.times().last().copied().unwrap_or(0.0)
    }

    /// Driven lengths of the left and the right robot, m.
    #[getter]
    fn path_lengths(&self) -> (f64, f64) {
        self.plan.trajectory.path_lengths()
    }

    /// J and its terms.
    #[getter]
    fn cost<'py>(&self, py: Python<'py>) -> PyResult<Cost<'py>> {
        cost_object(py, self.plan.cost)
    }

    /// The proof, claim by claim.
    #[getter]
    fn certificate<'py>(&self, py: Python<'py>) -> PyResult<Certificate<'py>> {
        certificate_object(py, &self.plan.certificate)
    }

    /// Circles around the objects; close ones share one.
    #[getter]
    fn circles<'py>(&self, py: Python<'py>) -> PyResult<Vec<Circle<'py>>> {
        self.plan
            .circles
            .iter()
            .map(|circle| circle_object(py, circle))
            .collect()
    }

    /// Visiting order: indices into `circles`.
    #[getter]
    fn order(&self) -> Vec<usize> {
        self.plan.order.clone()
    }

    /// Objects that stay where they are, and why.
    #[getter]
    fn left_out<'py>(&self, py: Python<'py>) -> PyResult<Vec<LeftOut<'py>>> {
        self.plan
            .left_out
            .iter()
            .map(|left| left_out_object(py, left))
            .collect()
    }

    /// What the rehearsal in physics said. Never a proof.
    #[getter]
    fn rehearsal<'py>(&self, py: Python<'py>) -> PyResult<Verdict<'py>> {
        verdict_object(py, &self.plan.rehearsal)
    }

    /// The rehearsal in full, with robots, net and objects over time; None when there was none.
    #[getter]
    fn rehearsal_record<'py>(&self, py: Python<'py>) -> PyResult<Option<Rehearsal<'py>>> {
        let record = self.record.as_ref();
        record
            .map(|record| rehearsal_object(py, record))
            .transpose()
    }

    /// How the optimization ended.
    #[getter]
    fn solver<'py>(&self, py: Python<'py>) -> PyResult<Solver<'py>> {
        solver_object(py, &self.plan.solver)
    }

    /// What a person should know about the plan.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.plan.warnings.iter().map(ToString::to_string).collect()
    }

    /// Seconds by stage of planning.
    #[getter]
    fn stages<'py>(&self, py: Python<'py>) -> PyResult<AnyDict<'py>> {
        let stages = PyDict::new(py);
        for stage in &self.stages {
            stages.set_item(&stage.name, stage.seconds)?;
        }
        Ok(AnyDict(stages))
    }

    /// The scene as it was planned for.
    #[getter]
    fn scene(&self) -> Scene {
        Scene::of(Arc::clone(&self.scene))
    }

    /// SHA-256 of everything that the plan file says but the seconds: two plans with the same digest are the same, bit for bit.
    #[getter]
    fn digest(&self) -> String {
        sha256_hex(&[self.same_bits().as_bytes()])
    }

    /// Everything over time that reports show, such as separation and clearance, by key.
    fn curves<'py>(&self, py: Python<'py>) -> PyResult<Vec<Curve<'py>>> {
        let summary = py.detach(|| self.summary());
        summary
            .panels
            .iter()
            .map(|panel| curve_object(py, panel))
            .collect()
    }

    /// When the line between the robots first sweeps each object, s; None where it does not.
    fn swept_at(&self, py: Python<'_>) -> Vec<Option<f64>> {
        py.detach(|| self.summary()).swept_at
    }

    /// The last waypoint that a pair which keeps to the plan has passed `time` s after it set out.
    fn waypoint_at(&self, time: f64) -> usize {
        self.plan.waypoint_at(time)
    }

    /// The plan file as a dictionary.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<AnyDict<'py>> {
        let loads = PyModule::import(py, "json")?.getattr("loads")?;
        Ok(AnyDict(loads.call1((self.json(),))?.cast_into::<PyDict>()?))
    }

    /// The text of the plan file, format pairtrawl-plan/1.
    fn to_json(&self) -> String {
        self.json()
    }

    /// Writes the plan. The ending says what: .json the plan file, .csv the smooth curve that is driven, .svg the map, .html the
    /// report. A path without an ending is a folder that gets all of them, as from the program.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let written = py.detach(
            || match path.extension().and_then(|ending| ending.to_str()) {
                None => in_folder(self, &path),
                Some(ending) => one_file(self, &path, ending),
            },
        );
        written.map_err(|error| error.into_exception(py))
    }

    /// The map with the plan, as SVG.
    fn svg(&self, py: Python<'_>) -> String {
        py.detach(|| report::plan_svg(&self.summary()))
    }

    fn _repr_html_(&self, py: Python<'_>) -> String {
        self.svg(py)
    }

    fn __len__(&self) -> usize {
        self.plan.trajectory.len()
    }

    fn __repr__(&self) -> String {
        let plan = &self.plan;
        let verdict = match plan.certificate.is_valid() {
            true => "proven",
            false => "not proven",
        };
        format!(
            "<Plan of {:?}: {} waypoints, net {:.3} m, J {:.1}, {verdict}>",
            plan.scene.name,
            plan.trajectory.len(),
            plan.net_length,
            plan.cost.total()
        )
    }

    /// True when two plans say the same, bit for bit, but for the seconds.
    fn __eq__(&self, other: PyRef<'_, Self>) -> bool {
        self.plan.trajectory == other.plan.trajectory && self.same_bits() == other.same_bits()
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        reduce(py, "_restore_plan", &PlanState::of(self))
    }
}

/// A plan of its pickle.
#[pyfunction]
pub fn _restore_plan(py: Python<'_>, state: &[u8]) -> PyResult<Plan> {
    let state: PlanState = restore(py, state)?;
    state.into_plan().map_err(|words| bad_input(py, &words))
}
