/// What drives a robot for the coming step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RobotDrive {
    /// Torques of the wheels, N m; clamped to `max_torque`, and so that no wheel pushes harder than half the traction.
    Torques {
        /// Left wheel.
        left: f64,
        /// Right wheel.
        right: f64,
    },
    /// Speeds to hold.
    Velocity {
        /// Along the heading, m/s.
        forward: f64,
        /// Turning rate, rad/s.
        turn_rate: f64,
    },
}

impl RobotDrive {
    /// Wheels that roll freely.
    pub const COAST: Self = Self::Torques {
        left: 0.0,
        right: 0.0,
    };
}
