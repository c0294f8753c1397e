use crate::infeasible::Infeasible;
use crate::no_plan::NoPlan;
use crate::not_found::NotFound;
use crate::observer::Stage;
use pairtrawl_execution::ExecutionError;
use pairtrawl_reference::ReferenceError;
use pairtrawl_route::RouteError;
use pairtrawl_world::WorldError;

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

impl From<NoPlan> for PlanError {
    fn from(missing: NoPlan) -> Self {
        Self::NoPlan(Box::new(missing.into()))
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
    use pairtrawl_geometry::Point;

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
