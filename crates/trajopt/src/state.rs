//! The point that the solver is at, with everything that belongs to it.

use crate::active::ActiveSet;
use crate::iterate::Iterate;
use crate::merit::{Merit, Residuals};
use crate::problem::Problem;
use crate::row::Beginning;
use crate::settings::Settings;

/// A point with its multipliers.
#[derive(Clone, Debug, Default)]
pub(crate) struct State {
    pub x: Iterate,
    pub set: ActiveSet,
    /// Multipliers of the equalities, one for each robot and step.
    pub lambda: Vec<f64>,
    pub mu: f64,
    pub iterations: usize,
    pub residuals: Residuals,
    /// Merit of the point.
    pub merit: Merit,
    /// Decrease of the barrier function that the last full Newton step promised; infinite before the first.
    pub promise: f64,
}

impl State {
    pub fn new(problem: &Problem, x: Iterate, settings: &Settings) -> Self {
        let mu = settings.initial_mu;
        let beginning = Beginning {
            elastic: settings.elastic_weight,
            mu,
        };
        let set = ActiveSet::new(problem, &x, beginning);
        let lambda = vec![0.0; 2 * (x.stages.len() - 1)];
        let mut state = Self {
            x,
            set,
            lambda,
            mu,
            promise: f64::INFINITY,
            ..Self::default()
        };
        if settings.nearly_optimal {
            state.set.rows_mut().for_each(|row| row.presume_met(mu));
        }
        state.measure(problem);
        state
    }

    /// The relative optimality residual.
    pub fn relative_residual(&self) -> f64 {
        self.residuals.relative(self.merit.cost)
    }

    /// Merit and residuals of the point, but for the dual one.
    pub fn measure(&mut self, problem: &Problem) {
        (self.merit, self.residuals) = self.set.measure(problem, &self.x, self.mu);
    }
}
