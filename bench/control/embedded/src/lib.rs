//! Every entry of the controller in `f32`, not generic, so that machine code is made for a Cortex-M4F.
#![no_std]
#![forbid(unsafe_code)]

use pairtrawl_control::{
    ControllerParameters, IntegralGains, LawParameters, MracGains, PairState, PairSupervisor,
    ParameterError, Pose, ReferenceSample, RobotController, RobotReport, Velocity, WheelTorque,
};

/// A controller with the adaptive law and default gains.
#[inline(never)]
pub fn adaptive() -> Result<RobotController<f32>, ParameterError> {
    RobotController::new(&ControllerParameters::with_law(LawParameters::Mrac(
        MracGains::default(),
    )))
}

/// A controller with the integral law and default gains.
#[inline(never)]
pub fn integral() -> Result<RobotController<f32>, ParameterError> {
    RobotController::new(&ControllerParameters::with_law(LawParameters::Integral(
        IntegralGains::default(),
    )))
}

/// The tracker's step.
#[inline(never)]
pub fn track(
    controller: &mut RobotController<f32>,
    pose: &Pose<f32>,
    age: f32,
    reference: &ReferenceSample<f32>,
) {
    controller.track(pose, age, reference);
}

/// The torque loop's step.
#[inline(never)]
pub fn torque(
    controller: &mut RobotController<f32>,
    velocity: Velocity<f32>,
    dt: f32,
) -> WheelTorque<f32> {
    controller.torque(velocity, dt)
}

/// Ends a latched stop.
#[inline(never)]
pub fn rearm(controller: &mut RobotController<f32>) {
    controller.rearm();
}

/// The supervisor's step.
#[inline(never)]
pub fn supervise(
    s: &mut PairSupervisor<f32>,
    left: &RobotReport<f32>,
    right: &RobotReport<f32>,
) -> PairState {
    s.update(left, right)
}
