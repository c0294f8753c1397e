//! What costs and rows add to the condensed system, in their own coordinates.

use crate::row::{Condensed, Row};
use crate::term::Jet;

/// Gradient and Hessian gathered in local coordinates before they are scattered once.
pub(crate) struct Local<const K: usize> {
    pub gradient: [f64; K],
    pub lagrangian: [f64; K],
    pub objective: [f64; K],
    pub hessian: [[f64; K]; K],
}

impl<const K: usize> Local<K> {
    pub fn new() -> Self {
        Self {
            gradient: [0.0; K],
            lagrangian: [0.0; K],
            objective: [0.0; K],
            hessian: [[0.0; K]; K],
        }
    }

    /// What a row adds to matrix and gradient.
    pub fn of_row(g: &[f64; K], Condensed { sigma, force }: Condensed) -> Self {
        let mut local = Self::new();
        for i in 0..K {
            local.gradient[i] = -force * g[i];
            for j in 0..K {
                local.hessian[i][j] = sigma * g[i] * g[j];
            }
        }
        local
    }

    /// What a cost adds.
    #[inline]
    pub fn of_cost(jet: &Jet<K>) -> Self {
        Self {
            gradient: jet.gradient,
            lagrangian: jet.gradient,
            objective: jet.gradient,
            hessian: jet.hessian,
        }
    }

    /// Adds a cost.
    #[inline]
    pub fn add_cost(&mut self, jet: &Jet<K>) {
        for i in 0..K {
            self.gradient[i] += jet.gradient[i];
            self.lagrangian[i] += jet.gradient[i];
            self.objective[i] += jet.gradient[i];
            for j in 0..K {
                self.hessian[i][j] += jet.hessian[i][j];
            }
        }
    }

    /// Adds the curvature that a constraint with multiplier `z` has in the Lagrangian.
    pub fn add_bend(&mut self, jet: &Jet<K>, z: f64) {
        for (row, bend) in self.hessian.iter_mut().zip(&jet.hessian) {
            for (h, b) in row.iter_mut().zip(bend) {
                *h -= z * b;
            }
        }
    }

    /// Adds a row whose constraint has this gradient.
    ///
    /// Constraints lend no curvature of their own far from an optimum: what they have is mostly negative (distances from
    /// convex things are to be large), and small against that of the taut paths. See [`Self::add_bend`].
    #[inline]
    pub fn add_row(&mut self, row: &mut Row, gradient: &[f64; K], mu: f64) {
        let condensed = row.condense(mu);
        for i in 0..K {
            let g = gradient[i];
            self.gradient[i] -= condensed.force * g;
            self.lagrangian[i] -= row.z * g;
            let sg = condensed.sigma * g;
            for (h, other) in self.hessian[i].iter_mut().zip(gradient) {
                *h += sg * other;
            }
        }
    }
}
