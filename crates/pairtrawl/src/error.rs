use crate::infeasible::Infeasible;
use crate::not_found::NotFound;
use crate::observer::Stage;
use pairtrawl_execution::ExecutionError;
use pairtrawl_geometry::Point;
use pairtrawl_model::{Claim, SolverStatus, numbers};
use pairtrawl_reference::ReferenceError;
use pairtrawl_route::RouteError;
use pairtrawl_world::WorldError;
use std::fmt;

/// Why there is no plan.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// The scene or the options cannot be planned for, whatever the planner does.
    #[error(transparent)]
    BadInput(BadInput),
    /// There are proofs that no plan exists, or none that gathers everything.
    #[error("proven infeasible: {0}")]
    Infeasible(Infeasible),
    /// No certified plan was found within the budget. That is no proof that there is none.
    #[error("no certified plan found: {0}")]
    NoPlan(Box<NotFound>),
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

/// What cannot be planned for, and which part of the planner says so.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BadInput {
    /// The occupancy grid and the obstacles.
    #[error(transparent)]
    World(#[from] WorldError),
    /// Order, centerline and baseline.
    #[error(transparent)]
    Route(#[from] RouteError),
    /// The rehearsal.
    #[error(transparent)]
    Rehearsal(#[from] ExecutionError),
}

/// What is missing in the best attempt at a plan.
#[derive(Clone, Debug, PartialEq)]
pub enum NoPlan {
    /// A claim fails in all rounds.
    ClaimFails {
        /// The claim that fails by most in the best attempt.
        claim: Claim,
        /// How many rounds were made.
        rounds: usize,
        /// How the optimizer ended.
        solver: SolverStatus,
    },
    /// The course that was found takes more steps than there are waypoints for.
    TooFewWaypoints {
        /// The waypoints that were asked for.
        waypoints: usize,
        /// The longest step, m.
        max_step: f64,
        /// How far the robot with the longer path drives, m.
        course: f64,
    },
    /// No way leads past the obstacles, or none was found.
    NoRoute(RouteError),
    /// No smooth curve leads through the waypoints that were found.
    NoReference(ReferenceError),
    /// Everything is proven, but no rehearsal passed, and one was required.
    RehearsalFails {
        /// What happened first.
        event: String,
        /// When, s.
        time: f64,
        /// Where, m.
        place: Point,
    },
    /// There was no start to try.
    NoStart,
}

impl PlanError {
    /// What would help, when the message does not say so itself.
    pub fn remedy(&self) -> Option<String> {
        match self {
            Self::NoPlan(not_found) => not_found.remedy(),
            Self::TimeLimit { .. } => Some("give more time, or fewer waypoints".to_owned()),
            Self::Infeasible(infeasible) => infeasible.remedy(),
            Self::BadInput(_) | Self::Interrupted => None,
        }
    }
}

impl NoPlan {
    /// The claim that fails.
    pub fn claim(&self) -> Option<&Claim> {
        match self {
            Self::ClaimFails { claim, .. } => Some(claim),
            Self::TooFewWaypoints { .. }
            | Self::NoRoute(_)
            | Self::NoReference(_)
            | Self::RehearsalFails { .. }
            | Self::NoStart => None,
        }
    }

    /// Where it fails, m.
    pub fn place(&self) -> Option<Point> {
        match self {
            Self::ClaimFails { claim, .. } => claim.place,
            Self::NoRoute(RouteError::NoPath { to, .. } | RouteError::SearchLimit { to, .. }) => {
                Some(*to)
            }
            Self::RehearsalFails { place, .. } => Some(*place),
            Self::TooFewWaypoints { .. }
            | Self::NoRoute(_)
            | Self::NoReference(_)
            | Self::NoStart => None,
        }
    }

    /// What would help, when the message does not say so itself.
    pub fn remedy(&self) -> Option<String> {
        let words = match self {
            Self::TooFewWaypoints {
                max_step, course, ..
            } => {
                let needed = (course / max_step).ceil() as usize + 1;
                return Some(format!(
                    "give at least {needed} waypoints (planner.waypoints, --waypoints), leave their number to the planner, \
                     or raise planner.max_step"
                ));
            }
            // What stopped early says nothing about the scene.
            Self::ClaimFails {
                solver: SolverStatus::IterationLimit | SolverStatus::NumericalTrouble,
                ..
            } => {
                "change what the optimizer starts from: more waypoints (--waypoints), another order (--order given) or \
                 another search (--centerline rrt-star); nothing says that the scene has no plan"
            }
            Self::ClaimFails { claim, .. } => claim.id.remedy(),
            Self::NoRoute(RouteError::SearchLimit { .. }) => {
                "try another seed or --centerline rrt-star, or a smaller area: nothing says that the way is closed"
            }
            Self::NoRoute(_) => "widen the passage, or move the object or the end",
            Self::RehearsalFails { .. } => {
                "raise planner.clearance or lower planner.max_skew, or take the certified plan without --require-rehearsal"
            }
            Self::NoReference(_) | Self::NoStart => "report this scene",
        };
        Some(words.to_owned())
    }
}

impl fmt::Display for NoPlan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ClaimFails {
                claim,
                rounds,
                solver,
            } => {
                let amount = numbers::quantity(-claim.margin, claim.id.unit());
                write!(f, "after {rounds} rounds {} fails by {amount}", claim.id)?;
                if let Some(step) = claim.step {
                    write!(f, " at step {step}")?;
                }
                if let Some(place) = claim.place {
                    write!(f, " near {}", numbers::place(place))?;
                }
                if !claim.detail.is_empty() {
                    write!(f, " ({})", claim.detail)?;
                }
                write!(f, "; {}", solver.describe())
            }
            Self::TooFewWaypoints {
                waypoints,
                max_step,
                course,
            } => {
                let reach = waypoints.saturating_sub(1) as f64 * max_step;
                let [max_step, reach, course] = [*max_step, reach, *course].map(numbers::length);
                write!(
                    f,
                    "{waypoints} waypoints with steps of at most {max_step} cover {reach}, but the course found is {course} long"
                )
            }
            Self::NoRoute(error) => error.fmt(f),
            Self::NoReference(error) => error.fmt(f),
            Self::RehearsalFails { event, time, place } => {
                let (time, place) = (numbers::duration(*time), numbers::place(*place));
                write!(f, "the rehearsal fails: {event} after {time} near {place}")
            }
            Self::NoStart => f.write_str("there is nothing to start from"),
        }
    }
}

impl From<WorldError> for PlanError {
    fn from(error: WorldError) -> Self {
        Self::BadInput(error.into())
    }
}

impl From<ExecutionError> for PlanError {
    fn from(error: ExecutionError) -> Self {
        Self::BadInput(error.into())
    }
}

impl From<ReferenceError> for PlanError {
    fn from(error: ReferenceError) -> Self {
        NoPlan::NoReference(error).into()
    }
}

impl From<RouteError> for PlanError {
    fn from(error: RouteError) -> Self {
        match error {
            RouteError::NoPath { .. } | RouteError::SearchLimit { .. } => {
                NoPlan::NoRoute(error).into()
            }
            RouteError::BadOrder { .. }
            | RouteError::BadCenterline { .. }
            | RouteError::TooFewWaypoints { .. } => Self::BadInput(error.into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_search_that_was_given_up_gets_another_remedy_than_a_closed_way() {
        let (from, to) = (Point::ZERO, Point::new(1.0, 2.0));
        let no_plan = |error: RouteError| match PlanError::from(error) {
            PlanError::NoPlan(not_found) => not_found.missing,
            other => panic!("{other}"),
        };
        let given_up = no_plan(RouteError::SearchLimit {
            from,
            to,
            states: 9,
        });
        assert_eq!(given_up.place(), Some(to));
        let remedy = given_up.remedy().unwrap();
        assert!(remedy.contains("another seed"), "{remedy}");
        let closed = no_plan(RouteError::NoPath { from, to });
        let remedy = closed.remedy().unwrap();
        assert!(remedy.contains("widen the passage"), "{remedy}");
    }
}
