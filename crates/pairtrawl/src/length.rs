use crate::attempt::{Course, Origin};
use crate::run::Run;
use crate::starts::CommonStart;
use crate::tighten::Tightening;
use crate::{Observer, PlanError, PlanOptions, RehearsalMode, Stage};
use pairtrawl_certificate::infeasibility;
use pairtrawl_model::{Cost, LengthCurve, LengthPoint, Scene};
use pairtrawl_trajopt::evaluate;
use rayon::prelude::*;

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

impl LengthRange {
    /// From the least net that the ends of a scene allow, rounded up to 0.1 m, to 3 m or 1.5 m beyond that.
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
        let from = (needed * 10.0).ceil() / 10.0;
        Self {
            from,
            to: f64::max(3.0, from + 1.5),
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
/// # Errors
/// As [`plan`](crate::plan()), when there is no route at all. A length without a plan is a point of the curve.
pub fn length_curve(
    scene: &Scene,
    options: &PlanOptions,
    range: &LengthRange,
    observer: &mut dyn Observer,
) -> Result<LengthCurve, PlanError> {
    let mut run = Run::new(options, observer);
    let CommonStart {
        scales,
        scaled,
        world,
        order,
        centerline,
        pair,
    } = CommonStart::new(scene, options, &mut run)?;
    let waypoints = pair.len();
    let origin = Origin::Centerline(centerline, Some(pair));
    let fixed = PlanOptions {
        waypoints: Some(waypoints),
        rehearsal: RehearsalMode::Skip,
        time_limit: None,
        ..options.clone()
    };

    let solve = |net_length: Option<f64>| -> Result<(f64, Cost), String> {
        if let Some(proof) = infeasibility::prove(scene, net_length) {
            return Err(proof.message);
        }
        let course = Course {
            scene,
            scales,
            scaled: &scaled,
            net_length: net_length.map(|length| scales.scaled(length)),
            world: &world,
            order: &order,
            options: &fixed,
        };
        let (mut tightening, mut nobody) = (Tightening::NONE, ());
        let attempt = course
            .certified_attempt(&origin, &mut tightening, &mut Run::new(&fixed, &mut nobody))
            .map_err(|error| error.to_string())?;
        let cost = evaluate(scene, &attempt.trajectory, attempt.net_length);
        Ok((attempt.net_length, cost))
    };
    let wanted: Vec<Option<f64>> = range.lengths().map(Some).chain([None]).collect();
    let mut solved: Vec<_> = run.stage(Stage::Optimize, || {
        wanted.par_iter().map(|length| solve(*length)).collect()
    })?;
    let free = solved.pop().and_then(Result::ok);

    let points: Vec<LengthPoint> = range
        .lengths()
        .zip(solved)
        .map(|(net_length, outcome)| LengthPoint {
            net_length,
            outcome: outcome.map(|(_, cost)| cost),
        })
        .collect();
    let best = points
        .iter()
        .filter_map(|point| Some((point.net_length, *point.outcome.as_ref().ok()?)))
        .chain(free)
        .min_by(|a, b| a.1.total().total_cmp(&b.1.total()));
    Ok(LengthCurve {
        title: scene.name.clone(),
        points,
        minimum: best,
    })
}
