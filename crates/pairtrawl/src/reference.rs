//! A plan as one time-continuous reference for the pair.
//!
//! Between waypoints each robot rolls without slip on a smooth curve through its waypoints (the plan's own poses, met to
//! rounding); one time law moves both, so that both are at waypoint i at the same instant. Speeds are 0 at the start and at the
//! end, continuous between, and slowed where the smooth curve would break the robot's limits.

mod clock;
mod step;

use clock::Clock;
use pairtrawl_control::{Pose as ControlPose, ReferenceSample, Velocity};
use pairtrawl_geometry::Pose;
use pairtrawl_model::{Certificate, PairTrajectory, Robot, Scene};
use step::{RollingStep, roll_through};
use thiserror::Error;

/// How hard the pair may accelerate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceLimits {
    /// Greatest change of the pace, 1/s: 1 reaches the plan's speed in a second.
    pub pace_rate: f64,
    /// Greatest acceleration along a path that turns of speed between steps may ask for, m/s^2.
    pub linear: f64,
    /// The same for turning, rad/s^2.
    pub angular: f64,
}

impl Default for ReferenceLimits {
    fn default() -> Self {
        Self {
            pace_rate: 1.0,
            linear: 0.5,
            angular: 2.5,
        }
    }
}

/// A trajectory that no reference can be made of.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ReferenceError {
    /// Too few poses, or not as many for each robot.
    #[error(
        "the plan has {left} and {right} waypoints: a reference needs the same number for both robots, at least 2"
    )]
    Waypoints {
        /// Of the left robot.
        left: usize,
        /// Of the right robot.
        right: usize,
    },
    /// A number is not finite, or the step time not positive.
    #[error(
        "waypoint {index} of the plan or its step time ({step_time} s) is not a usable number: plan again"
    )]
    NotFinite {
        /// The first bad waypoint; 0 when it is the step time.
        index: usize,
        /// The step time, s.
        step_time: f64,
    },
}

/// Where both robots should be at an instant, and how they should move.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairReference {
    /// The left robot.
    pub left: ReferenceSample<f64>,
    /// The right robot.
    pub right: ReferenceSample<f64>,
}

/// The reference of a plan.
#[derive(Clone, Debug)]
pub struct Reference {
    left: Vec<RollingStep>,
    right: Vec<RollingStep>,
    clock: Clock,
    step_time: f64,
}

impl Reference {
    /// The reference of a trajectory for robots with these limits.
    ///
    /// # Errors
    /// When the trajectory is not one.
    pub fn new(
        robot: &Robot,
        trajectory: &PairTrajectory,
        limits: &ReferenceLimits,
    ) -> Result<Self, ReferenceError> {
        let (left, right) = (trajectory.left.len(), trajectory.right.len());
        if left != right || left < 2 {
            return Err(ReferenceError::Waypoints { left, right });
        }
        let step_time = trajectory.step_time;
        let bad = (0..left)
            .find(|&i| !trajectory.left[i].is_finite() || !trajectory.right[i].is_finite());
        if bad.is_some() || !step_time.is_finite() || step_time <= 0.0 {
            return Err(ReferenceError::NotFinite {
                index: bad.unwrap_or(0),
                step_time,
            });
        }
        let (left, right) = (
            roll_through(&trajectory.left),
            roll_through(&trajectory.right),
        );
        let caps: Vec<f64> = (0..2 * left.len())
            .map(|k| {
                let cap = |step: &RollingStep| pace_cap(step, k % 2, step_time, robot, limits);
                cap(&left[k / 2]).min(cap(&right[k / 2]))
            })
            .collect();
        let clock = Clock::new(step_time, &caps, limits.pace_rate);
        Ok(Self {
            left,
            right,
            clock,
            step_time,
        })
    }

    /// Time from the first waypoint to the last, s.
    pub fn duration(&self) -> f64 {
        self.clock.duration()
    }

    /// When the pair passes waypoint `i` of the plan, s.
    pub fn waypoint_time(&self, i: usize) -> f64 {
        self.clock.waypoint_time(i)
    }

    /// How many waypoints of the plan there are.
    pub fn waypoints(&self) -> usize {
        self.left.len() + 1
    }

    /// The reference at a time, s. Before 0 and after the end the pair stands.
    pub fn at(&self, time: f64) -> PairReference {
        let progress = self.clock.at(time);
        let i = (progress.steps.floor() as usize).min(self.left.len() - 1);
        let w = (progress.steps - i as f64).clamp(0.0, 1.0);
        let (u_rate, u_acceleration) = (
            progress.pace / self.step_time,
            progress.pace_rate / self.step_time,
        );
        let sample = |steps: &[RollingStep]| {
            let s = steps[i].at(w);
            ReferenceSample {
                pose: ControlPose {
                    x: s.pose.x,
                    y: s.pose.y,
                    heading: s.pose.heading,
                },
                velocity: Velocity {
                    linear: s.speed * u_rate,
                    angular: s.rate * u_rate,
                },
                acceleration: Velocity {
                    linear: s.speed_slope * u_rate * u_rate + s.speed * u_acceleration,
                    angular: s.rate_slope * u_rate * u_rate + s.rate * u_acceleration,
                },
            }
        };
        PairReference {
            left: sample(&self.left),
            right: sample(&self.right),
        }
    }

    /// The reference as waypoints at even intervals of at most `interval` s.
    pub fn resampled(&self, interval: f64) -> PairTrajectory {
        let count = (self.duration() / interval).ceil().max(1.0);
        let step_time = self.duration() / count;
        let mut trajectory = PairTrajectory {
            step_time,
            ..PairTrajectory::default()
        };
        for k in 0..=count as usize {
            let pair = self.at(k as f64 * step_time);
            trajectory.left.push(pose(&pair.left));
            trajectory.right.push(pose(&pair.right));
        }
        trajectory
    }

    /// The claims of the certificate on the reference, sampled four times as finely as the plan.
    pub fn certify(&self, scene: &Scene, net_length: f64) -> Certificate {
        pairtrawl_certificate::certify(scene, net_length, &self.resampled(0.25 * self.step_time))
    }
}

/// A reference pose in the model's words.
pub(crate) fn pose(sample: &ReferenceSample<f64>) -> Pose {
    Pose::new(sample.pose.x, sample.pose.y, sample.pose.heading)
}

/// The greatest pace on the first or second half of a step that keeps the robot's limits.
fn pace_cap(
    step: &RollingStep,
    half: usize,
    step_time: f64,
    robot: &Robot,
    limits: &ReferenceLimits,
) -> f64 {
    let mut cap = 1.0_f64;
    for k in 0..=4 {
        let s = step.at(0.5 * half as f64 + 0.125 * f64::from(k));
        let (speed, rate) = (s.speed.abs() / step_time, s.rate.abs() / step_time);
        // A thousandth is left for what lies between the samples.
        cap = cap.min(0.999 * robot.v_max / (speed + robot.half_track * rate).max(1e-9));
        cap = cap.min(0.999 * robot.omega_max / rate.max(1e-9));
        let square = step_time * step_time;
        cap = cap.min((limits.linear * square / s.speed_slope.abs().max(1e-12)).sqrt());
        cap = cap.min((limits.angular * square / s.rate_slope.abs().max(1e-12)).sqrt());
    }
    cap
}
