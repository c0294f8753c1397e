use crate::anchor::StepAt;
use crate::problem::Problem;
use crate::rule::Rule;
use crate::sight::Sight;
use crate::step::Coordinate;
use crate::step_bound::StepBound;
use crate::term::{STEP, Term};
use pairtrawl_model::Side;

/// Kept within the claims, so that rounding does not break them.
const ROUNDING: f64 = 1e-7;

/// Every step goes forward.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Forward;

/// Every step is at most Delta L_max long.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepLength;

/// Every step turns at most Delta phi_max to a side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TurnLimit(Side);

impl Rule<StepAt, STEP> for Forward {
    fn look_up(_: &mut Sight, at: StepAt, add: &mut impl FnMut(Self)) {
        if at.coordinate() == Coordinate::Along {
            add(Self);
        }
    }

    #[inline]
    fn term(self, _: &Problem, _: StepAt) -> impl Term<STEP> {
        StepBound {
            sign: 1.0,
            offset: -ROUNDING,
        }
    }

    fn price(self, _: &Problem, _: f64) -> f64 {
        f64::INFINITY
    }
}

impl Rule<StepAt, STEP> for StepLength {
    fn look_up(_: &mut Sight, at: StepAt, add: &mut impl FnMut(Self)) {
        if at.coordinate() == Coordinate::Along {
            add(Self);
        }
    }

    #[inline]
    fn term(self, problem: &Problem, _: StepAt) -> impl Term<STEP> {
        StepBound {
            sign: -1.0,
            offset: problem.planner.max_step - ROUNDING,
        }
    }

    fn price(self, _: &Problem, _: f64) -> f64 {
        f64::INFINITY
    }
}

impl Rule<StepAt, STEP> for TurnLimit {
    fn look_up(_: &mut Sight, at: StepAt, add: &mut impl FnMut(Self)) {
        if at.coordinate() == Coordinate::Turn {
            Side::BOTH.into_iter().map(Self).for_each(add);
        }
    }

    #[inline]
    fn term(self, problem: &Problem, _: StepAt) -> impl Term<STEP> {
        StepBound {
            // A turn to the left is positive.
            sign: -self.0.sign(),
            offset: problem.planner.max_turn - ROUNDING,
        }
    }

    fn key(self) -> u32 {
        self.0.index() as u32
    }

    fn price(self, _: &Problem, _: f64) -> f64 {
        f64::INFINITY
    }
}
