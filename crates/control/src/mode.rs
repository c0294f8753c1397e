//! What a robot is doing, and why it stops.

use core::fmt;

/// Why a robot stops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopCause {
    /// A pose was not finite or not plausible.
    InvalidPose,
    /// No pose younger than the limit.
    StalePose,
    /// A reference was not finite or not plausible.
    InvalidReference,
    /// A measured velocity was missing, not finite or not plausible.
    InvalidVelocity,
    /// The pair's supervisor said so.
    Supervisor,
}

impl fmt::Display for StopCause {
    /// The cause in a few words, for people.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::InvalidPose => "a pose that is not finite or not plausible",
            Self::StalePose => "no recent pose",
            Self::InvalidReference => "a reference that is not finite or not plausible",
            Self::InvalidVelocity => "no plausible velocity",
            Self::Supervisor => "the pair was stopped",
        })
    }
}

/// What a controller is doing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Waits for its first pose with zero torque.
    #[default]
    Armed,
    /// Follows the reference.
    Running,
    /// Slows down smoothly; latched.
    Stopping(StopCause),
    /// Stands; latched.
    Stopped(StopCause),
}
