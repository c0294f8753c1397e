//! The speed loop of the wheels: each pushes in proportion to its speed error.

use crate::{Parameters, RobotState};

/// Bandwidth, 1/s.
const WHEEL: f64 = 150.0;

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
