//! Primal-dual interior point with a filter line search (after Wächter and Biegler, Math. Program. 106, 2006) on the
//! condensed banded system.

use crate::active::{ActiveSet, STEP_ROWS};
use crate::assembly::{DUAL_REGULARIZATION, System, objective};
use crate::constraints::NoSidewaysSlip;
use crate::filter::Filter;
use crate::iterate::{Iterate, STAGE};
use crate::linear::BandMatrix;
use crate::problem::Problem;
use crate::row::Row;
use crate::term::{PAIR, Term};
use pairtrawl_model::SolverStatus;

/// How the interior point works. Budgets count iterations, so that results do not depend on the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Most iterations.
    pub max_iterations: usize,
    /// First barrier parameter.
    pub initial_mu: f64,
    /// Factor of the barrier parameter from one barrier problem to the next.
    pub barrier_decrease: f64,
    /// Summed complementarity at which the problem counts as solved, as a share of the cost.
    pub relative_gap: f64,
    /// Decrease that a full Newton step promises at which the problem counts as solved, as a share of the cost.
    pub relative_decrease: f64,
    /// Greatest residual of a constraint at which the problem counts as solved, m or rad.
    pub feasibility_tolerance: f64,
    /// Cost of a meter (or radian) of violation of an elastic constraint.
    pub elastic_weight: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            max_iterations: 300,
            initial_mu: 1.0,
            barrier_decrease: 0.1,
            relative_gap: 2e-4,
            relative_decrease: 1e-5,
            feasibility_tolerance: 1e-6,
            elastic_weight: 3e3,
        }
    }
}

/// Measures of optimality at an iterate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Residuals {
    /// Largest entry of the Lagrangian's gradient, scaled by the mean multiplier.
    pub dual: f64,
    /// Largest violation of `c - s + e = 0` and of the equalities.
    pub primal: f64,
    /// Largest deviation of a complementarity product from the barrier parameter.
    pub complementarity: f64,
    /// Sum of all complementarity products: bounds the cost above the optimum.
    pub gap: f64,
}

/// State of the solver, reused from solve to solve so that the loop does not allocate.
#[derive(Clone, Debug, Default)]
pub(crate) struct Workspace {
    system: System,
    factor: BandMatrix,
    direction: Vec<f64>,
    arrow_solution: Vec<f64>,
    trial: Iterate,
    filter: Filter,
}

/// A point with its multipliers.
#[derive(Clone, Debug, Default)]
pub(crate) struct State {
    pub x: Iterate,
    pub set: ActiveSet,
    pub lambda: Vec<f64>,
    pub mu: f64,
    pub iterations: usize,
    pub residuals: Residuals,
    /// Objective at the iterate.
    pub objective: f64,
    /// Decrease of the barrier function that the last Newton step promised; infinite when it was cut short.
    pub promise: f64,
    /// Largest multiplier of an equality.
    pub force: f64,
}

/// Merit of a point: violation and barrier function.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Merit {
    pub theta: f64,
    pub phi: f64,
}

const FRACTION_TO_BOUNDARY: f64 = 0.99;
const SHORTEST_STEP: f64 = 1e-6;
/// Least shift of the diagonal: keeps directions that cost nothing from running away.
const LEAST_SHIFT: f64 = 0.1;
/// Shift once the cost is optimal and only violations are left to mend.
const POLISHING_SHIFT: f64 = 100.0;
const GREATEST_SHIFT: f64 = 1e10;
const SMALLEST_PIVOT: f64 = 1e-8;
/// Constraints near are looked up again when a robot moved this far, m.
const REFRESH_DISTANCE: f64 = 0.15;

/// Calls `$with` on every row.
macro_rules! each_row {
    ($set:expr, $row:ident, $with:block) => {
        for $row in &$set.steps $with
        for item in &$set.pairs { let $row = &item.row; $with }
        for item in &$set.points { let $row = &item.row; $with }
        for item in &$set.rungs { let $row = &item.row; $with }
    };
}

impl State {
    pub fn new(problem: &Problem, x: Iterate, settings: &Settings) -> Self {
        let mu = settings.initial_mu;
        let set = ActiveSet::new(problem, &x, settings.elastic_weight, mu);
        let lambda = vec![0.0; 2 * (x.stages.len() - 1)];
        Self {
            x,
            set,
            lambda,
            mu,
            iterations: 0,
            residuals: Residuals::default(),
            objective: 0.0,
            promise: f64::INFINITY,
            force: 0.0,
        }
    }
}

/// Solves from a state, in place.
pub(crate) fn solve(
    problem: &Problem,
    state: &mut State,
    settings: &Settings,
    work: &mut Workspace,
    watch: &mut dyn FnMut(&State) -> bool,
) -> SolverStatus {
    let mut looked_up = state.x.clone();
    work.filter.clear();
    let mut shift = LEAST_SHIFT;
    loop {
        if moved(&looked_up, &state.x) > REFRESH_DISTANCE {
            state
                .set
                .refresh(problem, &state.x, settings.elastic_weight, state.mu);
            looked_up.clone_from(&state.x);
            work.filter.clear();
        }
        work.system
            .assemble(problem, &state.x, &mut state.set, &state.lambda, state.mu);
        state.residuals = residuals(state, &work.system, problem.net_length.is_none());
        if solved(state, settings) {
            return SolverStatus::Converged;
        }
        if state.iterations >= settings.max_iterations {
            return SolverStatus::IterationLimit;
        }
        if !watch(state) {
            return SolverStatus::TimeLimit;
        }
        if barrier_solved(state)
            && state.residuals.gap > 0.5 * settings.relative_gap * state.objective.abs()
        {
            state.mu *= settings.barrier_decrease;
            work.filter.clear();
            work.system
                .assemble(problem, &state.x, &mut state.set, &state.lambda, state.mu);
        }
        let free_length = problem.net_length.is_none();
        let Some(length_step) = work.newton_direction(free_length, shift) else {
            return SolverStatus::NumericalTrouble;
        };
        let (primal, dual) = recover(state, &work.system, &work.direction, length_step);
        work.line_search(problem, state, primal, dual, length_step);
        state.iterations += 1;
        if optimal(state, settings) {
            // What is left is slip; small steps mend it without wandering along directions that cost nothing.
            shift = POLISHING_SHIFT;
        }
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

fn residuals(state: &mut State, system: &System, free_length: bool) -> Residuals {
    let mut sum = 0.0;
    let mut count = 0.0;
    let mut r = Residuals::default();
    each_row!(state.set, row, {
        sum += row.z;
        count += 1.0;
        let (largest, products) = row.complementarity(state.mu);
        r.complementarity = r.complementarity.max(largest);
        r.gap += products;
        r.primal = r.primal.max(row.residual().abs());
    });
    let mut force = 0.0_f64;
    for (&lambda, &(h, _)) in state.lambda.iter().zip(&system.slips) {
        force = force.max(lambda.abs());
        sum += lambda.abs();
        count += 1.0;
        r.primal = r.primal.max(h.abs());
    }
    let scale = (sum / count / 10.0).max(1.0);
    r.dual = system
        .lagrangian
        .iter()
        .fold(0.0_f64, |m, g| m.max(g.abs()));
    if free_length {
        r.dual = r.dual.max(system.length[2].abs());
    }
    r.dual /= scale;
    state.force = force;
    r
}

/// The cost is optimal to the tolerances: the last Newton step promised next to nothing, and so does the rest of the barrier.
fn optimal(state: &State, settings: &Settings) -> bool {
    let scale = state.objective.abs().max(1.0);
    state.residuals.gap <= settings.relative_gap * scale
        && state.promise <= settings.relative_decrease * scale
}

fn solved(state: &State, settings: &Settings) -> bool {
    optimal(state, settings) && state.residuals.primal <= settings.feasibility_tolerance
}

/// The barrier problem is solved well enough when the Newton step promises little against what a smaller barrier
/// parameter gains, in cost and in violation.
fn barrier_solved(state: &State) -> bool {
    let r = &state.residuals;
    state.promise <= 0.02 * r.gap && r.primal * state.force <= 0.02 * r.gap
}

/// Steps of slacks, violations and multipliers from the primal direction; the longest primal and dual step lengths.
fn recover(state: &mut State, system: &System, direction: &[f64], length_step: f64) -> (f64, f64) {
    let count = state.x.stages.len();
    let mu = state.mu;
    let (mut primal, mut dual) = (1.0, 1.0);
    let stage = |i: usize| -> [f64; STAGE] {
        if i == 0 || i + 1 == count {
            return [0.0; STAGE];
        }
        let b = (i - 1) * STAGE;
        std::array::from_fn(|v| direction[b + v])
    };
    for (at, rows) in state.set.steps.chunks_exact_mut(STEP_ROWS).enumerate() {
        let (i, k) = (at / 2, 3 * (at % 2));
        let (a, b) = (stage(i), stage(i + 1));
        let local = [
            b[k] - a[k],
            b[k + 1] - a[k + 1],
            0.5 * (a[k + 2] + b[k + 2]),
            b[k + 2] - a[k + 2],
        ];
        for row in rows {
            finish(row, mu, &local, &mut primal, &mut dual);
        }
    }
    for pair in &mut state.set.pairs {
        let d = stage(pair.stage as usize);
        let local: [f64; PAIR] = [d[0] - d[3], d[1] - d[4], d[2], d[5], length_step];
        finish(&mut pair.row, mu, &local, &mut primal, &mut dual);
    }
    for point in &mut state.set.points {
        let d = stage(point.stage as usize);
        let k = 3 * point.robot as usize;
        finish(
            &mut point.row,
            mu,
            &[d[k], d[k + 1]],
            &mut primal,
            &mut dual,
        );
    }
    for rung in &mut state.set.rungs {
        let d = stage(rung.stage as usize);
        finish(
            &mut rung.row,
            mu,
            &[d[0], d[1], d[3], d[4]],
            &mut primal,
            &mut dual,
        );
    }
    for (at, lambda) in state.lambda.iter_mut().enumerate() {
        let (i, k) = (at / 2, 3 * (at % 2));
        let (a, b) = (stage(i), stage(i + 1));
        let local = [
            b[k] - a[k],
            b[k + 1] - a[k + 1],
            0.5 * (a[k + 2] + b[k + 2]),
            b[k + 2] - a[k + 2],
        ];
        let (h, gradient) = &system.slips[at];
        // Equality multipliers always take the full step.
        *lambda += (h + dot(gradient, &local)) / DUAL_REGULARIZATION;
    }
    (primal, dual)
}

#[inline]
fn finish<const K: usize>(
    row: &mut Row<K>,
    mu: f64,
    local: &[f64; K],
    primal: &mut f64,
    dual: &mut f64,
) {
    row.recover(mu, row.residual(), dot(&row.gradient, local));
    row.limit_steps(FRACTION_TO_BOUNDARY, primal, dual);
}

#[inline]
fn dot<const K: usize>(a: &[f64; K], b: &[f64; K]) -> f64 {
    (0..K).map(|i| a[i] * b[i]).sum()
}

impl Workspace {
    /// Newton direction of poses into `self.direction`; returns that of the net length.
    fn newton_direction(&mut self, free_length: bool, least_shift: f64) -> Option<f64> {
        let mut shift = least_shift;
        while shift < GREATEST_SHIFT {
            self.factor.copy_shifted(&self.system.matrix, shift);
            if self.factor.factorize(SMALLEST_PIVOT).is_ok() {
                self.direction.clear();
                self.direction
                    .extend(self.system.gradient.iter().map(|g| -g));
                self.factor.solve(&mut self.direction);
                if !free_length {
                    return Some(0.0);
                }
                self.arrow_solution.clone_from(&self.system.arrow);
                self.factor.solve(&mut self.arrow_solution);
                let schur =
                    self.system.length[0] + shift - inner(&self.system.arrow, &self.arrow_solution);
                if schur > SMALLEST_PIVOT {
                    let step = (-self.system.length[1]
                        - inner(&self.system.arrow, &self.direction))
                        / schur;
                    for (d, a) in self.direction.iter_mut().zip(&self.arrow_solution) {
                        *d -= step * a;
                    }
                    return step.is_finite().then_some(step);
                }
            }
            shift *= 10.0;
        }
        None
    }

    /// Moves the state along the direction: the longest of a few step lengths that the filter accepts.
    fn line_search(
        &mut self,
        problem: &Problem,
        state: &mut State,
        primal: f64,
        dual: f64,
        length_step: f64,
    ) {
        state.objective = objective(problem, &state.x);
        let start = merit(problem, state);
        let mut slope =
            inner(&self.system.objective, &self.direction) + self.system.length[3] * length_step;
        each_row!(state.set, row, { slope += row.barrier_slope(state.mu) });
        let mut alpha = primal;
        loop {
            self.trial
                .assign_stepped(&state.x, alpha, &self.direction, length_step);
            let reached = trial_merit(problem, state, &self.trial, alpha);
            if self.filter.accepts(start, reached, alpha, slope) || alpha < SHORTEST_STEP {
                break;
            }
            alpha *= 0.5;
        }
        if alpha < SHORTEST_STEP {
            self.filter.clear();
        }
        state.promise = if alpha > 0.5 { -slope } else { f64::INFINITY };
        self.take(problem, state, alpha, dual);
    }

    fn take(&mut self, problem: &Problem, state: &mut State, alpha: f64, dual: f64) {
        std::mem::swap(&mut state.x, &mut self.trial);
        let x = &state.x;
        for (at, row) in state.set.steps.iter_mut().enumerate() {
            let z = x.step(at / STEP_ROWS / 2, at / STEP_ROWS % 2);
            advance(
                row,
                problem.step_term(at % STEP_ROWS, |t| t.value(&z)),
                alpha,
                dual,
            );
        }
        for pair in &mut state.set.pairs {
            let z = x.pair(pair.stage as usize);
            advance(
                &mut pair.row,
                problem.pair_term(pair.kind, |t| t.value(&z)),
                alpha,
                dual,
            );
        }
        for point in &mut state.set.points {
            let z = x.point(point.stage as usize, point.robot.into());
            advance(
                &mut point.row,
                problem.point_term(&point.kind, |t| t.value(&z)),
                alpha,
                dual,
            );
        }
        for rung in &mut state.set.rungs {
            let z = x.rung(rung.stage as usize);
            advance(
                &mut rung.row,
                problem.rung_distance(rung.piece).value(&z),
                alpha,
                dual,
            );
        }
    }
}

fn advance<const K: usize>(row: &mut Row<K>, c: f64, alpha: f64, dual: f64) {
    (row.s, row.e) = row.stepped(alpha, c);
    row.z += dual * row.dz;
    row.c = c;
}

fn inner(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn merit(problem: &Problem, state: &State) -> Merit {
    let mut merit = Merit {
        theta: 0.0,
        phi: objective(problem, &state.x),
    };
    each_row!(state.set, row, {
        merit.theta += row.residual().abs();
        merit.phi += row.barrier(state.mu, row.s, row.e);
    });
    for i in 0..state.x.stages.len() - 1 {
        for robot in 0..2 {
            merit.theta += NoSidewaysSlip.value(&state.x.step(i, robot)).abs();
        }
    }
    merit
}

/// Merit at a trial point, with slacks stepped by `alpha`.
fn trial_merit(problem: &Problem, state: &State, x: &Iterate, alpha: f64) -> Merit {
    let mut merit = Merit {
        theta: 0.0,
        phi: objective(problem, x),
    };
    let mu = state.mu;
    for i in 0..x.stages.len() - 1 {
        for robot in 0..2 {
            let z = x.step(i, robot);
            merit.theta += NoSidewaysSlip.value(&z).abs();
            let at = (2 * i + robot) * STEP_ROWS;
            for kind in 0..STEP_ROWS {
                merit.add(
                    &state.set.steps[at + kind],
                    mu,
                    alpha,
                    problem.step_term(kind, |t| t.value(&z)),
                );
            }
        }
    }
    for pair in &state.set.pairs {
        let z = x.pair(pair.stage as usize);
        merit.add(
            &pair.row,
            mu,
            alpha,
            problem.pair_term(pair.kind, |t| t.value(&z)),
        );
    }
    for point in &state.set.points {
        let z = x.point(point.stage as usize, point.robot.into());
        merit.add(
            &point.row,
            mu,
            alpha,
            problem.point_term(&point.kind, |t| t.value(&z)),
        );
    }
    for rung in &state.set.rungs {
        let z = x.rung(rung.stage as usize);
        merit.add(
            &rung.row,
            mu,
            alpha,
            problem.rung_distance(rung.piece).value(&z),
        );
    }
    merit
}

impl Merit {
    #[inline]
    fn add<const K: usize>(&mut self, row: &Row<K>, mu: f64, alpha: f64, c: f64) {
        let (s, e) = row.stepped(alpha, c);
        self.theta += (c - s + e).abs();
        self.phi += row.barrier(mu, s, e);
    }
}
