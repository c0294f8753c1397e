use crate::Stage;
use pairtrawl_geometry::Point;

/// Why there is no plan.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// The scene or the options cannot be planned for, whatever the planner does.
    #[error("{what}")]
    BadInput {
        /// The thing, its value and the bound.
        what: String,
        /// What to change.
        remedy: Option<String>,
    },
    /// There is a proof that no plan exists.
    #[error("proven infeasible: {proof}")]
    Infeasible {
        /// The proof in words and numbers.
        proof: String,
        /// The smallest change that would help.
        remedy: Option<String>,
    },
    /// No certified plan was found within the budget. That is no proof that there is none.
    #[error("no certified plan found: {reason}")]
    NoPlan {
        /// What fails, in words and numbers.
        reason: String,
        /// The claim that fails in the best attempt.
        claim: Option<String>,
        /// Where, m.
        place: Option<Point>,
        /// At which step.
        step: Option<usize>,
        /// By how much, in the claim's unit; negative.
        margin: Option<f64>,
        /// What change would help.
        remedy: Option<String>,
        /// Optimizations that were tried.
        rounds: usize,
    },
    /// The time limit ran out.
    #[error("the time limit of {limit} s ran out after the stage {}", stage.name())]
    TimeLimit {
        /// The limit, s.
        limit: f64,
        /// The last stage that ran.
        stage: Stage,
    },
    /// The observer asked to stop.
    #[error("interrupted")]
    Interrupted,
}

impl PlanError {
    /// What would help, when that is known.
    pub fn remedy(&self) -> Option<&str> {
        match self {
            Self::BadInput { remedy, .. }
            | Self::Infeasible { remedy, .. }
            | Self::NoPlan { remedy, .. } => remedy.as_deref(),
            Self::TimeLimit { .. } => Some("give more time, fewer waypoints or a larger max_step"),
            Self::Interrupted => None,
        }
    }
}
