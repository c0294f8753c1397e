//! Stops both robots together. Each robot may run its own copy: it needs its partner's reports only.

use crate::parameter::positive;
use crate::{ParameterError, Real};

/// When the pair stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SupervisorLimits<T> {
    /// Greatest distance of a robot from its reference, m.
    pub tracking_error: T,
    /// Greatest time without a word from a robot, s.
    pub silence: T,
    /// Strength of the net: greatest tension at a hitch, N.
    pub tension: T,
}

impl<T: Real> Default for SupervisorLimits<T> {
    fn default() -> Self {
        Self {
            tracking_error: T::of(0.25),
            silence: T::of(0.2),
            tension: T::of(10.0),
        }
    }
}

/// What a robot says about itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RobotReport<T> {
    /// Distance from its reference, m.
    pub tracking_error: T,
    /// Age of this report, s.
    pub silence: T,
    /// Tension at its hitch, N; 0 when it has no sensor.
    pub tension: T,
    /// True when it stops or stands for a reason of its own.
    pub stopped: bool,
}

/// Why the pair stops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PairStopCause {
    /// A robot is too far from its reference.
    TrackingError,
    /// A robot is silent.
    Silence,
    /// The net is about to tear.
    Tension,
    /// A robot stopped by itself.
    RobotStopped,
    /// A report held a number that is not finite.
    InvalidReport,
}

/// What the pair is to do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PairState {
    /// Go on.
    #[default]
    Running,
    /// Both stop; latched.
    Stopped {
        /// Why.
        cause: PairStopCause,
        /// True when it was the left robot's report.
        left: bool,
    },
}

/// Decides for both robots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairSupervisor<T> {
    limits: SupervisorLimits<T>,
    state: PairState,
}

impl<T: Real> PairSupervisor<T> {
    /// A supervisor that lets the pair run.
    ///
    /// # Errors
    /// When a limit is not finite and above zero.
    pub fn new(limits: SupervisorLimits<T>) -> Result<Self, ParameterError> {
        positive("supervisor.tracking_error", limits.tracking_error)?;
        positive("supervisor.silence", limits.silence)?;
        positive("supervisor.tension", limits.tension)?;
        Ok(Self {
            limits,
            state: PairState::Running,
        })
    }

    /// The state as it stands.
    pub fn state(&self) -> PairState {
        self.state
    }

    /// Takes both robots' reports. Once stopped it stays so until re-armed, whatever the reports say.
    pub fn update(&mut self, left: &RobotReport<T>, right: &RobotReport<T>) -> PairState {
        if self.state == PairState::Running {
            if let Some(cause) = self.objection(left) {
                self.state = PairState::Stopped { cause, left: true };
            } else if let Some(cause) = self.objection(right) {
                self.state = PairState::Stopped { cause, left: false };
            }
        }
        self.state
    }

    /// Lets the pair run again.
    pub fn rearm(&mut self) {
        self.state = PairState::Running;
    }

    fn objection(&self, report: &RobotReport<T>) -> Option<PairStopCause> {
        let limits = &self.limits;
        if !(report.tracking_error.is_finite()
            && report.silence.is_finite()
            && report.tension.is_finite())
        {
            Some(PairStopCause::InvalidReport)
        } else if report.stopped {
            Some(PairStopCause::RobotStopped)
        } else if report.silence > limits.silence {
            Some(PairStopCause::Silence)
        } else if report.tension > limits.tension {
            Some(PairStopCause::Tension)
        } else if report.tracking_error > limits.tracking_error {
            Some(PairStopCause::TrackingError)
        } else {
            None
        }
    }
}
