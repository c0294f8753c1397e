//! The condensed Newton system: band matrix over the inner stages, one dense row for the net length.

use crate::iterate::STAGE;
use crate::linear::BandMatrix;
use crate::local::Local;
use crate::step::{Coordinate, Step};
use crate::term::{BEND, Jet, STEP};
use pairtrawl_model::Side;

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
    /// That of `along` against the way across.
    cross: f64,
}

impl StepDerivatives {
    /// Adds what was gathered in one coordinate.
    #[inline]
    pub fn add(&mut self, coordinate: Coordinate, local: &Local<STEP>) {
        let k = coordinate.index();
        self.gradients[0][k] += local.gradient[0];
        self.gradients[1][k] += local.lagrangian[0];
        self.gradients[2][k] += local.objective[0];
        self.diagonal[k] += local.hessian[0][0];
    }

    /// Adds a cost that is linear in one coordinate.
    #[inline]
    pub fn add_cost(&mut self, coordinate: Coordinate, jet: &Jet<STEP>) {
        for gradient in &mut self.gradients {
            gradient[coordinate.index()] += jet.gradient[0];
        }
    }

    /// Curvature of the Lagrangian over a step, made positive semidefinite.
    ///
    /// With `u` along and `v` across, `tension * u + lambda * v` has the Hessian
    /// `2 tension dv dpsi - tension u dpsi^2 - 2 lambda du dpsi`. On the linearized slip `dv = u dpsi` its first two terms
    /// are those of a taut string, `tension u dpsi^2`; the last one is kept as far as the curvature in `u` that the step's
    /// bounds give carries it.
    #[inline]
    pub fn bend(&mut self, step: &Step, lambda: f64) {
        let tension = self.gradients[1][0];
        self.taut = (tension * step.along).max(0.0);
        let most = 0.9 * (self.diagonal[0] * self.taut).sqrt();
        self.lateral = -lambda.max(-most).min(most);
    }
}

impl StepDerivatives {
    /// Curvature of the Lagrangian `tension * u + lambda * v` over a step: with the way `w = cos ddy - sin ddx` across and
    /// `a = cos ddx + sin ddy` along, `2 tension w dpsi - tension u dpsi^2 - 2 lambda a dpsi - lambda v dpsi^2`.
    pub fn bend_exactly(&mut self, step: &Step, lambda: f64) {
        let tension = self.gradients[1][0];
        self.taut = -(tension * step.along + lambda * step.across);
        self.lateral = -lambda;
        self.cross = tension;
    }
}

/// A variable that a local coordinate moves with: its index among those of the inner stages, the coordinate, and 1 or -1.
pub(crate) type Variable = (usize, usize, f64);

impl System {
    /// Everything zero, for a course with this number of waypoints.
    pub fn reset(&mut self, waypoints: usize) {
        let order = (waypoints - 2) * STAGE;
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
    }

    /// Index of a stage's first variable among the inner stages; `None` for the fixed ends.
    #[inline]
    pub fn base(&self, stage: usize) -> Option<usize> {
        let b = stage.checked_sub(1)? * STAGE;
        (b < self.gradient.len()).then_some(b)
    }

    /// Adds what was gathered in local coordinates to their variables, which ascend.
    #[inline(always)]
    pub fn scatter<const K: usize>(&mut self, variables: &[Variable], local: &Local<K>) {
        for (n, &(v, k, sign)) in variables.iter().enumerate() {
            self.gradient[v] += sign * local.gradient[k];
            self.lagrangian[v] += sign * local.lagrangian[k];
            self.objective[v] += sign * local.objective[k];
            for &(w, m, other) in &variables[..=n] {
                self.matrix
                    .add_lower(v, w, sign * other * local.hessian[k][m]);
            }
        }
    }

    /// Adds what was gathered in a local coordinate that is the net length, and its mixed derivatives with the others.
    #[inline]
    pub fn scatter_length<const K: usize>(
        &mut self,
        variables: &[Variable],
        length: usize,
        local: &Local<K>,
    ) {
        self.length.diagonal += local.hessian[length][length];
        self.length.gradient += local.gradient[length];
        self.length.lagrangian += local.lagrangian[length];
        self.length.objective += local.objective[length];
        for &(v, k, sign) in variables {
            self.arrow[v] += sign * local.hessian[k][length];
        }
    }

    /// Adds what was gathered of one variable at an inner waypoint and both of its neighbors.
    #[inline]
    pub fn scatter_bend(&mut self, stage: usize, variable: usize, local: &Local<BEND>) {
        let bases = [stage - 1, stage, stage + 1].map(|i| self.base(i));
        let of = |k: usize| (bases[k].unwrap_or(0) + variable, k, 1.0);
        let variables = [of(0), of(1), of(2)];
        if let [Some(_), _, Some(_)] = bases {
            self.scatter(&variables, local);
        } else {
            let (from, to) = (
                usize::from(bases[0].is_none()),
                3 - usize::from(bases[2].is_none()),
            );
            self.scatter(&variables[from..to], local);
        }
    }

    /// Adds the derivatives of a robot over the step from waypoint `i`, whose frame turns with the headings.
    pub fn scatter_step(&mut self, i: usize, robot: Side, step: &Step, d: &StepDerivatives) {
        let (c, s, u, v) = (step.cos, step.sin, step.along, step.across);
        let [huu, hvv, htt] = d.diagonal;
        // In (dx, dy, psi, turn); turn stands alone.
        let xx = c * c * huu + s * s * hvv;
        let xy = c * s * (huu - hvv);
        let yy = s * s * huu + c * c * hvv;
        let xp = c * (v * huu + d.lateral) + s * u * hvv - s * d.cross;
        let yp = s * (v * huu + d.lateral) - c * u * hvv + c * d.cross;
        let pp = v * v * huu + u * u * hvv + d.taut;
        let first = self.base(i).map(|b| b + 3 * robot.index());
        let second = self.base(i + 1).map(|b| b + 3 * robot.index());
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

    /// Takes a robot's poses out of the variables: no gradient, and a diagonal that no step overcomes.
    pub fn freeze(&mut self, robot: Side) {
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
}
