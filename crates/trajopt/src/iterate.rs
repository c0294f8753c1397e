//! The point that the solver moves: poses of both robots at every waypoint, and the net length.

use crate::term::{PAIR, POINT, QUAD};
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

    /// `self = from + alpha * direction`, ends fixed; the direction lists the inner stages.
    pub fn assign_stepped(&mut self, from: &Self, alpha: f64, direction: &[f64], net_length: f64) {
        self.stages.clone_from(&from.stages);
        let inner = 1..from.stages.len() - 1;
        for (stage, change) in self.stages[inner]
            .iter_mut()
            .zip(direction.chunks_exact(STAGE))
        {
            for (z, d) in stage.iter_mut().zip(change) {
                *z += alpha * d;
            }
        }
        self.net_length = from.net_length + alpha * net_length;
    }
}
