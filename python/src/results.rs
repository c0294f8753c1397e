//! The library's results as objects of `pairtrawl.results`.

use crate::arrays::Floats;
use crate::python_class::{fields, python_class};
use pairtrawl::certificate::infeasibility::Proof as LibraryProof;
use pairtrawl::geometry::Point;
use pairtrawl::model::{
    self, Certificate as LibraryCertificate, PairPose, Panel, Rehearsal as LibraryVerdict,
    RehearsalFrame, RehearsalRecord, Role,
};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

python_class!(
    /// J and its terms.
    Cost
);
python_class!(
    /// One claim.
    Claim
);
python_class!(
    /// All claims.
    Certificate
);
python_class!(
    /// What a rehearsal said.
    Verdict
);
python_class!(
    /// What happened in a rehearsal.
    Rehearsal
);
python_class!(
    /// How the optimization ended.
    Solver
);
python_class!(
    /// A circle around objects.
    Circle
);
python_class!(
    /// An object that is left.
    LeftOut
);
python_class!(
    /// A proof that there is no plan.
    Proof
);
python_class!(
    /// A quantity over time.
    Curve
);
python_class!(
    /// Something that should not have happened.
    Event
);

/// A point as Python sees it.
pub fn place(point: Point) -> (f64, f64) {
    (point.x, point.y)
}

/// J and its terms.
pub fn cost_object(py: Python<'_>, cost: model::Cost) -> PyResult<Cost<'_>> {
    let fields = fields!(py; total: cost.total(), smoothness: cost.smoothness, distance: cost.distance,
        obstacle: cost.obstacle, expansion: cost.expansion);
    Cost::make(py, &fields)
}

/// One claim.
pub fn claim_object<'py>(py: Python<'py>, claim: &model::Claim) -> PyResult<Claim<'py>> {
    let fields = fields!(py; name: claim.id.name(), holds: claim.holds, margin: claim.margin, unit: claim.id.unit(),
        meaning: claim.id.meaning(), step: claim.step, place: claim.place.map(place), detail: &claim.detail);
    Claim::make(py, &fields)
}

/// All claims.
pub fn certificate_object<'py>(
    py: Python<'py>,
    certificate: &LibraryCertificate,
) -> PyResult<Certificate<'py>> {
    let claims = certificate
        .claims
        .iter()
        .map(|claim| claim_object(py, claim));
    let claims = PyTuple::new(py, claims.collect::<PyResult<Vec<_>>>()?)?;
    Certificate::make(py, &fields!(py; claims: claims))
}

/// What a rehearsal said.
pub fn verdict_object<'py>(py: Python<'py>, verdict: &LibraryVerdict) -> PyResult<Verdict<'py>> {
    let none = || (None, None, None);
    let (status, (event, time, at)) = match verdict {
        LibraryVerdict::Passed => ("passed", none()),
        LibraryVerdict::Skipped => ("skipped", none()),
        LibraryVerdict::Failed {
            event,
            time,
            place: at,
        } => (
            "failed",
            (Some(event.as_str()), Some(*time), Some(place(*at))),
        ),
    };
    Verdict::make(
        py,
        &fields!(py; status: status, event: event, time: time, place: at),
    )
}

/// How the optimization ended.
pub fn solver_object<'py>(py: Python<'py>, solver: &model::SolverReport) -> PyResult<Solver<'py>> {
    let fields = fields!(py; status: solver.status.name(), iterations: solver.iterations,
        kkt_error: solver.kkt_error, seconds: solver.seconds);
    Solver::make(py, &fields)
}

/// A circle around objects.
pub fn circle_object<'py>(py: Python<'py>, circle: &model::Circle) -> PyResult<Circle<'py>> {
    let fields = fields!(py; center: place(circle.center), radius: circle.radius,
        objects: PyTuple::new(py, &circle.objects)?);
    Circle::make(py, &fields)
}

/// An object that is left.
pub fn left_out_object<'py>(py: Python<'py>, left: &model::LeftOut) -> PyResult<LeftOut<'py>> {
    LeftOut::make(
        py,
        &fields!(py; object: left.object, why: left.why.name(), text: &left.text),
    )
}

/// A proof that there is no plan, or none that gathers an object.
pub fn proof_object<'py>(py: Python<'py>, proof: &LibraryProof) -> PyResult<Proof<'py>> {
    let least = proof.least_move;
    let fields = fields!(py; kind: proof.kind.name(), object: proof.object(), text: &proof.message,
        move_to: least.map(|least| place(least.to)), move_distance: least.map(|least| least.distance));
    Proof::make(py, &fields)
}

/// A quantity over time; values of steps stand at the middle of their steps.
pub fn curve_object<'py>(py: Python<'py>, panel: &Panel) -> PyResult<Curve<'py>> {
    let lines = PyDict::new(py);
    let roles = PyDict::new(py);
    let mut count = panel.times.len();
    for line in &panel.lines {
        count = count.min(line.values.len());
        lines.set_item(&line.label, Floats::list(py, line.values.clone())?)?;
        let role = match line.role {
            Role::Left => "left",
            Role::Right => "right",
            Role::Net => "net",
            Role::Other => "other",
        };
        roles.set_item(&line.label, role)?;
    }
    let times = match count < panel.times.len() {
        true => panel
            .times
            .windows(2)
            .map(|step| 0.5 * (step[0] + step[1]))
            .collect(),
        false => panel.times.clone(),
    };
    let limits = PyDict::new(py);
    for limit in &panel.limits {
        limits.set_item(&limit.label, limit.value)?;
    }
    let fields = fields!(py; key: &panel.key, title: &panel.title, unit: &panel.unit,
        times: Floats::list(py, times)?, lines: lines, roles: roles, limits: limits);
    Curve::make(py, &fields)
}

/// Something that should not have happened.
pub fn event_object<'py>(
    py: Python<'py>,
    time: f64,
    at: Point,
    text: &str,
) -> PyResult<Event<'py>> {
    Event::make(py, &fields!(py; time: time, place: place(at), text: text))
}

/// Robots, net and objects over time, as keyword arguments: times (T), left and right (T x 3), net (T x P x 2), objects
/// (T x K x 3), tension and drive_force (T x 2).
pub fn frames_into(fields: &Bound<'_, PyDict>, frames: &[RehearsalFrame]) -> PyResult<()> {
    let py = fields.py();
    let count = frames.len();
    let robots = |pick: fn(&PairPose) -> pairtrawl::geometry::Pose| {
        Floats::poses(py, frames.iter().map(move |frame| pick(&frame.robots)))
    };
    let (points, objects) = frames
        .first()
        .map_or((0, 0), |first| (first.net.len(), first.objects.len()));
    let net = frames
        .iter()
        .flat_map(|frame| frame.net.iter().flat_map(|&point| <[f64; 2]>::from(point)));
    let lie = frames.iter().flat_map(|frame| {
        frame
            .objects
            .iter()
            .flat_map(|&pose| <[f64; 3]>::from(pose))
    });
    fields.set_item(
        "times",
        Floats::list(py, frames.iter().map(|frame| frame.time).collect())?,
    )?;
    fields.set_item("left", robots(|pair| pair.left)?)?;
    fields.set_item("right", robots(|pair| pair.right)?)?;
    fields.set_item("net", Floats::new(py, &[count, points, 2], net.collect())?)?;
    fields.set_item(
        "objects",
        Floats::new(py, &[count, objects, 3], lie.collect())?,
    )?;
    let pairs = |values: Vec<f64>| Floats::new(py, &[count, 2], values);
    fields.set_item(
        "tension",
        pairs(frames.iter().flat_map(|frame| frame.tension).collect())?,
    )?;
    fields.set_item(
        "drive_force",
        pairs(frames.iter().flat_map(|frame| frame.drive_force).collect())?,
    )
}

/// What happened in a rehearsal.
pub fn rehearsal_object<'py>(
    py: Python<'py>,
    record: &RehearsalRecord,
) -> PyResult<Rehearsal<'py>> {
    let events = record
        .events
        .iter()
        .map(|event| event_object(py, event.time, event.place, &event.kind.describe()));
    let warnings: Vec<String> = record.warnings.iter().map(ToString::to_string).collect();
    let pair = |[left, right]: [f64; 2]| (left, right);
    let fields = fields!(py; verdict: verdict_object(py, &record.verdict)?,
        events: PyTuple::new(py, events.collect::<PyResult<Vec<_>>>()?)?,
        gathered: PyTuple::new(py, &record.gathered)?, left_out: PyTuple::new(py, &record.left)?,
        max_tension: pair(record.max_tension), max_deviation: pair(record.max_deviation),
        mean_drive_force: pair(record.mean_drive_force), duration: record.duration,
        warnings: PyTuple::new(py, warnings)?);
    frames_into(&fields, &record.frames)?;
    Rehearsal::make(py, &fields)
}
