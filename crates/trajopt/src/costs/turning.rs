use crate::anchor::StepAt;
use crate::problem::Problem;
use crate::rule::Rule;
use crate::sight::Sight;
use crate::step::Coordinate;
use crate::step_bound::StepBound;
use crate::term::{Jet, STEP, Term};
use pairtrawl_model::PlannerParameters;

/// The second part of J_dist (the paper's eq. 7): a heading change in one step costs `weight |turn|`.
///
/// The solver splits it, without a smoothing width, into a linear part and the violation of a bound ([`TurnCost`]):
/// `weight |turn| = -weight turn + 2 weight max(0, turn)`. Summed over a course the linear part depends on the headings at
/// its ends alone.
#[derive(Clone, Copy, Debug)]
pub struct Turning {
    /// `a2 t2`, 1/rad.
    pub weight: f64,
}

/// What a radian costs the solver at least: a thousandth of the paper's cost.
const LEAST_WEIGHT: f64 = 0.01;

impl Turning {
    /// Of a scene.
    pub fn of(p: &PlannerParameters) -> Self {
        Self {
            weight: p.a2 * p.t2,
        }
    }

    /// What the solver minimizes: turning costs it a little even where it is free. Else headings where a robot stands are
    /// undetermined.
    pub(crate) fn minimized(p: &PlannerParameters) -> Self {
        let Self { weight } = Self::of(p);
        Self {
            weight: weight.max(LEAST_WEIGHT),
        }
    }

    /// The linear part.
    pub fn linear(&self, turn: f64) -> f64 {
        -self.weight * turn
    }
}

impl Term<STEP> for Turning {
    #[inline]
    fn value(&self, &[turn]: &[f64; STEP]) -> f64 {
        self.weight * turn.abs()
    }

    #[inline]
    fn jet(&self, z: &[f64; STEP]) -> Jet<STEP> {
        Jet::linear(self.value(z), [self.weight * z[0].signum()])
    }
}

/// The bound `-turn >= 0`, whose violation is what turning costs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TurnCost;

impl Rule<StepAt, STEP> for TurnCost {
    fn look_up(_: &mut Sight, at: StepAt, add: &mut impl FnMut(Self)) {
        if at.coordinate() == Coordinate::Turn {
            add(Self);
        }
    }

    #[inline]
    fn term(self, _: &Problem, _: StepAt) -> impl Term<STEP> {
        StepBound {
            sign: -1.0,
            offset: 0.0,
        }
    }

    fn price(self, problem: &Problem, _: f64) -> f64 {
        2.0 * Turning::minimized(&problem.planner).weight
    }
}
