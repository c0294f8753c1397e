//! A pair of reduced plants along a reference, under a drag that is given over time.

use crate::control_loop::PairLoop;
use crate::observer::ExecutionObserver;
use crate::pair_controller::PairStop;
use crate::plant::{Drag, PlantParameters, ReducedPlant};
use crate::sample::control_sample;
use crate::sensing::{Sensing, TORQUE_PERIOD, TRACKER_TICKS};
use crate::statistics::{ErrorCollector, settled_max, settled_rms};
use pairtrawl_control::{
    AdaptedParameters, ControllerParameters, ParameterError, SupervisorLimits,
};
use pairtrawl_model::TrackingStatistics;
use pairtrawl_reference::Reference;

/// Everything about one reduced run. Arrays over robots are (left, right).
pub struct ReducedRun<'a> {
    /// Where the robots should be.
    pub reference: &'a Reference,
    /// Their controllers.
    pub controller: ControllerParameters<f64>,
    /// When the pair stops.
    pub supervisor: SupervisorLimits<f64>,
    /// Their sensors.
    pub sensing: [Sensing; 2],
    /// The robots.
    pub plants: [PlantParameters; 2],
    /// The drag on each robot over time (s).
    pub drag: &'a (dyn Fn(f64) -> [Drag; 2] + Sync),
    /// Seeds of the sensors.
    pub seeds: [u64; 2],
}

/// What came of a reduced run.
#[derive(Clone, Debug, PartialEq)]
pub struct ReducedOutcome {
    /// Position error of each robot.
    pub tracking: [TrackingStatistics; 2],
    /// Why and when (s) the pair was stopped before its end.
    pub stopped: Option<(PairStop, f64)>,
    /// Greatest torque of a wheel, N m.
    pub max_torque: f64,
    /// Greatest magnitude of each adapted parameter seen, over both robots: Delta_X, Delta_m, Delta_b.
    pub greatest: AdaptedParameters<f64>,
}

impl ReducedOutcome {
    /// Greatest position error of either robot after the first second, m.
    pub fn worst(&self) -> f64 {
        settled_max(&self.tracking)
    }

    /// Root mean square error of both robots after the first second, m.
    pub fn rms(&self) -> f64 {
        settled_rms(&self.tracking)
    }
}

impl ReducedRun<'_> {
    /// Drives to the end of the reference and half a second beyond, or until the pair is stopped.
    /// `Ok(None)`: the observer interrupted it.
    ///
    /// # Errors
    /// When a parameter is out of range.
    pub fn drive(
        &self,
        observer: &dyn ExecutionObserver,
    ) -> Result<Option<ReducedOutcome>, ParameterError> {
        let mut control = PairLoop::new(
            self.reference,
            &self.controller,
            self.supervisor,
            self.sensing,
            self.seeds,
        )?;
        let start = self.reference.at(0.0);
        let mut robots = [
            ReducedPlant::new(self.plants[0], control_sample(&start[0]).pose),
            ReducedPlant::new(self.plants[1], control_sample(&start[1]).pose),
        ];
        let mut errors = [ErrorCollector::default(); 2];
        let mut outcome = ReducedOutcome {
            tracking: Default::default(),
            stopped: None,
            max_torque: 0.0,
            greatest: AdaptedParameters::default(),
        };
        let ticks = ((self.reference.duration() + 0.5) / TORQUE_PERIOD).ceil() as u64;
        for tick in 0..ticks {
            let torques = control.tick(robots.each_ref().map(ReducedPlant::truth));
            let drag = (self.drag)(control.time());
            for ((robot, torque), drag) in robots.iter_mut().zip(torques).zip(drag) {
                robot.step(torque, drag, TORQUE_PERIOD);
                let peak = torque.right.abs().max(torque.left.abs());
                outcome.max_torque = outcome.max_torque.max(peak);
            }
            if !tick.is_multiple_of(TRACKER_TICKS) {
                continue;
            }
            let time = control.time();
            let target = self.reference.at(time);
            for ((error, robot), target) in errors.iter_mut().zip(&robots).zip(target) {
                let pose = robot.truth().pose;
                error.take(
                    time,
                    libm::hypot(pose.x - target.pose.x, pose.y - target.pose.y),
                );
            }
            for adapted in control.adapted() {
                keep_greatest(&mut outcome.greatest, &adapted);
            }
            if let Some(stop) = control.stopped() {
                outcome.stopped = Some((stop, time));
                break;
            }
            if tick.is_multiple_of(500) && observer.interrupted() {
                return Ok(None);
            }
        }
        outcome.tracking = errors.map(|e| e.statistics());
        Ok(Some(outcome))
    }
}

fn keep_greatest(greatest: &mut AdaptedParameters<f64>, adapted: &AdaptedParameters<f64>) {
    for i in 0..2 {
        greatest.bias[i] = greatest.bias[i].max(adapted.bias[i].abs());
        for j in 0..2 {
            greatest.state[i][j] = greatest.state[i][j].max(adapted.state[i][j].abs());
            greatest.input[i][j] = greatest.input[i][j].max(adapted.input[i][j].abs());
        }
    }
}
