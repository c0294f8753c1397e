use crate::Real;

/// Pose of a robot's reference point (axle center), map frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose<T> {
    /// x, m.
    pub x: T,
    /// y, m.
    pub y: T,
    /// phi, counter-clockwise from +x, rad. Any turn: the laws use its sine and cosine only.
    pub heading: T,
}

impl<T: Real> Pose<T> {
    /// True when all three numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.heading.is_finite()
    }
}

/// v = (nu, omega) of eq. 18, or its derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Velocity<T> {
    /// nu: forward speed of the axle center, m/s (m/s^2 for a derivative).
    pub linear: T,
    /// omega: turning rate, counter-clockwise, rad/s (rad/s^2 for a derivative).
    pub angular: T,
}

impl<T: Real> Velocity<T> {
    /// True when both numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.linear.is_finite() && self.angular.is_finite()
    }

    /// As (nu, omega).
    pub fn to_array(self) -> [T; 2] {
        [self.linear, self.angular]
    }

    /// From (nu, omega).
    pub fn from_array([linear, angular]: [T; 2]) -> Self {
        Self { linear, angular }
    }
}

/// tau_bar of eq. 21: what both wheels together do to the robot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyForce<T> {
    /// Forward force, N.
    pub force: T,
    /// Counter-clockwise torque about the vertical, N m.
    pub torque: T,
}

/// tau: torques of the wheels, N m, positive drives forward.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WheelTorque<T> {
    /// Right wheel.
    pub right: T,
    /// Left wheel.
    pub left: T,
}

impl<T: Real> WheelTorque<T> {
    /// True when both numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.right.is_finite() && self.left.is_finite()
    }
}

/// What the robot should do at an instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReferenceSample<T> {
    /// q_r.
    pub pose: Pose<T>,
    /// (nu_r, omega_r).
    pub velocity: Velocity<T>,
    /// Its time derivative.
    pub acceleration: Velocity<T>,
}

impl<T: Real> ReferenceSample<T> {
    /// True when every number is finite.
    pub fn is_finite(&self) -> bool {
        self.pose.is_finite() && self.velocity.is_finite() && self.acceleration.is_finite()
    }
}

/// What a law is told about the moment it runs in.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Step<T> {
    /// Time since the last call, s.
    pub dt: T,
    /// True when the last torque was cut by a limit: integrators and adaptation hold.
    pub saturated: bool,
}
