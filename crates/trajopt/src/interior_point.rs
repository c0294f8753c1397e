//! Primal-dual interior point with a filter line search (after Wächter and Biegler, Math. Program. 106, 2006) on the
//! condensed banded system.

use crate::iterate::{Iterate, STAGE};
use crate::polish::{self, Polish};
use crate::problem::Problem;
use crate::row::Beginning;
use crate::settings::Settings;
use crate::shortfalls::shortfalls;
use crate::state::State;
use crate::system::System;
use crate::workspace::Workspace;
use pairtrawl_model::SolverStatus;

/// Least shift of the diagonal: keeps directions that cost nothing from running away.
const LEAST_SHIFT: f64 = 0.1;
/// Shift once the cost is optimal and only violations are left to be removed.
const POLISHING_SHIFT: f64 = 100.0;
const POLISHING_INCREASE: f64 = 4.0;
const GREATEST_POLISHING_SHIFT: f64 = 1e7;
/// Constraints near are looked up again when a robot moved this far, m.
const REFRESH_DISTANCE: f64 = 0.12;
/// Most steps, which are not counted, that a solved problem takes to reach [`Settings::settled_tolerance`].
const MOST_SETTLING: usize = 3;
/// Violations that cost more than this share of the objective are watched.
const STALL_SHARE: f64 = 0.05;
/// They go away as long as they fall below this share of their lowest ...
const STALL_DECREASE: f64 = 0.98;
/// ... within this many iterations.
const STALL_ITERATIONS: usize = 30;
/// A barrier problem is solved well enough when what is left of it is this share of the gap.
const BARRIER_SHARE: f64 = 0.1;

/// Solves from a state, in place. `go_on` is asked before every iteration.
pub(crate) fn solve(
    problem: &Problem,
    state: &mut State,
    settings: &Settings,
    work: &mut Workspace,
    go_on: &mut dyn FnMut(&State) -> bool,
) -> SolverStatus {
    let mut looked_up = state.x.clone();
    let mut shift = LEAST_SHIFT;
    let mut stall = Stall::new(state);
    let free_length = problem.net_length.is_none();
    let mut settling = 0;
    let mut polish = Polish::new(settings);
    work.filter.clear();
    loop {
        if moved(&looked_up, &state.x) > REFRESH_DISTANCE {
            let beginning = Beginning {
                elastic: settings.elastic_weight,
                mu: state.mu,
            };
            state.set.refresh(problem, &state.x, beginning);
            state.measure(problem);
            looked_up.clone_from(&state.x);
            work.filter.clear();
        }
        let optimal = optimal(state, settings);
        let converged = optimal && state.residuals.primal <= settings.feasibility_tolerance;
        if polish.is_on() {
            polish.lower_barrier(state, work);
        } else if !converged
            && barrier_solved(state)
            && state.residuals.gap > 0.5 * settings.relative_gap * state.merit.cost.abs()
        {
            state.mu *= settings.barrier_decrease;
            work.filter.clear();
        }
        let how = (state.mu, polish.curvature());
        work.system
            .assemble(problem, &state.x, &mut state.set, &state.lambda, how);
        state.residuals.dual = stationarity(&work.system, free_length);
        if converged
            && (state.residuals.primal <= settings.settled_tolerance || settling == MOST_SETTLING)
        {
            if polish.is_over(state) {
                return SolverStatus::Converged;
            }
            if !polish.is_on() {
                polish.begin(state);
                // Assembled again, with other second derivatives.
                work.filter.clear();
                continue;
            }
        }
        if polish.is_on() {
            shift = polish::shift(state);
        } else if optimal {
            // What is left is slip; small steps remove it without wandering along directions that cost nothing.
            shift = (POLISHING_INCREASE * shift).clamp(POLISHING_SHIFT, GREATEST_POLISHING_SHIFT);
        }
        if polish.is_spent() {
            return polish.give_up(state);
        }
        if !polish.is_on() && stall.goes_on(problem, state) {
            return SolverStatus::LocallyInfeasible;
        }
        if !polish.is_on() && !converged && state.iterations >= settings.max_iterations {
            return SolverStatus::IterationLimit;
        }
        if !go_on(state) {
            return SolverStatus::TimeLimit;
        }
        let Some(longest) = work.direction(problem, state, shift) else {
            if polish.is_on() {
                return polish.give_up(state);
            }
            return SolverStatus::NumericalTrouble;
        };
        work.line_search(problem, state, longest);
        if polish.is_on() {
            polish.step(state);
        } else if converged {
            settling += 1;
        } else {
            state.iterations += 1;
        }
    }
}

/// Watches for violations that do not go away, far beyond what the barrier keeps from every bound.
struct Stall {
    lowest: f64,
    since: usize,
}

impl Stall {
    fn new(state: &State) -> Self {
        Self {
            lowest: f64::INFINITY,
            since: state.iterations,
        }
    }

    /// True when violations have stayed what they are for a while, and are more than margins that gave way.
    fn goes_on(&mut self, problem: &Problem, state: &State) -> bool {
        let (violation, cost) = (state.merit.violation, state.merit.cost.abs());
        let of_barrier = state.mu * state.residuals.products as f64;
        if violation < STALL_DECREASE * self.lowest
            || violation < STALL_SHARE * cost + 2.0 * of_barrier
        {
            *self = Self {
                lowest: violation,
                since: state.iterations,
            };
        }
        let waited = state.iterations - self.since;
        waited > 0 && waited.is_multiple_of(STALL_ITERATIONS) && shortfalls(problem, state).any()
    }
}

/// The farthest that a robot moved between two iterates, m (largest coordinate).
fn moved(a: &Iterate, b: &Iterate) -> f64 {
    let change = |a: &[f64; STAGE], b: &[f64; STAGE]| {
        [0, 1, 3, 4]
            .iter()
            .fold(0.0_f64, |most, &v| most.max((a[v] - b[v]).abs()))
    };
    a.stages
        .iter()
        .zip(&b.stages)
        .fold(0.0, |most, (a, b)| most.max(change(a, b)))
}

/// Largest entry of the Lagrangian's gradient, as a share of the largest entry of the objective's gradient.
fn stationarity(system: &System, free_length: bool) -> f64 {
    let largest = |v: &[f64]| v.iter().fold(0.0_f64, |m, g| m.max(g.abs()));
    let length = if free_length {
        system.length.lagrangian.abs()
    } else {
        0.0
    };
    largest(&system.lagrangian).max(length) / largest(&system.objective).max(1.0)
}

/// The cost is optimal to the tolerances: the last Newton step promised next to nothing, and so does the rest of the barrier.
fn optimal(state: &State, settings: &Settings) -> bool {
    let scale = state.merit.cost.abs().max(1.0);
    state.residuals.gap <= settings.relative_gap * scale
        && state.promise <= settings.relative_decrease * scale
}

/// The barrier problem is solved well enough when the Newton step promises little against what a smaller barrier
/// parameter gains, in cost and in violation.
fn barrier_solved(state: &State) -> bool {
    let r = &state.residuals;
    let force = state.lambda.iter().fold(0.0_f64, |m, l| m.max(l.abs()));
    // Not the gap itself where violations are far from complementary: a barrier that falls then only makes them stiffer.
    let left = BARRIER_SHARE * r.gap.min(state.mu * r.products as f64);
    state.promise <= left && r.primal * force <= left
}
