//! Stops both robots together. Each robot may run its own copy: it needs its partner's reports only.

use crate::parameter::positive;
use crate::{ParameterError, Real, StopCause};
use core::fmt;

/// Which of the two robots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PairRobot {
    /// The left one.
    Left,
    /// The right one.
    Right,
}

/// When the pair stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SupervisorLimits<T> {
    /// Greatest distance of a robot from its reference, m.
    pub tracking_error: T,
    /// Greatest time without a word from a robot, s. Below [`crate::Limits::pose_age`] less the age of a fresh pose, so that a robot that
    /// falls silent is named as such.
    pub silence: T,
    /// Strength of the net: greatest tension at a hitch, N.
    pub tension: T,
}

impl<T: Real> Default for SupervisorLimits<T> {
    fn default() -> Self {
        Self {
            tracking_error: T::of(0.25),
            silence: T::of(0.1),
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
    /// Why it stops or stands for a reason of its own; `None`: it does not.
    pub stopped: Option<StopCause>,
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
    RobotStopped(StopCause),
    /// A report held a number that is not finite.
    InvalidReport,
}

impl fmt::Display for PairStopCause {
    /// The cause in a few words about the robot, for people.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TrackingError => f.write_str("too far from its reference"),
            Self::Silence => f.write_str("silent for too long"),
            Self::Tension => f.write_str("tension above the strength of the net"),
            Self::RobotStopped(cause) => write!(f, "it stopped by itself: {cause}"),
            Self::InvalidReport => f.write_str("a report with a number that is not finite"),
        }
    }
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
        /// Whose report it was.
        robot: PairRobot,
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

    /// When the pair stops.
    pub fn limits(&self) -> &SupervisorLimits<T> {
        &self.limits
    }

    /// The state as it stands.
    pub fn state(&self) -> PairState {
        self.state
    }

    /// Takes both robots' reports. Once stopped it stays so until re-armed, whatever the reports say.
    pub fn update(&mut self, left: &RobotReport<T>, right: &RobotReport<T>) -> PairState {
        if self.state == PairState::Running {
            if let Some(cause) = self.objection(left) {
                self.state = PairState::Stopped {
                    cause,
                    robot: PairRobot::Left,
                };
            } else if let Some(cause) = self.objection(right) {
                self.state = PairState::Stopped {
                    cause,
                    robot: PairRobot::Right,
                };
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
        } else if report.silence > limits.silence {
            Some(PairStopCause::Silence)
        } else if let Some(cause) = report.stopped {
            Some(PairStopCause::RobotStopped(cause))
        } else if report.tension > limits.tension {
            Some(PairStopCause::Tension)
        } else if report.tracking_error > limits.tracking_error {
            Some(PairStopCause::TrackingError)
        } else {
            None
        }
    }
}
