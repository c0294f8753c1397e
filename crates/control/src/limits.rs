//! What a command may be and what a measurement must be.

use crate::parameter::positive;
use crate::{ParameterError, Pose, Real, Velocity, WheelTorque};

/// Limits of commands and of measurements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits<T> {
    /// Greatest torque of a wheel, N m.
    pub torque: T,
    /// Greatest change of a wheel's torque, N m/s.
    pub torque_rate: T,
    /// Greatest desired velocity, m/s and rad/s: the tracking law's answer to a large error is cut here.
    pub desired: Velocity<T>,
    /// Greatest velocity that a measurement may claim, m/s and rad/s.
    pub plausible: Velocity<T>,
    /// Greatest coordinate that a pose may claim, m.
    pub plausible_position: T,
    /// Greatest age of a pose, s.
    pub pose_age: T,
    /// Duration of a smooth stop, s.
    pub stop_time: T,
    /// Velocity feedback during a stop, N s/m and N m s/rad.
    pub stop_feedback: [T; 2],
}

impl<T: Real> Default for Limits<T> {
    fn default() -> Self {
        Self {
            torque: T::of(3.0),
            torque_rate: T::of(60.0),
            desired: Velocity {
                linear: T::of(0.40),
                angular: T::of(2.0),
            },
            plausible: Velocity {
                linear: T::of(5.0),
                angular: T::of(30.0),
            },
            plausible_position: T::of(1e4),
            pose_age: T::of(0.2),
            stop_time: T::of(0.5),
            stop_feedback: [T::of(11.4), T::of(0.15)],
        }
    }
}

impl<T: Real> Limits<T> {
    /// Checks that every limit is finite and above zero.
    ///
    /// # Errors
    /// Names the first that is not.
    pub fn validate(&self) -> Result<(), ParameterError> {
        positive("limits.torque", self.torque)?;
        positive("limits.torque_rate", self.torque_rate)?;
        positive("limits.desired.linear", self.desired.linear)?;
        positive("limits.desired.angular", self.desired.angular)?;
        positive("limits.plausible.linear", self.plausible.linear)?;
        positive("limits.plausible.angular", self.plausible.angular)?;
        positive("limits.plausible_position", self.plausible_position)?;
        positive("limits.pose_age", self.pose_age)?;
        positive("limits.stop_time", self.stop_time)?;
        positive("limits.stop_feedback", self.stop_feedback[0])?;
        positive("limits.stop_feedback", self.stop_feedback[1])
    }

    /// True when a measured velocity is finite and plausible.
    pub fn accepts(&self, velocity: Velocity<T>) -> bool {
        velocity.linear.abs() <= self.plausible.linear
            && velocity.angular.abs() <= self.plausible.angular
    }
}

/// Cuts wheel torques to their greatest value and rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorqueLimiter<T> {
    torque: T,
    rate: T,
    last: WheelTorque<T>,
}

impl<T: Real> TorqueLimiter<T> {
    /// Starts at zero torque; limits in N m and N m/s, above zero.
    pub fn new(torque: T, rate: T) -> Self {
        Self {
            torque,
            rate,
            last: WheelTorque::default(),
        }
    }

    /// The torque last let through.
    pub fn last(&self) -> WheelTorque<T> {
        self.last
    }

    /// The torque nearest to the wanted one that both limits allow `dt` s after the last, and whether it was cut.
    ///
    /// Both wheels are scaled alike by the torque limit, so a cut command keeps its direction. A command that is not finite
    /// counts as zero.
    pub fn limit(&mut self, wanted: WheelTorque<T>, dt: T) -> (WheelTorque<T>, bool) {
        let (mut goal, mut cut) = if wanted.is_finite() {
            (wanted, false)
        } else {
            (WheelTorque::default(), true)
        };
        let greatest = goal.right.abs().larger(goal.left.abs());
        if greatest > self.torque {
            // Divided first: the product of a limit and a huge command would overflow.
            goal = WheelTorque {
                right: (goal.right / greatest * self.torque).limited(self.torque),
                left: (goal.left / greatest * self.torque).limited(self.torque),
            };
            cut = true;
        }
        let reach = if dt > T::ZERO && dt.is_finite() {
            self.rate * dt
        } else {
            T::ZERO
        };
        let mut approach = |from: T, to: T| {
            let change = to - from;
            cut |= change.abs() > reach;
            (from + change.limited(reach)).limited(self.torque)
        };
        self.last = WheelTorque {
            right: approach(self.last.right, goal.right),
            left: approach(self.last.left, goal.left),
        };
        (self.last, cut)
    }
}

/// Why a pose was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PoseRefusal {
    /// It is not finite, or lies beyond any plausible place, or its age is no number.
    Invalid,
    /// It, or the last good one, is too old.
    Stale,
}

/// Keeps the age of the last good pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseGuard<T> {
    greatest_age: T,
    greatest_position: T,
    age: Option<T>,
}

impl<T: Real> PoseGuard<T> {
    /// A guard that has seen no pose; limits in s and m.
    pub fn new(greatest_age: T, greatest_position: T) -> Self {
        Self {
            greatest_age,
            greatest_position,
            age: None,
        }
    }

    /// Age of the last good pose, s; `None` before the first.
    pub fn age(&self) -> Option<T> {
        self.age
    }

    /// Forgets every pose.
    pub fn reset(&mut self) {
        self.age = None;
    }

    /// Takes a pose that was true `age` s ago.
    ///
    /// # Errors
    /// When the pose is invalid or too old.
    pub fn take(&mut self, pose: &Pose<T>, age: T) -> Result<(), PoseRefusal> {
        let near = |v: T| v.abs() <= self.greatest_position;
        // Each condition is false for NaN.
        let sound = near(pose.x) && near(pose.y) && near(pose.heading) && age >= T::ZERO;
        if !sound {
            return Err(PoseRefusal::Invalid);
        }
        if age > self.greatest_age {
            return Err(PoseRefusal::Stale);
        }
        self.age = Some(age);
        Ok(())
    }

    /// Lets time pass.
    ///
    /// # Errors
    /// When the last good pose has become too old.
    pub fn advance(&mut self, dt: T) -> Result<(), PoseRefusal> {
        if let Some(age) = self.age {
            let older = age + dt;
            self.age = Some(older);
            if older > self.greatest_age {
                return Err(PoseRefusal::Stale);
            }
        }
        Ok(())
    }
}
