//! Where the robot is now: late, noisy poses joined with the measured velocity.
//!
//! Between poses the estimate moves along q_dot = S v with the measured velocity. A pose of age a is first carried forward by
//! the same kinematics over a; the estimate then moves towards it by a fixed part g. White pose noise of standard deviation
//! s at a rate of 1/h leaves s sqrt(g / (2 - g)) in the estimate; an error of odometry is forgotten with time constant h/g.

use crate::parameter::require;
use crate::{ParameterError, Pose, Real, Velocity};

/// A complementary filter for poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseEstimator<T> {
    gain: T,
    estimate: Option<Pose<T>>,
}

impl<T: Real> PoseEstimator<T> {
    /// An estimator without a pose. `gain` in (0, 1]; 1 takes every pose as it comes.
    ///
    /// # Errors
    /// When the gain is out of range.
    pub fn new(gain: T) -> Result<Self, ParameterError> {
        require(
            "pose_gain",
            gain,
            gain > T::ZERO && gain <= T::ONE,
            "above 0 and at most 1",
        )?;
        Ok(Self {
            gain,
            estimate: None,
        })
    }

    /// Forgets every pose.
    pub fn reset(&mut self) {
        self.estimate = None;
    }

    /// Moves the estimate along a velocity for `dt` s.
    pub fn advance(&mut self, velocity: Velocity<T>, dt: T) {
        if let Some(pose) = &mut self.estimate {
            *pose = carried(pose, velocity, dt);
        }
    }

    /// Takes a pose that was true `age` s ago and returns the estimate for now.
    pub fn correct(&mut self, pose: &Pose<T>, age: T, velocity: Velocity<T>) -> Pose<T> {
        let fix = carried(pose, velocity, age);
        let joined = match self.estimate {
            None => fix,
            Some(old) => {
                let (sin, cos) = (fix.heading - old.heading).sine_cosine();
                // Without the inverse tangent: exact for small angles, bounded and of the right sign for large ones.
                let turn = if cos > T::ZERO {
                    sin
                } else {
                    T::ONE.with_sign_of(sin)
                };
                Pose {
                    x: old.x + self.gain * (fix.x - old.x),
                    y: old.y + self.gain * (fix.y - old.y),
                    heading: old.heading + self.gain * turn,
                }
            }
        };
        self.estimate = Some(joined);
        joined
    }
}

/// A pose after `time` s at a constant velocity; the chord of the arc along its mean heading.
fn carried<T: Real>(pose: &Pose<T>, velocity: Velocity<T>, time: T) -> Pose<T> {
    let turn = velocity.angular * time;
    let (sin, cos) = (pose.heading + T::of(0.5) * turn).sine_cosine();
    let way = velocity.linear * time;
    Pose {
        x: pose.x + way * cos,
        y: pose.y + way * sin,
        heading: pose.heading + turn,
    }
}
