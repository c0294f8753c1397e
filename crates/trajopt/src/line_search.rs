//! Moving along the Newton direction: the longest of a few step lengths that the filter accepts.

use crate::filter::Point;
use crate::problem::Problem;
use crate::state::State;
use crate::workspace::Workspace;

const SHORTEST_STEP: f64 = 1e-6;

impl Workspace {
    /// Moves the state along the direction of `self.newton`.
    pub fn line_search(&mut self, problem: &Problem, state: &mut State, longest: f64) {
        let mu = state.mu;
        let start = Point {
            theta: state.merit.theta,
            phi: state.merit.phi(mu),
        };
        let slope = self.newton.slope(&self.system);
        let mut alpha = longest;
        let reached = loop {
            self.trial
                .assign_stepped(&state.x, alpha, &self.newton.direction);
            let merit = state.set.trial_merit(problem, &self.trial, alpha);
            let point = Point {
                theta: merit.theta,
                phi: merit.phi(mu),
            };
            if self.filter.accepts(start, point, alpha, slope) {
                break merit;
            }
            alpha *= 0.5;
            if alpha < SHORTEST_STEP {
                // Nothing to be gained here by shorter steps: go a little, with a fresh filter.
                self.filter.clear();
                break merit;
            }
        };
        let taken = alpha.max(SHORTEST_STEP.min(longest));
        let merit = if taken == alpha {
            reached
        } else {
            self.trial
                .assign_stepped(&state.x, taken, &self.newton.direction);
            state.set.trial_merit(problem, &self.trial, taken)
        };
        state.promise = slope.abs();
        std::mem::swap(&mut state.x, &mut self.trial);
        state.residuals = state.set.advance(taken, mu);
        state.merit = merit;
    }
}
