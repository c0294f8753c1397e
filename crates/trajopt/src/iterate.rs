//! The point that the solver moves: poses of both robots at every waypoint, and the net length.

use crate::term::{PAIR, POINT, POSE, QUAD};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{PairTrajectory, Side};

/// Coordinates a waypoint: x, y, heading of the left robot, then of the right one.
pub(crate) const STAGE: usize = 6;

/// Variables of the problem. The first and last waypoint stay as they are.
#[derive(Clone, Debug, Default)]
pub(crate) struct Iterate {
    pub stages: Vec<[f64; STAGE]>,
    pub net_length: f64,
}

/// A change of the variables.
#[derive(Clone, Debug, Default)]
pub(crate) struct Direction {
    /// Of the inner stages.
    pub inner: Vec<f64>,
    /// Of the net length.
    pub length: f64,
}

impl Direction {
    /// The change of a waypoint; that of the ends is zero.
    #[inline]
    pub fn stage(&self, i: usize) -> [f64; STAGE] {
        let inner = i.checked_sub(1).and_then(|k| {
            let b = k * STAGE;
            self.inner.get(b..b + STAGE)
        });
        inner.map_or([0.0; STAGE], |d| std::array::from_fn(|v| d[v]))
    }
}

impl Iterate {
    pub fn from_trajectory(pair: &PairTrajectory, net_length: f64) -> Self {
        let stages = pair
            .left
            .iter()
            .zip(&pair.right)
            .map(|(l, r)| [l.x, l.y, l.heading, r.x, r.y, r.heading])
            .collect();
        Self { stages, net_length }
    }

    pub fn to_trajectory(&self, step_time: f64) -> PairTrajectory {
        let robot = |at: usize| {
            self.stages
                .iter()
                .map(|z| Pose::new(z[at], z[at + 1], z[at + 2]))
                .collect()
        };
        PairTrajectory {
            left: robot(0),
            right: robot(3),
            step_time,
        }
    }

    #[inline]
    pub fn pair(&self, i: usize) -> [f64; PAIR] {
        let z = &self.stages[i];
        [z[0] - z[3], z[1] - z[4], z[2], z[5], self.net_length]
    }

    #[inline]
    pub fn point(&self, i: usize, robot: Side) -> [f64; POINT] {
        let k = 3 * robot.index();
        [self.stages[i][k], self.stages[i][k + 1]]
    }

    #[inline]
    pub fn pose(&self, i: usize, robot: Side) -> [f64; POSE] {
        let k = 3 * robot.index();
        std::array::from_fn(|v| self.stages[i][k + v])
    }

    /// The line between the robots at waypoints `i` and `i + 1`.
    #[inline]
    pub fn quad(&self, i: usize) -> [f64; QUAD] {
        let (a, b) = (&self.stages[i], &self.stages[i + 1]);
        [a[0], a[1], a[3], a[4], b[0], b[1], b[3], b[4]]
    }

    /// Position of a robot.
    pub fn position(&self, i: usize, robot: Side) -> Point {
        Point::from(self.point(i, robot))
    }

    /// Half way between the robots.
    pub fn middle(&self, i: usize) -> Point {
        self.position(i, Side::Left)
            .lerp(self.position(i, Side::Right), 0.5)
    }

    /// `self = from + alpha * direction`, ends fixed.
    pub fn assign_stepped(&mut self, from: &Self, alpha: f64, direction: &Direction) {
        self.stages.clone_from(&from.stages);
        let inner = 1..from.stages.len() - 1;
        for (stage, change) in self.stages[inner]
            .iter_mut()
            .zip(direction.inner.chunks_exact(STAGE))
        {
            for (z, d) in stage.iter_mut().zip(change) {
                *z += alpha * d;
            }
        }
        self.net_length = from.net_length + alpha * direction.length;
    }
}
