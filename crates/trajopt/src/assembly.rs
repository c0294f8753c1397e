//! The condensed Newton system: band matrix over the inner stages, one dense row for the net length.
//!
//! Slacks, violations and multipliers of the inequalities are eliminated row by row; the equalities (no sideways slip) by
//! dual regularization, `A dx + h = delta (lambda+ - lambda)`, which leaves `A^T A / delta` in the band.

use crate::active::{ActiveSet, slope_of};
use crate::iterate::{Iterate, STAGE};
use crate::linear::BandMatrix;
use crate::local::Local;
use crate::problem::Problem;
use crate::step::{STEP_BOUNDS, Step};
use crate::term::{PAIR, POINT, QUAD, Term};
use pairtrawl_model::Side;

/// Dual regularization of the equalities.
pub(crate) const DUAL_REGULARIZATION: f64 = 1e-9;

/// Diagonal entry of a variable that is not to move.
const FROZEN: f64 = 1e20;

/// Matrix and gradients at an iterate.
#[derive(Clone, Debug, Default)]
pub(crate) struct System {
    pub matrix: BandMatrix,
    /// Condensed gradient: the right-hand side is its negative.
    pub gradient: Vec<f64>,
    /// Gradient of the Lagrangian, for the optimality residual.
    pub lagrangian: Vec<f64>,
    /// Gradient of the objective.
    pub objective: Vec<f64>,
    /// Column of the net length.
    pub arrow: Vec<f64>,
    /// The net length's own entries.
    pub length: LengthEntries,
}

/// Diagonal and gradients of the net length.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LengthEntries {
    pub diagonal: f64,
    pub gradient: f64,
    pub lagrangian: f64,
    pub objective: f64,
}

/// First and second derivatives over one step, in `along`, `across`, `turn`.
#[derive(Default)]
pub(crate) struct StepDerivatives {
    /// Condensed gradient, Lagrangian gradient and objective gradient.
    pub gradients: [[f64; 3]; 3],
    /// Diagonal second derivatives.
    pub diagonal: [f64; 3],
    /// Curvature of the frame: of a taut string, and of the lateral force against `along`.
    taut: f64,
    lateral: f64,
}

impl StepDerivatives {
    /// Curvature of the Lagrangian over a step, made positive semidefinite.
    ///
    /// With `u` along and `v` across, `tension * u + lambda * v` has the Hessian
    /// `2 tension dv dpsi - tension u dpsi^2 - 2 lambda du dpsi`. On the linearized slip `dv = u dpsi` its first two terms
    /// are those of a taut string, `tension u dpsi^2`; the last one is kept as far as the curvature in `u` that the step's
    /// bounds give carries it.
    #[inline]
    fn bend(&mut self, step: &Step, lambda: f64) {
        let tension = self.gradients[1][0];
        self.taut = (tension * step.along).max(0.0);
        let most = 0.9 * (self.diagonal[0] * self.taut).sqrt();
        self.lateral = -lambda.max(-most).min(most);
    }
}

/// Index of a stage's first variable among the inner stages; `None` for the fixed ends.
#[inline]
pub(crate) fn base(stage: usize, count: usize) -> Option<usize> {
    (stage > 0 && stage + 1 < count).then(|| (stage - 1) * STAGE)
}

impl System {
    /// Evaluates all derivatives at an iterate; rows and slips remember their values and gradients.
    pub fn assemble(
        &mut self,
        problem: &Problem,
        x: &Iterate,
        set: &mut ActiveSet,
        lambda: &[f64],
        mu: f64,
    ) {
        let order = (x.stages.len() - 2) * STAGE;
        self.matrix.reset(order);
        for v in [
            &mut self.gradient,
            &mut self.lagrangian,
            &mut self.objective,
            &mut self.arrow,
        ] {
            v.clear();
            v.resize(order, 0.0);
        }
        self.length = LengthEntries::default();
        self.add_steps(problem, set, lambda, mu);
        self.add_pairs(problem, x, set, mu);
        self.add_points(problem, x, set, mu);
        self.add_quads(problem, x, set, mu);
        self.add_smoothness(problem, x);
        if let Some(robot) = problem.frozen {
            self.freeze(robot);
        }
    }

    /// Takes a robot's poses out of the variables: no gradient, and a diagonal that no step overcomes.
    fn freeze(&mut self, robot: Side) {
        for b in (3 * robot.index()..self.gradient.len()).step_by(STAGE) {
            for v in b..b + 3 {
                for g in [
                    &mut self.gradient,
                    &mut self.lagrangian,
                    &mut self.objective,
                    &mut self.arrow,
                ] {
                    g[v] = 0.0;
                }
                self.matrix.add_lower(v, v, FROZEN);
            }
        }
    }

    fn add_steps(&mut self, problem: &Problem, set: &mut ActiveSet, lambda: &[f64], mu: f64) {
        let count = set.frames.len() / 2 + 1;
        let weight = problem.distance_weight();
        let bounds = problem.step_bounds();
        for i in 0..count - 1 {
            for robot in Side::BOTH {
                let at = 2 * i + robot.index();
                let step = set.frames[at];
                let mut d = StepDerivatives::default();
                let dual = 1.0 / DUAL_REGULARIZATION;
                d.gradients = [
                    [weight, lambda[at] + dual * step.across, 0.0],
                    [weight, lambda[at], 0.0],
                    [weight, 0.0, 0.0],
                ];
                d.diagonal[1] = dual;
                let rows = &mut set.steps[at * STEP_BOUNDS..(at + 1) * STEP_BOUNDS];
                for (row, bound) in rows.iter_mut().zip(&bounds) {
                    row.c = bound.value(&step);
                    row.gradient = [bound.sign];
                    let condensed = row.condense(mu);
                    let k = bound.coordinate.index();
                    d.gradients[0][k] -= condensed.force * bound.sign;
                    d.gradients[1][k] -= row.z * bound.sign;
                    d.diagonal[k] += condensed.sigma;
                }
                d.bend(&step, lambda[at]);
                self.scatter_step(i, robot, count, &step, &d);
            }
        }
    }

    pub(crate) fn scatter_step(
        &mut self,
        i: usize,
        robot: Side,
        count: usize,
        step: &Step,
        d: &StepDerivatives,
    ) {
        let (c, s, u, v) = (step.cos, step.sin, step.along, step.across);
        let [huu, hvv, htt] = d.diagonal;
        // In (dx, dy, psi, turn); turn stands alone.
        let xx = c * c * huu + s * s * hvv;
        let xy = c * s * (huu - hvv);
        let yy = s * s * huu + c * c * hvv;
        let xp = c * (v * huu + d.lateral) + s * u * hvv;
        let yp = s * (v * huu + d.lateral) - c * u * hvv;
        let pp = v * v * huu + u * u * hvv + d.taut;
        let first = base(i, count).map(|b| b + 3 * robot.index());
        let second = base(i + 1, count).map(|b| b + 3 * robot.index());
        for (end, sign) in [(first, -1.0), (second, 1.0)] {
            let Some(b) = end else { continue };
            for (target, g) in [
                &mut self.gradient,
                &mut self.lagrangian,
                &mut self.objective,
            ]
            .into_iter()
            .zip(&d.gradients)
            {
                target[b] += sign * (c * g[0] - s * g[1]);
                target[b + 1] += sign * (s * g[0] + c * g[1]);
                target[b + 2] += 0.5 * (v * g[0] - u * g[1]) + sign * g[2];
            }
            self.matrix.add_lower(b, b, xx);
            self.matrix.add_lower(b + 1, b, xy);
            self.matrix.add_lower(b + 1, b + 1, yy);
            self.matrix.add_lower(b + 2, b, 0.5 * sign * xp);
            self.matrix.add_lower(b + 2, b + 1, 0.5 * sign * yp);
            self.matrix.add_lower(b + 2, b + 2, 0.25 * pp + htt);
        }
        if let (Some(a), Some(b)) = (first, second) {
            self.matrix.add_lower(b, a, -xx);
            self.matrix.add_lower(b, a + 1, -xy);
            self.matrix.add_lower(b, a + 2, 0.5 * xp);
            self.matrix.add_lower(b + 1, a, -xy);
            self.matrix.add_lower(b + 1, a + 1, -yy);
            self.matrix.add_lower(b + 1, a + 2, 0.5 * yp);
            self.matrix.add_lower(b + 2, a, -0.5 * xp);
            self.matrix.add_lower(b + 2, a + 1, -0.5 * yp);
            self.matrix.add_lower(b + 2, a + 2, 0.25 * pp - htt);
        }
    }

    fn add_pairs(&mut self, problem: &Problem, x: &Iterate, set: &mut ActiveSet, mu: f64) {
        let count = x.stages.len();
        let expansion = problem.expansion();
        let mut rows = set.pairs.iter_mut().peekable();
        for i in 0..count {
            let z = x.pair(i);
            let mut local = Local::new();
            local.add_cost(&expansion.convex_jet(&z));
            while let Some(pair) = rows.next_if(|r| r.stage as usize == i) {
                let slope = problem.pair_term(pair.kind, i, slope_of(&z));
                local.add_row(&mut pair.row, slope, mu);
            }
            self.scatter_pair(base(i, count), &local);
        }
    }

    /// `rx = lx - rx`, `ry = ly - ry`, both headings, net length.
    #[inline]
    pub(crate) fn scatter_pair(&mut self, base: Option<usize>, local: &Local<PAIR>) {
        /// (variable of the stage, local coordinate, sign)
        const MAP: [(usize, usize, f64); STAGE] = [
            (0, 0, 1.0),
            (1, 1, 1.0),
            (2, 2, 1.0),
            (3, 0, -1.0),
            (4, 1, -1.0),
            (5, 3, 1.0),
        ];
        const LENGTH: usize = 4;
        self.length.diagonal += local.hessian[LENGTH][LENGTH];
        self.length.gradient += local.gradient[LENGTH];
        self.length.lagrangian += local.lagrangian[LENGTH];
        self.length.objective += local.objective[LENGTH];
        let Some(b) = base else { return };
        for (v, k, sign) in MAP {
            self.gradient[b + v] += sign * local.gradient[k];
            self.lagrangian[b + v] += sign * local.lagrangian[k];
            self.objective[b + v] += sign * local.objective[k];
            self.arrow[b + v] += sign * local.hessian[k][LENGTH];
            for &(w, m, other) in &MAP[..=v] {
                self.matrix
                    .add_lower(b + v, b + w, sign * other * local.hessian[k][m]);
            }
        }
    }

    fn add_points(&mut self, problem: &Problem, x: &Iterate, set: &mut ActiveSet, mu: f64) {
        let count = x.stages.len();
        for point in &mut set.points {
            let (stage, robot) = (point.stage as usize, point.robot);
            let z = x.point(stage, robot);
            let slope = problem.point_term(&point.kind, slope_of(&z));
            let mut local = Local::<POINT>::new();
            local.add_row(&mut point.row, slope, mu);
            if let Some(b) = base(stage, count) {
                self.scatter_block(b + 3 * robot.index(), [0, 1], &local);
            }
        }
    }

    fn add_quads(&mut self, problem: &Problem, x: &Iterate, set: &mut ActiveSet, mu: f64) {
        let count = x.stages.len();
        for quad in &mut set.quads {
            let step = quad.step as usize;
            let term = problem.quad_distance(quad.piece, quad.tier);
            let mut local = Local::<QUAD>::new();
            local.add_row(&mut quad.row, term.slope(&x.quad(step)), mu);
            self.scatter_quad(step, count, &local);
        }
    }

    /// Positions of both robots at both ends of a step.
    pub fn scatter_quad(&mut self, step: usize, count: usize, local: &Local<QUAD>) {
        const VARIABLES: [usize; 4] = [0, 1, 3, 4];
        for k in 0..QUAD {
            let Some(b) = base(step + k / 4, count) else {
                continue;
            };
            let v = b + VARIABLES[k % 4];
            self.gradient[v] += local.gradient[k];
            self.lagrangian[v] += local.lagrangian[k];
            self.objective[v] += local.objective[k];
            for m in 0..=k {
                if let Some(c) = base(step + m / 4, count) {
                    self.matrix
                        .add_lower(v, c + VARIABLES[m % 4], local.hessian[k][m]);
                }
            }
        }
    }

    /// Local coordinates that are variables of one stage, ascending.
    #[inline]
    pub(crate) fn scatter_block<const K: usize>(
        &mut self,
        b: usize,
        variables: [usize; K],
        local: &Local<K>,
    ) {
        for (k, &v) in variables.iter().enumerate() {
            self.gradient[b + v] += local.gradient[k];
            self.lagrangian[b + v] += local.lagrangian[k];
            self.objective[b + v] += local.objective[k];
            for (m, &w) in variables[..=k].iter().enumerate() {
                self.matrix.add_lower(b + v, b + w, local.hessian[k][m]);
            }
        }
    }

    /// Second differences of all coordinates: `sum b (z[i-1] - 2 z[i] + z[i+1])^2` (paper's J_s with unit step).
    fn add_smoothness(&mut self, problem: &Problem, x: &Iterate) {
        const STENCIL: [f64; 3] = [1.0, -2.0, 1.0];
        let weights = problem.smoothness();
        let count = x.stages.len();
        for i in 1..count - 1 {
            for v in 0..STAGE {
                let w = 2.0 * weights[v % 3];
                let difference = x.stages[i - 1][v] - 2.0 * x.stages[i][v] + x.stages[i + 1][v];
                for (p, a) in STENCIL.iter().enumerate() {
                    let Some(row) = base(i + p - 1, count) else {
                        continue;
                    };
                    let g = w * difference * a;
                    self.gradient[row + v] += g;
                    self.lagrangian[row + v] += g;
                    self.objective[row + v] += g;
                    for (q, b) in STENCIL[..=p].iter().enumerate() {
                        if let Some(column) = base(i + q - 1, count) {
                            self.matrix.add_lower(row + v, column + v, w * a * b);
                        }
                    }
                }
            }
        }
    }
}
