use crate::costs::distance::Distance;
use crate::costs::turning::Turning;
use crate::interior_point::solve;
use crate::iterate::Iterate;
use crate::merit::Residuals;
use crate::problem::Problem;
use crate::settings::Settings;
use crate::shortfalls::{ShrunkMargin, Unmet, Violation, shortfalls};
use crate::state::State;
use crate::step::Step;
use crate::term::Term;
use crate::workspace::Workspace;
use pairtrawl_model::{PairTrajectory, SolverStatus};

/// What the optimizer returns. Whether the trajectories are a valid plan is for the certificate to say.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Both trajectories; `step_time` is that of the start.
    pub trajectory: PairTrajectory,
    /// d_max, m.
    pub net_length: f64,
    /// What was minimized: J and the price of margins that gave way.
    pub objective: f64,
    /// How it ended.
    pub status: SolverStatus,
    /// Interior-point iterations until solved; the few steps that settle the last of the slip are not counted.
    pub iterations: usize,
    /// Scaled optimality residuals.
    pub residuals: Residuals,
    /// The largest of them, relative to the cost: see [`Residuals::relative`].
    pub residual: f64,
    /// Constraints that could not be met, worst first.
    pub violations: Vec<Violation>,
    /// Constraints of the user's that could not be met, worst first.
    pub unmet: Vec<Unmet>,
    /// Wished-for margins that had to give way, one entry for each robot and thing, at the tightest waypoint.
    pub shrunk_margins: Vec<ShrunkMargin>,
}

/// Violations that do not vanish at this cost a meter are not for want of a price.
const GREATEST_ELASTIC_WEIGHT: f64 = 1e6;
const ELASTIC_WEIGHT_INCREASE: f64 = 20.0;
/// Violations of which this share is left at the next price are there to stay.
const STUBBORN_SHARE: f64 = 0.8;

/// Optimizes from a start, until solved or out of iterations.
pub fn optimize(problem: &Problem, start: &PairTrajectory, settings: &Settings) -> Solution {
    optimize_watched(problem, start, settings, &mut |_, _| true)
}

/// As [`optimize`]; `go_on(iterations, residuals)` is asked before every iteration and may stop it (status `TimeLimit`).
pub fn optimize_watched(
    problem: &Problem,
    start: &PairTrajectory,
    settings: &Settings,
    go_on: &mut dyn FnMut(usize, &Residuals) -> bool,
) -> Solution {
    let net_length = problem
        .net_length
        .unwrap_or_else(|| first_net_length(problem, start));
    optimize_from(problem, start, net_length, settings, go_on)
}

/// As [`optimize_watched`], from a given net length when that is free.
// A function of its own in every build: instructions are counted in it.
#[inline(never)]
pub fn optimize_from(
    problem: &Problem,
    start: &PairTrajectory,
    net_length: f64,
    settings: &Settings,
    go_on: &mut dyn FnMut(usize, &Residuals) -> bool,
) -> Solution {
    let mut x = Iterate::from_trajectory(start, net_length);
    fix_ends(problem, &mut x);
    let mut settings = *settings;
    let mut state = State::new(problem, x, &settings);
    let mut work = Workspace::default();
    let mut go_on = |s: &State| go_on(s.iterations, &s.residuals);
    let mut status = solve(problem, &mut state, &settings, &mut work, &mut go_on);
    let mut short = shortfalls(problem, &state);
    // Violations may only have been too cheap; those that a far higher price does not lessen are not.
    while matches!(
        status,
        SolverStatus::Converged | SolverStatus::LocallyInfeasible
    ) && short.any()
        && settings.elastic_weight < GREATEST_ELASTIC_WEIGHT
    {
        let before = short.total();
        settings.elastic_weight *= ELASTIC_WEIGHT_INCREASE;
        let iterations = state.iterations;
        state = State::new(problem, state.x, &settings);
        state.iterations = iterations;
        status = solve(problem, &mut state, &settings, &mut work, &mut go_on);
        short = shortfalls(problem, &state);
        if short.total() > STUBBORN_SHARE * before {
            break;
        }
    }
    status = match status {
        SolverStatus::Converged if short.any() => SolverStatus::LocallyInfeasible,
        // What stalled was no claim, but something that only helps.
        SolverStatus::LocallyInfeasible if !short.any() => SolverStatus::IterationLimit,
        other => other,
    };
    Solution {
        trajectory: state.x.to_trajectory(start.step_time),
        net_length: state.x.net_length,
        objective: state.merit.cost + state.merit.elastic + held_cost(problem, &state.x),
        status,
        iterations: state.iterations,
        residuals: state.residuals,
        residual: state.relative_residual(),
        violations: short.violations,
        unmet: short.unmet,
        shrunk_margins: short.margins,
    }
}

/// What driving and turning cost a robot that is held, whose steps the solver does not see.
fn held_cost(problem: &Problem, x: &Iterate) -> f64 {
    let Some(robot) = problem.frozen else {
        return 0.0;
    };
    let p = &problem.planner;
    let (distance, turning) = (Distance::of(p), Turning::minimized(p));
    (0..x.stages.len() - 1)
        .map(|i| {
            let (real, seen) = (Step::of(x, i, robot), Step::seen(problem, x, i, robot));
            let driven = distance.value(&[real.along]) - distance.value(&[seen.along]);
            // The linear part of turning counts for either robot.
            driven + turning.value(&[real.turn]) - turning.linear(real.turn)
        })
        .sum()
}

/// A net in which the start's mean separation is at rest, and which holds the widest pair.
pub(crate) fn first_net_length(problem: &Problem, start: &PairTrajectory) -> f64 {
    let separations = (0..start.len()).map(|i| start.pair(i).separation());
    let (mut sum, mut widest) = (0.0, 0.0_f64);
    for d in separations {
        sum += d;
        widest = widest.max(d);
    }
    (sum / start.len() as f64 / problem.planner.rest_ratio).max(1.2 * widest)
}

/// The ends are the scene's; headings keep the turn count of the start.
fn fix_ends(problem: &Problem, x: &mut Iterate) {
    let last = x.stages.len() - 1;
    for (i, pair) in [(0, &problem.start), (last, &problem.end)] {
        for (k, pose) in [(0, pair.left), (3, pair.right)] {
            let turns = ((x.stages[i][k + 2] - pose.heading) / std::f64::consts::TAU).round();
            x.stages[i][k] = pose.x;
            x.stages[i][k + 1] = pose.y;
            x.stages[i][k + 2] = pose.heading + turns * std::f64::consts::TAU;
        }
    }
}
