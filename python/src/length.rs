//! The cost of the best plan over the length of the net.

use crate::errors::{bad_input, plan_error};
use crate::options::options;
use crate::python_class::{fields, python_class};
use crate::results::cost_object;
use crate::scene::Scene;
use crate::typed::{AnyDict, Progress};
use crate::work::{PlanWatch, watched};
use pairtrawl::LengthRange;
use pairtrawl::model::{LengthPoint as LibraryPoint, LengthRefusal};
use pairtrawl::report::length_svg;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

python_class!(
    /// J over the length of the net.
    LengthCurve
);
python_class!(
    /// One length.
    LengthPoint
);

/// How much more than the least J counts as flat.
const FLAT: f64 = 0.01;

/// Computes J over the length of the net, with the route fixed. `pairtrawl.length_curve` has the options by keyword.
#[pyfunction]
#[pyo3(signature = (scene, start, stop, points, options, threads, progress))]
#[expect(
    clippy::too_many_arguments,
    reason = "the Python function in front of it takes them by keyword"
)]
pub fn length_curve<'py>(
    py: Python<'py>,
    scene: &Scene,
    start: Option<f64>,
    stop: Option<f64>,
    points: Option<usize>,
    options: AnyDict<'py>,
    threads: Option<usize>,
    progress: Progress<'py>,
) -> PyResult<LengthCurve<'py>> {
    let (state, given) = (scene.state(), self::options(&options.0)?);
    let fallback = LengthRange::default_for(&state.loaded.scene);
    let from = start.unwrap_or(fallback.from);
    let range = LengthRange {
        from,
        to: stop.unwrap_or(fallback.to.max(from + 1.0)),
        points: points.unwrap_or(fallback.points),
    };
    if !(range.from > 0.0
        && range.from < range.to
        && range.to <= 1000.0
        && (2..=100_000).contains(&range.points))
    {
        let words = format!(
            "lengths from {} to {} m at {} points: the first must be above 0 and less than the last, which is at most 1000 m, \
             and there are from 2 to 100000 points",
            range.from, range.to, range.points
        );
        return Err(bad_input(py, &words));
    }
    let curve = watched(py, threads, progress.callable(), |watch| {
        pairtrawl::length_curve(
            &state.loaded.scene,
            &given.plan,
            &range,
            &mut PlanWatch(watch),
        )
    })?;
    let curve = curve.map_err(|error| plan_error(py, error, &state, &given))?;
    let points = curve.points.iter().map(|point| point_object(py, point));
    let best = curve
        .minimum
        .map(|(_, cost)| cost_object(py, cost))
        .transpose()?;
    let fields = fields!(py; scene: &curve.title,
        points: PyTuple::new(py, points.collect::<PyResult<Vec<_>>>()?)?,
        best_length: curve.minimum.map(|(length, _)| length), best_cost: best,
        flat_range: curve.flat_range(FLAT), svg: length_svg(&curve));
    LengthCurve::make(py, &fields)
}

fn point_object<'py>(py: Python<'py>, point: &LibraryPoint) -> PyResult<LengthPoint<'py>> {
    let cost = (point.outcome.as_ref().ok())
        .map(|cost| cost_object(py, *cost))
        .transpose()?;
    let refusal = point.outcome.as_ref().err();
    let is_proven = matches!(refusal, Some(LengthRefusal::Proven(_)));
    let fields = fields!(py; net_length: point.net_length, cost: cost,
        error: refusal.map(ToString::to_string), proven: is_proven);
    LengthPoint::make(py, &fields)
}
