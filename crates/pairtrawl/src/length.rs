//! The cost of the best plan over the length of the net.

use crate::attempt::{Course, Origin};
use crate::common_start::{CommonStart, study_options};
use crate::error::PlanError;
use crate::infeasible::Infeasible;
use crate::observer::{Observer, Stage};
use crate::options::{NetLength, PlanOptions};
use crate::plan::certified;
use crate::prepare::Prepared;
use crate::run::Run;
use crate::tighten::Tightening;
use pairtrawl_certificate::infeasibility;
use pairtrawl_model::{Cost, LengthCurve, LengthPoint, LengthRefusal, Scales, Scene};
use pairtrawl_parallel::prelude::*;
use pairtrawl_trajopt::evaluate;

/// Which net lengths the curve is computed for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LengthRange {
    /// Least length, m.
    pub from: f64,
    /// Greatest length, m.
    pub to: f64,
    /// Number of lengths, evenly spaced, both ends included; at least 2.
    pub points: usize,
}

/// Default ranges begin at a multiple of this, in units of the length scale.
const ROUND: f64 = 0.1;
/// They reach to this length at least, in units of the length scale.
const FARTHEST: f64 = 3.0;
/// They are at least this wide, in units of the length scale.
const WIDTH: f64 = 1.5;

impl LengthRange {
    /// From the least net that the ends of a scene allow, rounded up, to twice what pairs of this size usually need.
    pub fn default_for(scene: &Scene) -> Self {
        let hitch = scene.robot.hitch;
        let needed = [scene.start, scene.end]
            .iter()
            .flat_map(|pair| {
                let hitches = pair
                    .left
                    .hitch_point(hitch)
                    .distance(pair.right.hitch_point(hitch));
                [pair.separation(), hitches]
            })
            .fold(4.0 * scene.robot.radius, f64::max);
        let scales = Scales::of(scene);
        let from = (scales.scaled(needed) / ROUND).ceil() * ROUND;
        Self {
            from: scales.meters(from),
            to: scales.meters(f64::max(FARTHEST, from + WIDTH)),
            points: 21,
        }
    }

    pub(crate) fn lengths(&self) -> impl Iterator<Item = f64> {
        let steps = self.points.max(2) - 1;
        (0..=steps).map(move |i| self.from + (self.to - self.from) * i as f64 / steps as f64)
    }
}

/// The curve J(d_max): the cost of the certified plan for each net length, with N, visiting order and sides fixed, solved
/// in parallel, and the optimum with the length free.
///
/// When the observer interrupts while lengths are solved, the points that are finished are kept.
///
/// # Errors
/// As [`plan`](crate::plan()), when there is a proof against every length or no route at all. A length without a plan is
/// a point of the curve.
pub fn length_curve(
    scene: &Scene,
    options: &PlanOptions,
    range: &LengthRange,
    observer: &mut dyn Observer,
) -> Result<LengthCurve, PlanError> {
    let mut run = Run::new(options, observer);
    let open = study_options(options);
    let (prepared, common) = CommonStart::find(scene, &open, &mut run)?;
    let wanted: Vec<Option<f64>> = range.lengths().map(Some).chain([None]).collect();
    let solved: Vec<_> = run.unfinished_stage(Stage::Optimize, |may_go_on| {
        let solve = |length: &Option<f64>| point(&prepared, &common, *length, may_go_on);
        wanted.par_iter().map(solve).collect()
    })?;

    let interrupted = solved.iter().any(Option::is_none);
    let mut points = Vec::new();
    let mut minimum: Option<(f64, Cost)> = None;
    for (wanted, outcome) in wanted.iter().zip(solved) {
        let Some(outcome) = outcome else { continue };
        if let Ok((length, cost)) = &outcome
            && minimum.is_none_or(|(_, least)| cost.total() < least.total())
        {
            minimum = Some((*length, *cost));
        }
        if let Some(net_length) = *wanted {
            let outcome = outcome.map(|(_, cost)| cost);
            points.push(LengthPoint {
                net_length,
                outcome,
            });
        }
    }
    Ok(LengthCurve {
        title: scene.name.clone(),
        points,
        minimum,
        interrupted,
    })
}

/// Net length (m) and cost of the certified plan for a length (`None`: free); `None` when the work may not go on.
fn point(
    common: &Prepared,
    start: &CommonStart,
    length: Option<f64>,
    may_go_on: &(dyn Fn() -> bool + Sync),
) -> Option<Result<(f64, Cost), LengthRefusal>> {
    if !may_go_on() {
        return None;
    }
    let scene = &*common.scene;
    let infeasible = Infeasible {
        proofs: infeasibility::prove(scene, length),
        wanted: scene.wanted(),
    };
    if !infeasible.proofs.is_empty() {
        return Some(Err(LengthRefusal::Proven(infeasible.to_string())));
    }
    let options = PlanOptions {
        net_length: Some(length.map_or(NetLength::Auto, NetLength::Fixed)),
        waypoints: Some(start.pair.len()),
        time_limit: None,
        ..common.options.clone()
    };
    let prepared = common.with_net_length(&options, length);
    let course = Course::new(&prepared, &start.order);
    let origin = Origin::Centerline(&start.centerline, Some(&start.pair));
    let mut watch = Watch(may_go_on);
    let mut run = Run::new(&options, &mut watch);
    let mut tightening = Tightening::NONE;
    match certified(&course, &origin, &mut tightening, &mut run) {
        Ok(attempt) => {
            let cost = evaluate(scene, &attempt.trajectory, attempt.net_length);
            Some(Ok((attempt.net_length, cost)))
        }
        Err(PlanError::Interrupted) => None,
        Err(error) => Some(Err(LengthRefusal::NotFound(error.to_string()))),
    }
}

/// Ends one of many runs when all of them are to end.
struct Watch<'a>(&'a (dyn Fn() -> bool + Sync));

impl Observer for Watch<'_> {
    fn interrupted(&self) -> bool {
        !(self.0)()
    }
}
