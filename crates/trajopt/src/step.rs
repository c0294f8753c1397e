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

/// Which coordinate a bound is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Coordinate {
    Along,
    Turn,
}

impl Coordinate {
    /// Its place among along, across, turn.
    #[inline]
    pub fn index(self) -> usize {
        match self {
            Self::Along => 0,
            Self::Turn => 2,
        }
    }

    /// The one that a bound of a step is on, by the bound's place.
    #[inline]
    pub fn of_bound(kind: usize) -> Self {
        const { assert!(TURN_COST == 4 && STEP_BOUNDS == 5) };
        if kind < 2 { Self::Along } else { Self::Turn }
    }
}

/// A bound `offset + sign * coordinate >= 0`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepBound {
    pub coordinate: Coordinate,
    pub sign: f64,
    pub offset: f64,
}

/// Bounds of one robot in one step.
pub(crate) const STEP_BOUNDS: usize = 5;
/// Index of the bound that stands for the cost of turning: with weight `2 t2` it makes
/// `t2 |delta| = -t2 delta + 2 t2 max(0, delta)` exactly, without a smoothing width.
pub(crate) const TURN_COST: usize = 4;
/// Kept within the claims, so that rounding does not break them.
const ROUNDING: f64 = 1e-7;

impl Problem {
    /// Forward and at most Delta L_max long, turning at most Delta phi_max either way (the paper's maximum velocity
    /// constraint), and the cost of turning.
    pub(crate) fn step_bounds(&self) -> [StepBound; STEP_BOUNDS] {
        use Coordinate::{Along, Turn};
        let bound = |coordinate, sign, offset| StepBound {
            coordinate,
            sign,
            offset,
        };
        let (step, turn) = (
            self.planner.max_step - ROUNDING,
            self.planner.max_turn - ROUNDING,
        );
        [
            bound(Along, 1.0, 0.0),
            bound(Along, -1.0, step),
            bound(Turn, 1.0, turn),
            bound(Turn, -1.0, turn),
            bound(Turn, -1.0, 0.0),
        ]
    }
}

impl Problem {
    /// A robot-step of an iterate. That of a robot that is held where it is stands for nothing to be met or mended: it keeps
    /// off every bound.
    pub(crate) fn step(&self, x: &Iterate, i: usize, robot: Side) -> Step {
        if self.frozen == Some(robot) {
            return Step {
                along: 0.5 * self.planner.max_step,
                across: 0.0,
                turn: 0.0,
                sin: 0.0,
                cos: 1.0,
            };
        }
        Step::of(x, i, robot)
    }
}

impl StepBound {
    /// Its value at a step.
    #[inline]
    pub fn value(&self, step: &Step) -> f64 {
        self.offset
            + self.sign
                * match self.coordinate {
                    Coordinate::Along => step.along,
                    Coordinate::Turn => step.turn,
                }
    }
}

impl Step {
    /// A robot over the step from waypoint `i`.
    #[inline]
    pub fn of(x: &Iterate, i: usize, robot: Side) -> Self {
        let k = 3 * robot.index();
        Self::new(&x.stages[i][k..k + 3], &x.stages[i + 1][k..k + 3])
    }

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
