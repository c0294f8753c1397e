//! The pair's controller with simulated sensors, around any pair of robots that takes wheel torques.

use crate::pair_controller::{Measurement, PairController, PairStop, PoseFix};
use crate::sensing::{Sensing, Sensors, TORQUE_PERIOD, TRACKER_TICKS};
use pairtrawl_control::{
    AdaptedParameters, ControllerParameters, ParameterError, Pose, SupervisorLimits, Velocity,
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
    controller: PairController<&'a Reference>,
    sensors: [Sensors; 2],
    ticks: u64,
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
        [left, right]: [Sensing; 2],
        seeds: [u64; 2],
    ) -> Result<Self, ParameterError> {
        Ok(Self {
            controller: PairController::new(reference, parameters, supervisor)?,
            sensors: [Sensors::new(left, seeds[0]), Sensors::new(right, seeds[1])],
            ticks: 0,
        })
    }

    /// Time since the start, s.
    pub fn time(&self) -> f64 {
        self.ticks as f64 * TORQUE_PERIOD
    }

    /// The reference of the last tick.
    pub fn reference(&self) -> &[Sample; 2] {
        self.controller.targets()
    }

    /// Why the pair stands, once it has been stopped.
    pub fn stopped(&self) -> Option<PairStop> {
        self.controller.stopped()
    }

    /// What each controller has learned.
    pub fn adapted(&self) -> [AdaptedParameters<f64>; 2] {
        self.controller.adapted()
    }

    /// One tick of the torque loop: torques to hold until the next.
    pub fn tick(&mut self, truth: [Truth; 2]) -> [WheelTorque<f64>; 2] {
        let track = self.ticks.is_multiple_of(TRACKER_TICKS);
        let [left, right] = &mut self.sensors;
        let measured = [
            measure(left, &truth[0], track),
            measure(right, &truth[1], track),
        ];
        let time = self.time();
        self.ticks += 1;
        self.controller
            .tick(measured, time)
            .map(|command| command.torque)
    }
}

fn measure(sensors: &mut Sensors, truth: &Truth, track: bool) -> Measurement {
    let fix = |(pose, age)| PoseFix { pose, age };
    Measurement {
        pose: track.then(|| fix(sensors.pose(truth.pose))),
        velocity: Some(sensors.velocity(truth.velocity)),
        tension: Some(truth.tension),
    }
}
