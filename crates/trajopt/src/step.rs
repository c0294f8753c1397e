//! One robot over one step, in the frame of its mid-step heading.
//!
//! With displacement `(dx, dy)` and mid-step heading `psi`: `along = dx cos psi + dy sin psi` (s), `across = dy cos psi -
//! dx sin psi` (h), `turn = delta phi`. Every cost and constraint of a step is linear in these three; what bends is the frame:
//! `d along = cos ddx + sin ddy + across dpsi`, `d across = cos ddy - sin ddx - along dpsi`.

use crate::iterate::Iterate;
use crate::problem::Problem;
use pairtrawl_model::Side;

/// A step in its frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    /// s, m.
    pub along: f64,
    /// h, m: zero for wheels that do not slip. The only equality of the problem.
    pub across: f64,
    /// Heading change, rad.
    pub turn: f64,
    /// Of the mid-step heading.
    pub sin: f64,
    /// Of the mid-step heading.
    pub cos: f64,
}

/// A coordinate of a step that costs and bounds are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Coordinate {
    /// The way forward, m.
    Along,
    /// The heading change, rad.
    Turn,
}

impl Coordinate {
    pub const BOTH: [Self; 2] = [Self::Along, Self::Turn];

    /// Its place among along, across, turn.
    #[inline]
    pub fn index(self) -> usize {
        match self {
            Self::Along => 0,
            Self::Turn => 2,
        }
    }
}

impl Step {
    /// From the poses (x, y, heading) at both ends.
    #[inline]
    pub fn new(from: &[f64], to: &[f64]) -> Self {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let (sin, cos) = libm::sincos(0.5 * (from[2] + to[2]));
        Self {
            along: dx * cos + dy * sin,
            across: dy * cos - dx * sin,
            turn: to[2] - from[2],
            sin,
            cos,
        }
    }

    /// A robot over the step from waypoint `i`.
    #[inline]
    pub fn of(x: &Iterate, i: usize, robot: Side) -> Self {
        let k = 3 * robot.index();
        Self::new(&x.stages[i][k..k + 3], &x.stages[i + 1][k..k + 3])
    }

    /// The same as the solver sees it: that of a robot that is held where it is stands for nothing that has to be met or removed, and
    /// keeps off every bound.
    #[inline]
    pub fn seen(problem: &Problem, x: &Iterate, i: usize, robot: Side) -> Self {
        if problem.frozen == Some(robot) {
            return Self {
                along: 0.5 * problem.planner.max_step,
                across: 0.0,
                turn: 0.0,
                sin: 0.0,
                cos: 1.0,
            };
        }
        Self::of(x, i, robot)
    }

    /// One of its coordinates.
    #[inline]
    pub fn coordinate(&self, coordinate: Coordinate) -> f64 {
        match coordinate {
            Coordinate::Along => self.along,
            Coordinate::Turn => self.turn,
        }
    }

    /// First-order change (of along, across, turn) for changes of the poses at both ends.
    #[inline]
    pub fn change(&self, from: &[f64], to: &[f64]) -> (f64, f64, f64) {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let psi = 0.5 * (from[2] + to[2]);
        (
            dx * self.cos + dy * self.sin + self.across * psi,
            dy * self.cos - dx * self.sin - self.along * psi,
            to[2] - from[2],
        )
    }
}
