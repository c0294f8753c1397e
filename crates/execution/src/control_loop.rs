//! Two controllers, their sensors and the supervisor, around any pair of robots that takes wheel torques.

use crate::sample::control_sample;
use crate::sensing::{Sensing, Sensors, TORQUE_PERIOD, TRACKER_TICKS};
use pairtrawl_control::{
    AdaptedParameters, ControllerParameters, Mode, PairState, PairStopCause, PairSupervisor,
    ParameterError, Pose, RobotController, RobotReport, StopCause, SupervisorLimits, Velocity,
    WheelTorque,
};
use pairtrawl_reference::{Reference, Sample};

/// Where a robot is and how it moves.
#[derive(Clone, Copy, Debug, Default)]
pub struct Truth {
    /// Pose of the axle center, map frame.
    pub pose: Pose<f64>,
    /// Speed and turning rate.
    pub velocity: Velocity<f64>,
    /// Tension at the hitch, N.
    pub tension: f64,
}

/// The pair's controllers at work. Arrays over robots are (left, right).
pub struct PairLoop<'a> {
    reference: &'a Reference,
    controllers: [RobotController<f64>; 2],
    sensors: [Sensors; 2],
    supervisor: PairSupervisor<f64>,
    ticks: u64,
    now: [Sample; 2],
}

impl<'a> PairLoop<'a> {
    /// Controllers that are armed and sensors with these seeds.
    ///
    /// # Errors
    /// When a parameter is out of range.
    pub fn new(
        reference: &'a Reference,
        parameters: &ControllerParameters<f64>,
        supervisor: SupervisorLimits<f64>,
        sensing: [Sensing; 2],
        seeds: [u64; 2],
    ) -> Result<Self, ParameterError> {
        Ok(Self {
            reference,
            controllers: [
                RobotController::new(parameters)?,
                RobotController::new(parameters)?,
            ],
            sensors: [
                Sensors::new(sensing[0], seeds[0]),
                Sensors::new(sensing[1], seeds[1]),
            ],
            supervisor: PairSupervisor::new(supervisor)?,
            ticks: 0,
            now: reference.at(0.0),
        })
    }

    /// Time since the start, s.
    pub fn time(&self) -> f64 {
        self.ticks as f64 * TORQUE_PERIOD
    }

    /// The reference of the last tick.
    pub fn reference(&self) -> &[Sample; 2] {
        &self.now
    }

    /// Why the pair stands, once the supervisor has stopped it: the cause and whose report it was (0 left, 1 right).
    pub fn stopped(&self) -> Option<(PairStopCause, usize)> {
        match self.supervisor.state() {
            PairState::Running => None,
            PairState::Stopped { cause, left } => Some((cause, usize::from(!left))),
        }
    }

    /// What each controller does.
    pub fn modes(&self) -> [Mode; 2] {
        self.controllers.each_ref().map(RobotController::mode)
    }

    /// What each controller has learned.
    pub fn adapted(&self) -> [AdaptedParameters<f64>; 2] {
        self.controllers.each_ref().map(RobotController::adapted)
    }

    /// One tick of the torque loop: torques to hold until the next.
    pub fn tick(&mut self, truth: [Truth; 2]) -> [WheelTorque<f64>; 2] {
        self.now = self.reference.at(self.time());
        let track = self.ticks.is_multiple_of(TRACKER_TICKS);
        let targets = self.now.each_ref().map(control_sample);
        let mut torques = [WheelTorque::default(); 2];
        for side in 0..2 {
            if track {
                let (pose, age) = self.sensors[side].pose(truth[side].pose);
                self.controllers[side].track(&pose, age, &targets[side]);
            }
            let velocity = self.sensors[side].velocity(truth[side].velocity);
            torques[side] = self.controllers[side].torque(velocity, TORQUE_PERIOD);
        }
        if track {
            self.supervise(truth);
        }
        self.ticks += 1;
        torques
    }

    fn supervise(&mut self, truth: [Truth; 2]) {
        let report = |side: usize| {
            let controller = &self.controllers[side];
            let error = controller.error();
            RobotReport {
                tracking_error: libm::hypot(error.along, error.across),
                silence: 0.0,
                tension: truth[side].tension,
                stopped: matches!(controller.mode(), Mode::Stopping(_) | Mode::Stopped(_)),
            }
        };
        if let PairState::Stopped { .. } = self.supervisor.update(&report(0), &report(1)) {
            for controller in &mut self.controllers {
                controller.stop(StopCause::Supervisor);
            }
        }
    }
}
