//! The last digits: Newton steps with the exact second derivatives, once a problem counts as solved.

use crate::curvature::Curvature;
use crate::settings::Settings;
use crate::state::State;
use crate::workspace::Workspace;
use pairtrawl_model::SolverStatus;

/// Bounds of the shift of the diagonal, which is as large as the dual residual: far from the optimum it keeps directions
/// that cost next to nothing from running away, near to it Newton's steps are left as they are.
const SHIFTS: [f64; 2] = [1e-6, 1.0];
/// Most steps. On 24 scenes the most that it took were 65.
const MOST_STEPS: usize = 150;
/// Factor of the barrier parameter.
const DECREASE: f64 = 0.1;
/// What the barrier may leave of the gap that is tolerated.
const GAP_SHARE: f64 = 0.2;

/// How far polishing has come.
pub(crate) struct Polish {
    tolerance: f64,
    steps: usize,
    /// The solved problem that it began with.
    begun_at: Option<State>,
}

/// Shift of the diagonal at a point.
pub(crate) fn shift(state: &State) -> f64 {
    state.residuals.dual.clamp(SHIFTS[0], SHIFTS[1])
}

impl Polish {
    pub fn new(settings: &Settings) -> Self {
        Self {
            tolerance: settings.tolerance,
            steps: 0,
            begun_at: None,
        }
    }

    pub fn is_on(&self) -> bool {
        self.begun_at.is_some()
    }

    /// True when the residual is as small as was asked for.
    pub fn is_over(&self, state: &State) -> bool {
        state.relative_residual() <= self.tolerance
    }

    pub fn is_spent(&self) -> bool {
        self.steps == MOST_STEPS
    }

    pub fn begin(&mut self, state: &State) {
        self.begun_at = Some(state.clone());
    }

    /// Goes back to where it began: the problem is solved there, though not to the last digits.
    pub fn give_up(self, state: &mut State) -> SolverStatus {
        if let Some(begun_at) = self.begun_at {
            let iterations = state.iterations;
            *state = begun_at;
            state.iterations = iterations;
        }
        SolverStatus::Converged
    }

    /// Counts a step.
    pub fn step(&mut self, state: &mut State) {
        self.steps += 1;
        state.iterations += 1;
    }

    pub fn curvature(&self) -> Curvature {
        if self.is_on() {
            Curvature::Exact
        } else {
            Curvature::Convex
        }
    }

    /// Lowers the barrier when the point is optimal for the present one, as far as the tolerance on the gap needs it.
    pub fn lower_barrier(&self, state: &mut State, work: &mut Workspace) {
        let r = &state.residuals;
        let tolerated = self.tolerance * state.merit.cost.abs().max(1.0);
        let least = GAP_SHARE * tolerated / r.products as f64;
        let solved = r.complementarity <= state.mu && r.dual <= self.tolerance.max(state.mu);
        if state.mu > least && solved {
            state.mu = (DECREASE * state.mu).max(least);
            work.filter.clear();
        }
    }
}
