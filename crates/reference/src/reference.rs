use crate::clock::Clock;
use crate::step::{RollingStep, roll_through};
use crate::{ReferenceError, ReferenceLimits, Sample};
use pairtrawl_model::{PairTrajectory, PlannerParameters, Robot, default_step_time};

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
        planner: &PlannerParameters,
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
        let step_time = default_step_time(robot, planner);
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

    /// Where both robots should be at a time (s) and how they should move, by [`Side::index`](pairtrawl_model::Side::index).
    /// Before 0 and after the end the pair stands.
    pub fn at(&self, time: f64) -> [Sample; 2] {
        let progress = self.clock.at(time);
        let i = (progress.steps.floor() as usize).min(self.left.len() - 1);
        let w = (progress.steps - i as f64).clamp(0.0, 1.0);
        let (u_rate, u_acceleration) = (
            progress.pace / self.step_time,
            progress.pace_rate / self.step_time,
        );
        [&self.left, &self.right].map(|steps| {
            let s = steps[i].at(w);
            Sample {
                pose: s.pose,
                v: s.speed * u_rate,
                omega: s.rate * u_rate,
                v_dot: s.speed_slope * u_rate * u_rate + s.speed * u_acceleration,
                omega_dot: s.rate_slope * u_rate * u_rate + s.rate * u_acceleration,
            }
        })
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
            let [left, right] = self.at(k as f64 * step_time);
            trajectory.left.push(left.pose);
            trajectory.right.push(right.pose);
        }
        trajectory
    }
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
