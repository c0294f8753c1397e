/// How hard the pair may accelerate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceLimits {
    /// Greatest change of the pace, 1/s: 1 reaches the plan's speed in a second.
    pub pace_rate: f64,
    /// Greatest acceleration along a path that turns of speed between steps may ask for, m/s^2.
    pub linear: f64,
    /// The same for turning, rad/s^2.
    pub angular: f64,
}

impl Default for ReferenceLimits {
    fn default() -> Self {
        Self {
            pace_rate: 1.0,
            linear: 0.5,
            angular: 2.5,
        }
    }
}
