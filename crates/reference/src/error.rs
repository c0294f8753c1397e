use thiserror::Error;

/// A trajectory that no reference can be made of.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ReferenceError {
    /// Too few poses, or not as many for each robot.
    #[error(
        "the plan has {left} and {right} waypoints: a reference needs the same number for both robots, at least 2"
    )]
    Waypoints {
        /// Of the left robot.
        left: usize,
        /// Of the right robot.
        right: usize,
    },
    /// A number is not finite, or the step time not positive.
    #[error(
        "waypoint {index} of the plan or its step time ({step_time} s) is not a usable number: plan again"
    )]
    NotFinite {
        /// The first bad waypoint; 0 when it is the step time.
        index: usize,
        /// The step time, s.
        step_time: f64,
    },
}
