use pairtrawl_geometry::Pose;

/// Where a robot should be at an instant, and how it should move.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Pose of the axle center, map frame.
    pub pose: Pose,
    /// Speed along the heading, m/s.
    pub v: f64,
    /// Turning rate, counter-clockwise, rad/s.
    pub omega: f64,
    /// Change of the speed, m/s^2.
    pub v_dot: f64,
    /// Change of the turning rate, rad/s^2.
    pub omega_dot: f64,
}
