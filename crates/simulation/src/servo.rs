//! The built-in drive: follows a reference closely, within the traction of the tires.
//!
//! Errors in the robot's frame, as in Kanayama's law: v = v_r cos e_phi + k1 e_x, w = w_r + k2 v_r e_y + k3 sin e_phi;
//! then each wheel pushes in proportion to its speed error. A robot that was held back catches up no faster than its wheels
//! can turn.

use crate::engine::unit;
use crate::{Parameters, RobotState};
use pairtrawl_geometry::Pose;

/// k1, 1/s.
const ALONG: f64 = 10.0;
/// k2, 1/m^2.
const ACROSS: f64 = 400.0;
/// k3, 1/s.
const TURN: f64 = 10.0;
/// How much faster than v_max a wheel may turn to catch up.
const HEADROOM: f64 = 1.2;
/// Bandwidth of the wheel speed loop, 1/s.
const WHEEL: f64 = 150.0;

/// What drives a robot for the coming step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RobotDrive {
    /// Torques of the wheels, N m; clamped to `max_torque`, the resulting thrust to the traction.
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
    /// A moving reference to stay on.
    Follow {
        /// Where to be.
        pose: Pose,
        /// Its speed along its heading, m/s.
        forward: f64,
        /// Its turning rate, rad/s.
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

/// Speeds that lead back to a moving reference; when a wheel would have to turn faster than the robot or its reference can,
/// both are scaled down.
pub(crate) fn track(
    parameters: &Parameters,
    state: &RobotState,
    pose: Pose,
    forward: f64,
    turn_rate: f64,
) -> (f64, f64) {
    let offset = pose.position() - state.pose.position();
    let ahead = unit(state.pose.heading);
    let (e_x, e_y) = (offset.dot(ahead), offset.dot(ahead.perp()));
    let (sin, cos) = libm::sincos(pose.heading - state.pose.heading);
    let v = forward * cos + ALONG * e_x;
    let w = turn_rate + ACROSS * forward * e_y + TURN * sin;
    let wheel = |v: f64, w: f64| v.abs() + parameters.robot.half_track * w.abs();
    let limit = HEADROOM * parameters.robot.v_max.max(wheel(forward, turn_rate));
    let scale = (limit / wheel(v, w)).min(1.0);
    (v * scale, w * scale)
}

/// Forces of the (left, right) wheel, N, that bring a robot to the given speeds.
pub(crate) fn wheel_forces(
    parameters: &Parameters,
    state: &RobotState,
    forward: f64,
    turn_rate: f64,
) -> [f64; 2] {
    let gain = 0.5 * parameters.physics.robot_mass * WHEEL;
    let reach = parameters.robot.half_track;
    let limit = parameters.physics.max_torque / parameters.physics.wheel_radius;
    let speed = forward - state.forward;
    let turn = turn_rate - state.turn_rate;
    [speed - reach * turn, speed + reach * turn].map(|error| (gain * error).clamp(-limit, limit))
}
