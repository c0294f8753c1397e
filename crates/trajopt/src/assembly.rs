//! The condensed Newton system: band matrix over the inner stages, one dense row for the net length.
//!
//! Slacks, violations and multipliers of the inequalities are eliminated row by row; the equalities (no sideways slip) by
//! dual regularization, `A dx + h = delta (lambda+ - lambda)`, which leaves `A^T A / delta` in the band.

use crate::active::{ActiveSet, STEP_ROWS, jet_of};
use crate::constraints::NoSidewaysSlip;
use crate::iterate::{Iterate, STAGE};
use crate::linear::BandMatrix;
use crate::problem::Problem;
use crate::row::Row;
use crate::term::{Jet, PAIR, POINT, RUNG, STEP, Term};

/// Dual regularization of the equalities.
pub(crate) const DUAL_REGULARIZATION: f64 = 1e-9;

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
    /// Its diagonal entry, condensed gradient, Lagrangian gradient, objective gradient.
    pub length: [f64; 4],
    /// Value and gradient of the slip of each robot-step, in its local coordinates.
    pub slips: Vec<(f64, [f64; STEP])>,
}

/// Gradient and Hessian gathered in local coordinates before they are scattered once.
struct Local<const K: usize> {
    gradient: [f64; K],
    lagrangian: [f64; K],
    objective: [f64; K],
    hessian: [[f64; K]; K],
}

impl<const K: usize> Local<K> {
    fn new() -> Self {
        Self {
            gradient: [0.0; K],
            lagrangian: [0.0; K],
            objective: [0.0; K],
            hessian: [[0.0; K]; K],
        }
    }

    #[inline]
    fn add_gradient(&mut self, jet: &Jet<K>) {
        for i in 0..K {
            self.gradient[i] += jet.gradient[i];
            self.lagrangian[i] += jet.gradient[i];
            self.objective[i] += jet.gradient[i];
        }
    }

    #[inline]
    fn add_cost(&mut self, jet: &Jet<K>) {
        self.add_gradient(jet);
        for i in 0..K {
            for j in 0..K {
                self.hessian[i][j] += jet.hessian[i][j];
            }
        }
    }

    #[inline]
    /// Constraints lend no curvature of their own: what they have is mostly negative (distances from convex things are to
    /// be large), and small against that of the taut paths.
    fn add_row(&mut self, row: &mut Row<K>, jet: &Jet<K>, mu: f64) {
        row.c = jet.value;
        row.gradient = jet.gradient;
        let condensed = row.condense(mu, row.residual());
        for i in 0..K {
            let g = jet.gradient[i];
            self.gradient[i] -= condensed.force * g;
            self.lagrangian[i] -= row.z * g;
            let sg = condensed.sigma * g;
            for j in 0..K {
                self.hessian[i][j] += sg * jet.gradient[j];
            }
        }
    }

    #[inline]
    fn add_equality(&mut self, jet: &Jet<K>, lambda: f64) {
        let weight = 1.0 / DUAL_REGULARIZATION;
        for i in 0..K {
            let g = jet.gradient[i];
            self.gradient[i] += (lambda + weight * jet.value) * g;
            self.lagrangian[i] += lambda * g;
            for j in 0..K {
                self.hessian[i][j] += weight * g * jet.gradient[j];
            }
        }
    }
}

/// Curvature of the Lagrangian over a step, made positive semidefinite.
///
/// With `u` along and `v` across the mid-step heading, `tension * s + lambda * h` has the Hessian
/// `2 tension dv dpsi - tension s dpsi^2 - 2 lambda du dpsi`. On the linearized slip `dv = s dpsi` its first two terms are
/// those of a taut string, `tension s dpsi^2`; the last one, `-2 lambda du dpsi`, is kept as far as the curvature in `u`
/// that step bounds give (`along`) carries it.
#[inline]
fn add_string(local: &mut Local<STEP>, psi: f64, s: f64, tension: f64, lambda: f64, along: f64) {
    let taut = (tension * s).max(0.0);
    let most = 0.9 * (along * taut).sqrt();
    let lateral = -lambda.clamp(-most, most);
    let (sin, cos) = psi.sin_cos();
    local.hessian[2][2] += taut;
    for (k, c) in [(0, cos), (1, sin)] {
        local.hessian[k][2] += lateral * c;
        local.hessian[2][k] += lateral * c;
    }
}

/// Index of a stage's first variable among the inner stages; `None` for the fixed ends.
#[inline]
fn base(stage: usize, count: usize) -> Option<usize> {
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
        self.length = [0.0; 4];
        self.slips
            .resize(2 * (x.stages.len() - 1), (0.0, [0.0; STEP]));
        self.add_steps(problem, x, set, lambda, mu);
        self.add_pairs(problem, x, set, mu);
        self.add_points(problem, x, set, mu);
        self.add_rungs(problem, x, set, mu);
        self.add_smoothness(problem, x);
    }

    fn add_steps(
        &mut self,
        problem: &Problem,
        x: &Iterate,
        set: &mut ActiveSet,
        lambda: &[f64],
        mu: f64,
    ) {
        let count = x.stages.len();
        let distance = problem.distance();
        for i in 0..count - 1 {
            for robot in 0..2 {
                let at = 2 * i + robot;
                let z = x.step(i, robot);
                let mut local = Local::new();
                local.add_gradient(&distance.jet(&z));
                let slip = NoSidewaysSlip.jet(&z);
                self.slips[at] = (slip.value, slip.gradient);
                local.add_equality(&slip, lambda[at]);
                for kind in 0..STEP_ROWS {
                    let jet = problem.step_term(kind, jet_of(&z));
                    local.add_row(&mut set.steps[at * STEP_ROWS + kind], &jet, mu);
                }
                let rows = &set.steps[at * STEP_ROWS..];
                let tension = distance.weight - rows[0].z + rows[1].z;
                let along = rows[0].sigma() + rows[1].sigma();
                add_string(&mut local, z[2], rows[0].c, tension, lambda[at], along);
                self.scatter_step(i, robot, count, &local);
            }
        }
    }

    /// `dx = x1 - x0`, `dy = y1 - y0`, `psi = (phi0 + phi1)/2`, `delta = phi1 - phi0`.
    #[inline]
    fn scatter_step(&mut self, i: usize, robot: usize, count: usize, local: &Local<STEP>) {
        let h = &local.hessian;
        let first = base(i, count).map(|b| b + 3 * robot);
        let second = base(i + 1, count).map(|b| b + 3 * robot);
        // Coefficients of each variable (x, y, heading) in the local coordinates, at both ends.
        let heading = |sign: f64| -> [f64; 2] { [0.5, sign] };
        let (h0, h1) = (heading(-1.0), heading(1.0));
        let bend = |a: [f64; 2], b: [f64; 2]| {
            a[0] * (b[0] * h[2][2] + b[1] * h[2][3]) + a[1] * (b[0] * h[3][2] + b[1] * h[3][3])
        };
        let mix = |k: usize, a: [f64; 2]| a[0] * h[k][2] + a[1] * h[k][3];
        for (end, sign, own) in [(first, -1.0, h0), (second, 1.0, h1)] {
            let Some(b) = end else { continue };
            for (target, source) in [
                (&mut self.gradient, &local.gradient),
                (&mut self.lagrangian, &local.lagrangian),
                (&mut self.objective, &local.objective),
            ] {
                target[b] += sign * source[0];
                target[b + 1] += sign * source[1];
                target[b + 2] += own[0] * source[2] + own[1] * source[3];
            }
            self.matrix.add_lower(b, b, h[0][0]);
            self.matrix.add_lower(b + 1, b, h[1][0]);
            self.matrix.add_lower(b + 1, b + 1, h[1][1]);
            self.matrix.add_lower(b + 2, b, sign * mix(0, own));
            self.matrix.add_lower(b + 2, b + 1, sign * mix(1, own));
            self.matrix.add_lower(b + 2, b + 2, bend(own, own));
        }
        if let (Some(a), Some(b)) = (first, second) {
            for p in 0..2 {
                for q in 0..2 {
                    self.matrix.add_lower(b + p, a + q, -h[p][q]);
                }
                self.matrix.add_lower(b + p, a + 2, mix(p, h0));
                self.matrix.add_lower(b + 2, a + p, -mix(p, h1));
            }
            self.matrix.add_lower(b + 2, a + 2, bend(h0, h1));
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
                let jet = problem.pair_term(pair.kind, jet_of(&z));
                local.add_row(&mut pair.row, &jet, mu);
            }
            self.scatter_pair(base(i, count), &local);
        }
    }

    /// `rx = lx - rx`, `ry = ly - ry`, both headings, net length.
    #[inline]
    fn scatter_pair(&mut self, base: Option<usize>, local: &Local<PAIR>) {
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
        self.length[0] += local.hessian[LENGTH][LENGTH];
        self.length[1] += local.gradient[LENGTH];
        self.length[2] += local.lagrangian[LENGTH];
        self.length[3] += local.objective[LENGTH];
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
            let (stage, robot) = (point.stage as usize, point.robot as usize);
            let z = x.point(stage, robot);
            let jet = problem.point_term(&point.kind, jet_of(&z));
            let mut local = Local::<POINT>::new();
            local.add_row(&mut point.row, &jet, mu);
            if let Some(b) = base(stage, count) {
                self.scatter_block(b + 3 * robot, [0, 1], &local);
            }
        }
    }

    fn add_rungs(&mut self, problem: &Problem, x: &Iterate, set: &mut ActiveSet, mu: f64) {
        let count = x.stages.len();
        for rung in &mut set.rungs {
            let stage = rung.stage as usize;
            let jet = problem.rung_distance(rung.piece).jet(&x.rung(stage));
            let mut local = Local::<RUNG>::new();
            local.add_row(&mut rung.row, &jet, mu);
            if let Some(b) = base(stage, count) {
                self.scatter_block(b, [0, 1, 3, 4], &local);
            }
        }
    }

    /// Local coordinates that are variables of one stage, ascending.
    #[inline]
    fn scatter_block<const K: usize>(&mut self, b: usize, variables: [usize; K], local: &Local<K>) {
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

/// Value of the objective.
pub(crate) fn objective(problem: &Problem, x: &Iterate) -> f64 {
    let (distance, expansion, weights) = (
        problem.distance(),
        problem.expansion(),
        problem.smoothness(),
    );
    let count = x.stages.len();
    let mut total = 0.0;
    for i in 0..count {
        total += expansion.value(&x.pair(i));
        if i + 1 < count {
            // Turning is -t2 delta plus an elastic row.
            for robot in 0..2 {
                let z = x.step(i, robot);
                total += distance.value(&z) - problem.turn_weight() * z[3];
            }
        }
        if i > 0 && i + 1 < count {
            for v in 0..STAGE {
                let difference = x.stages[i - 1][v] - 2.0 * x.stages[i][v] + x.stages[i + 1][v];
                total += weights[v % 3] * difference * difference;
            }
        }
    }
    total
}
