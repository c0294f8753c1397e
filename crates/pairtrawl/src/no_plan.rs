use pairtrawl_geometry::Point;
use pairtrawl_model::{Claim, SolverStatus, numbers};
use pairtrawl_reference::ReferenceError;
use pairtrawl_route::RouteError;
use std::fmt;

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
