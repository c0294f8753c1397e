use crate::clock::Clock;
use crate::pace::PaceRules;
use crate::path::{longest_chord, roll_through};
use crate::step::RollingStep;
use crate::{ReferenceError, ReferenceLimits, Sample};
use pairtrawl_model::{PairTrajectory, PlannerParameters, Robot, Scene, Side};

/// The reference of a plan.
#[derive(Clone, Debug)]
pub struct Reference {
    /// By [`Side::index`].
    steps: [Vec<RollingStep>; 2],
    clock: Clock,
}

impl Reference {
    /// The reference of a trajectory for robots with these limits. Only the waypoints of the trajectory count: its step time
    /// must be a usable number, but does not set the pace.
    ///
    /// # Errors
    /// When the trajectory is not one.
    pub fn new(
        robot: &Robot,
        planner: &PlannerParameters,
        trajectory: &PairTrajectory,
        limits: &ReferenceLimits,
    ) -> Result<Self, ReferenceError> {
        let (left, right) = (&trajectory.left, &trajectory.right);
        if left.len() != right.len() || left.len() < 2 {
            return Err(ReferenceError::Waypoints {
                left: left.len(),
                right: right.len(),
            });
        }
        let step_time = trajectory.step_time;
        let bad = (0..left.len()).find(|&i| !left[i].is_finite() || !right[i].is_finite());
        if bad.is_some() || !step_time.is_finite() || step_time <= 0.0 {
            return Err(ReferenceError::NotFinite {
                index: bad.unwrap_or(0),
                step_time,
            });
        }
        let unit = longest_chord(left).max(longest_chord(right));
        let steps = [left, right].map(|poses| roll_through(poses, unit));
        let rules = PaceRules::new(robot, planner, limits);
        let halves = [[0.0, 0.5], [0.5, 1.0]];
        let limits: Vec<_> = (0..left.len() - 1)
            .flat_map(|i| halves.map(|half| (i, half)))
            .map(|(i, half)| rules.limit(steps.each_ref().map(|s| s[i].bounds(half))))
            .collect();
        Ok(Self {
            clock: Clock::new(&limits),
            steps,
        })
    }

    /// The reference of a trajectory in a scene, for its robot, at its cruise speed.
    ///
    /// # Errors
    /// When the trajectory is not one.
    pub fn of_scene(scene: &Scene, trajectory: &PairTrajectory) -> Result<Self, ReferenceError> {
        let limits = ReferenceLimits::of(&scene.robot);
        Self::new(&scene.robot, &scene.planner, trajectory, &limits)
    }

    /// Time from the first waypoint to the last, s.
    pub fn duration(&self) -> f64 {
        self.clock.duration()
    }

    /// When the pair passes waypoint `i` of the plan, s.
    pub fn waypoint_time(&self, i: usize) -> f64 {
        self.clock.waypoint_time(i)
    }

    /// When the pair passes each waypoint, s.
    pub fn time_law(&self) -> Vec<f64> {
        (0..self.waypoints())
            .map(|i| self.waypoint_time(i))
            .collect()
    }

    /// How many waypoints of the plan there are.
    pub fn waypoints(&self) -> usize {
        self.steps[0].len() + 1
    }

    /// The curve of one robot, step by step.
    pub fn steps(&self, side: Side) -> &[RollingStep] {
        &self.steps[side.index()]
    }

    /// Greatest pace du/dt on the stretch from w = `stretch[0]` to `stretch[1]` of step `i`, 1/s. The stretch must lie in one
    /// half of the step: there the square of the pace is linear in w.
    pub fn greatest_pace(&self, i: usize, stretch: [f64; 2]) -> f64 {
        let [from, to] = stretch.map(|w| self.clock.square_at(i as f64 + w));
        from.max(to).sqrt()
    }

    /// Where both robots should be at a time (s) and how they should move, by [`Side::index`]. Before 0 and after the end
    /// the pair stands.
    pub fn at(&self, time: f64) -> [Sample; 2] {
        let progress = self.clock.at(time);
        let i = (progress.steps as usize).min(self.waypoints() - 2);
        let w = (progress.steps - i as f64).clamp(0.0, 1.0);
        let (pace, pace_rate) = (progress.pace, progress.pace_rate);
        self.steps.each_ref().map(|steps| {
            let s = steps[i].at(w);
            Sample {
                pose: s.pose,
                v: s.speed * pace,
                omega: s.rate * pace,
                v_dot: s.speed_slope * pace * pace + s.speed * pace_rate,
                omega_dot: s.rate_slope * pace * pace + s.rate * pace_rate,
            }
        })
    }
}
