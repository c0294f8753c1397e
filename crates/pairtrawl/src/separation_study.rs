//! The paper's comparison of its U-shaped separation cost with two other rules.

use crate::common_start::{CommonStart, study_options};
use crate::error::PlanError;
use crate::length::LengthRange;
use crate::observer::{Observer, Stage};
use crate::options::PlanOptions;
use crate::run::Run;
use pairtrawl_model::numbers::quantity;
use pairtrawl_model::{Cost, PairTrajectory, Scene};
use pairtrawl_parallel::prelude::*;
use pairtrawl_trajopt::{Problem, SeparationRule, Settings, Solution, evaluate, optimize};

/// The paper's comparison of its U-shaped separation cost with two others (its Fig. 6). Studies: their trajectories break
/// claims, so they are never plans.
#[derive(Clone, Debug, PartialEq)]
pub struct SeparationStudy {
    /// Without any bound or cost on the separation (the paper's baseline 1): the net length that it takes, m, and the cost;
    /// or why there is no solution.
    pub free: Result<(f64, Cost), String>,
    /// For each net length, m, with the separation held at d_rest (baseline 2): the cost, or why there is no solution.
    pub rigid: Vec<(f64, Result<Cost, String>)>,
}

/// Solves both from the same start and with the same number of waypoints as [`length_curve`](crate::length_curve()).
///
/// # Errors
/// As [`plan`](crate::plan()), when there is no route at all.
pub fn separation_study(
    scene: &Scene,
    options: &PlanOptions,
    range: &LengthRange,
    observer: &mut dyn Observer,
) -> Result<SeparationStudy, PlanError> {
    let mut run = Run::new(options, observer);
    let open = study_options(options);
    let (prepared, CommonStart { pair: baseline, .. }) = CommonStart::find(scene, &open, &mut run)?;
    let (scales, scaled) = (&prepared.scales, &prepared.scaled);
    let problem = |net_length| Problem::new(scaled, Some(net_length), &prepared.world.pieces);
    let settings = Settings::default();

    let lengths: Vec<f64> = range.lengths().collect();
    run.stage(Stage::Optimize, || {
        let mut free = problem(scales.scaled(range.from));
        free.separation = SeparationRule::Free;
        let solution = optimize(&free, &baseline, &settings);
        let rigid = lengths
            .par_iter()
            .map(|&length| {
                let scaled_length = scales.scaled(length);
                let problem =
                    problem(scaled_length).with_rigid_separation(baseline.len(), scaled_length);
                let solution = optimize(&problem, &baseline, &settings);
                let cost = evaluate(scaled, &solution.trajectory, scaled_length);
                (length, refused(&solution).map_or(Ok(cost), Err))
            })
            .collect();
        let needed = needed_length(&solution.trajectory, scaled.robot.hitch);
        let cost = evaluate(scaled, &solution.trajectory, needed);
        SeparationStudy {
            free: refused(&solution).map_or(Ok((scales.meters(needed), cost)), Err),
            rigid,
        }
    })
}

/// Why a solution does not count.
fn refused(solution: &Solution) -> Option<String> {
    let worst = solution.violations.first().map(|violation| {
        format!(
            "{} fails by {} at waypoint {}",
            violation.claim,
            quantity(violation.amount, violation.claim.unit()),
            violation.step
        )
    });
    worst.or_else(|| {
        (solution.status != pairtrawl_model::SolverStatus::Converged)
            .then(|| format!("the solver ended with {:?}", solution.status))
    })
}

/// The net that reaches between axles and between hitches at every waypoint, m.
fn needed_length(pair: &PairTrajectory, hitch: f64) -> f64 {
    pair.left
        .iter()
        .zip(&pair.right)
        .map(|(left, right)| {
            let axles = left.position().distance(right.position());
            axles.max(left.hitch_point(hitch).distance(right.hitch_point(hitch)))
        })
        .fold(0.0, f64::max)
}
