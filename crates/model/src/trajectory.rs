use crate::{PairPose, PlannerParameters, Robot};
use pairtrawl_geometry::Pose;

/// Trajectories of both robots on one clock: `left[i]` and `right[i]` belong to the instant `i * step_time`;
/// between waypoints positions and headings are linear in time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PairTrajectory {
    /// Poses of the left robot.
    pub left: Vec<Pose>,
    /// Poses of the right robot, as many.
    pub right: Vec<Pose>,
    /// Time from one waypoint to the next, s.
    pub step_time: f64,
}

impl PairTrajectory {
    /// Number of waypoints N.
    pub fn len(&self) -> usize {
        self.left.len()
    }

    /// True when there is no waypoint.
    pub fn is_empty(&self) -> bool {
        self.left.is_empty()
    }

    /// The part from waypoint `first` on; empty when there is none.
    #[must_use]
    pub fn from_waypoint(&self, first: usize) -> Self {
        let rest = |poses: &[Pose]| poses.get(first..).unwrap_or_default().to_vec();
        Self {
            left: rest(&self.left),
            right: rest(&self.right),
            step_time: self.step_time,
        }
    }

    /// Both poses at waypoint `i`.
    pub fn pair(&self, i: usize) -> PairPose {
        PairPose {
            left: self.left[i],
            right: self.right[i],
        }
    }

    /// The same with every pose of both robots mapped.
    #[must_use]
    pub fn map(&self, f: impl Fn(Pose) -> Pose) -> Self {
        let mapped = |poses: &[Pose]| poses.iter().map(|&pose| f(pose)).collect();
        Self {
            left: mapped(&self.left),
            right: mapped(&self.right),
            step_time: self.step_time,
        }
    }

    /// When each waypoint is passed, s.
    pub fn times(&self) -> Vec<f64> {
        (0..self.len()).map(|i| i as f64 * self.step_time).collect()
    }

    /// Time from the first waypoint to the last, s.
    pub fn duration(&self) -> f64 {
        self.step_time * self.len().saturating_sub(1) as f64
    }

    /// Driven lengths of (left, right), m.
    pub fn path_lengths(&self) -> (f64, f64) {
        let length = |poses: &[Pose]| {
            poses
                .windows(2)
                .map(|w| w[0].position().distance(w[1].position()))
                .sum()
        };
        (length(&self.left), length(&self.right))
    }
}

/// The least `step_time` in which the largest step and turn respect the robot's limits at cruise speed, s.
pub fn default_step_time(robot: &Robot, planner: &PlannerParameters) -> f64 {
    let cruise = planner.max_step / planner.cruise;
    let turn = planner.max_turn / robot.omega_max;
    let wheel = (planner.max_step + robot.half_track * planner.max_turn) / robot.v_max;
    cruise.max(turn).max(wheel)
}
