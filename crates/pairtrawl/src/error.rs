use crate::Stage;
use crate::attempt::Attempt;
use pairtrawl_geometry::Point;
use pairtrawl_model::numbers::length;
use pairtrawl_model::{ClaimId, Rehearsal, SolverStatus};
use pairtrawl_route::RouteError;
use pairtrawl_simulation::SimulationError;
use pairtrawl_world::WorldError;

/// Why there is no plan.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// The scene or the options cannot be planned for, whatever the planner does.
    #[error("{what}")]
    BadInput {
        /// The thing, its value, the bound and the remedy.
        what: String,
    },
    /// There is a proof that no plan exists.
    #[error("proven infeasible: {proof}")]
    Infeasible {
        /// The proof in words and numbers, and the smallest change that would help.
        proof: String,
    },
    /// No certified plan was found within the budget. That is no proof that there is none.
    #[error("no certified plan found: {reason}")]
    NoPlan {
        /// What fails, in words and numbers.
        reason: String,
        /// The claim that fails in the best attempt.
        claim: Option<ClaimId>,
        /// At which step.
        step: Option<usize>,
        /// Where, m.
        place: Option<Point>,
        /// By how much, in the claim's unit; negative.
        margin: Option<f64>,
        /// What change would help.
        remedy: String,
    },
    /// The time limit ran out.
    #[error("the time limit of {limit} s ran out in the stage {}", stage.name())]
    TimeLimit {
        /// The limit, s.
        limit: f64,
        /// The stage at work.
        stage: Stage,
    },
    /// The observer asked to stop.
    #[error("interrupted")]
    Interrupted,
}

impl PlanError {
    /// There was not even a start to try.
    pub(crate) fn no_start() -> Self {
        Self::NoPlan {
            reason: "there is nothing to start from".to_owned(),
            claim: None,
            step: None,
            place: None,
            margin: None,
            remedy: "report this scene".to_owned(),
        }
    }

    /// What would help, when the message does not say so itself.
    pub fn remedy(&self) -> Option<&str> {
        match self {
            Self::NoPlan { remedy, .. } => Some(remedy),
            Self::TimeLimit { .. } => Some("give more time, or fewer waypoints"),
            Self::Infeasible { .. } | Self::BadInput { .. } | Self::Interrupted => None,
        }
    }

    /// The course that was found takes more steps than there are waypoints for.
    fn too_few_waypoints(best: &Attempt, max_step: f64) -> Option<Self> {
        let (left, right) = best.baseline.path_lengths();
        let course = left.max(right);
        let waypoints = best.baseline.len();
        let reach = waypoints.saturating_sub(1) as f64 * max_step;
        (course > reach).then(|| {
            let needed = (course / max_step).ceil() as usize + 1;
            Self::NoPlan {
                reason: format!(
                    "{waypoints} waypoints with steps of at most {} cover {}, but the course found is {} long",
                    length(max_step),
                    length(reach),
                    length(course)
                ),
                claim: Some(ClaimId::Step),
                step: None,
                place: None,
                margin: Some(reach - course),
                remedy: format!(
                    "give at least {needed} waypoints (planner.waypoints, --waypoints), leave their number to the planner, or \
                     raise planner.max_step"
                ),
            }
        })
    }

    /// After the last round: the claim that failed most in the best attempt. `max_step` in m.
    pub(crate) fn no_plan(best: &Attempt, rounds: usize, max_step: f64) -> Self {
        if let Some(error) = Self::too_few_waypoints(best, max_step) {
            return error;
        }
        let worst = best
            .certificate
            .claims
            .iter()
            .filter(|claim| !claim.holds)
            .min_by(|a, b| a.margin.total_cmp(&b.margin));
        let solver = match best.solver.status {
            SolverStatus::Converged => "the optimizer converged",
            SolverStatus::LocallyInfeasible => {
                "the optimizer found no way to meet all constraints nearby"
            }
            SolverStatus::IterationLimit => "the optimizer ran out of iterations",
            SolverStatus::TimeLimit => "the optimizer was stopped",
            SolverStatus::NumericalTrouble => "the optimizer broke down numerically",
            SolverStatus::NotStated => "how it was found is not known",
        };
        let Some(worst) = worst else {
            return Self::NoPlan {
                reason: format!("in {rounds} rounds {solver}"),
                claim: None,
                step: None,
                place: None,
                margin: None,
                remedy: "report this scene".to_owned(),
            };
        };
        let mut reason = format!(
            "after {rounds} rounds {} fails by {:.3e}",
            worst.id, -worst.margin
        );
        if let Some(step) = worst.step {
            reason += &format!(" at step {step}");
        }
        if let Some(place) = worst.place {
            reason += &format!(" near ({:.3}, {:.3})", place.x, place.y);
        }
        if !worst.detail.is_empty() {
            reason += &format!(" ({})", worst.detail);
        }
        Self::NoPlan {
            reason: format!("{reason}; {solver}"),
            claim: Some(worst.id),
            step: worst.step,
            place: worst.place,
            margin: Some(worst.margin),
            remedy: worst.id.remedy().to_owned(),
        }
    }

    /// No attempt passed its rehearsal, and one was required.
    pub(crate) fn not_rehearsed(verdict: &Rehearsal) -> Self {
        let (reason, place) = match verdict {
            Rehearsal::Failed { event, time, place } => (
                format!(
                    "the rehearsal fails: {event} after {time:.1} s near ({:.3}, {:.3})",
                    place.x, place.y
                ),
                Some(*place),
            ),
            Rehearsal::Passed | Rehearsal::Skipped => ("there was no rehearsal".to_owned(), None),
        };
        Self::NoPlan {
            reason,
            claim: None,
            step: None,
            place,
            margin: None,
            remedy: "raise planner.clearance or lower planner.max_skew, or take the certified plan without \
                     --require-rehearsal"
                .to_owned(),
        }
    }
}

impl From<WorldError> for PlanError {
    fn from(error: WorldError) -> Self {
        Self::BadInput {
            what: error.to_string(),
        }
    }
}

impl From<SimulationError> for PlanError {
    fn from(error: SimulationError) -> Self {
        Self::BadInput {
            what: error.to_string(),
        }
    }
}

impl From<RouteError> for PlanError {
    fn from(error: RouteError) -> Self {
        match error {
            RouteError::NoPath { to, .. } => Self::NoPlan {
                reason: error.to_string(),
                claim: None,
                step: None,
                place: Some(to),
                margin: None,
                remedy: "widen the passage, or move the object or the end".to_owned(),
            },
            RouteError::SearchLimit { to, .. } => Self::NoPlan {
                reason: error.to_string(),
                claim: None,
                step: None,
                place: Some(to),
                margin: None,
                remedy: "place the objects so that the pair passes them on a way with fewer dead ends, make the area smaller, \
                         or try the other search (--centerline)"
                    .to_owned(),
            },
            RouteError::BadOrder { .. }
            | RouteError::BadCenterline { .. }
            | RouteError::TooFewWaypoints { .. } => Self::BadInput {
                what: error.to_string(),
            },
        }
    }
}
