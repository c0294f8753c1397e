use pairtrawl_model::{Robot, Scales};

/// How hard the pair may accelerate, whatever makes it do so: a start, a stop, a turn of the curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceLimits {
    /// Greatest change of a robot's speed, m/s^2.
    pub linear: f64,
    /// Greatest change of a robot's turning rate, rad/s^2.
    pub angular: f64,
}

/// Time in which the default robot may go from rest to its greatest speed, s: 0.26 m/s by 0.7 m/s^2.
const TO_FULL_SPEED: f64 = 0.26 / 0.7;
/// Time in which the default robot may go from rest to turning on the spot at full wheel speed, s: by 3.5 rad/s^2.
const TO_FULL_TURN: f64 = 0.26 / 0.144 / 3.5;

impl ReferenceLimits {
    /// Limits that a robot keeps with ease: 0.7 m/s^2 and 3.5 rad/s^2 for the default one, and for others such that they need
    /// as long to reach their greatest speed and turning rate, in times that grow with the root of their size.
    pub fn of(robot: &Robot) -> Self {
        let turning = robot.omega_max.min(robot.v_max / robot.half_track);
        // Times grow with the root of the size, as everything does that moves under gravity.
        let time = Scales::of_robot(robot).length.sqrt();
        Self {
            linear: robot.v_max / (TO_FULL_SPEED * time),
            angular: turning / (TO_FULL_TURN * time),
        }
    }
}
