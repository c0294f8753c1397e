use pairtrawl_geometry::{Point, Pose};

/// Where a robot is and how it moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RobotState {
    /// Axle center and heading; the heading is continuous.
    pub pose: Pose,
    /// Velocity of the axle center along the heading, m/s.
    pub forward: f64,
    /// Velocity of the axle center across the heading (to the left), m/s: zero but for slip.
    pub sideways: f64,
    /// Turning rate, rad/s.
    pub turn_rate: f64,
}

/// What acted on a robot in the last step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RobotLoad {
    /// Force of the wheels along the heading, N.
    pub drive_force: f64,
    /// Wheel torques (left, right) after all limits, N m.
    pub torques: [f64; 2],
    /// Force of net and contacts on the robot in the map frame, by momentum balance, N.
    pub load: Point,
}
