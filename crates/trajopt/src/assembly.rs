//! Fills the condensed Newton system with the derivatives of all costs and rows.
//!
//! Slacks, violations and multipliers of the inequalities are eliminated row by row; the equalities (no sideways slip) by
//! dual regularization, `A dx + h = delta (lambda+ - lambda)`, which leaves `A^T A / delta` in the band.

use crate::active::ActiveSet;
use crate::anchor::{Anchor, PairAt, PointAt, StepAt};
use crate::block::Block;
use crate::costs;
use crate::costs::distance::Distance;
use crate::curvature::Curvature;
use crate::iterate::{Iterate, STAGE};
use crate::local::Local;
use crate::problem::Problem;
use crate::rule::Rules;
use crate::step::{Coordinate, Step};
use crate::system::{StepDerivatives, System};
use crate::term::Term;
use pairtrawl_model::Side;

/// Dual regularization of the equalities.
pub(crate) const DUAL_REGULARIZATION: f64 = 1e-9;

impl System {
    /// Evaluates all derivatives at an iterate; rows remember the values and gradients of their constraints.
    pub fn assemble(
        &mut self,
        problem: &Problem,
        x: &Iterate,
        set: &mut ActiveSet,
        lambda: &[f64],
        (mu, curvature): (f64, Curvature),
    ) {
        self.reset(x.stages.len());
        self.add_steps(problem, set, lambda, (mu, curvature));
        self.add_pairs(problem, x, set, (mu, curvature));
        self.add_bends(problem, x);
        self.add_points(problem, x, set, (mu, curvature));
        let at = (x, set.frames.as_slice());
        self.add_rows_alone(&mut set.bodies, problem, at, (mu, curvature));
        self.add_rows_alone(&mut set.lines, problem, at, (mu, curvature));
        if let Some(robot) = problem.frozen {
            self.freeze(robot);
        }
    }

    /// Rows at anchors that have no cost and no equality.
    fn add_rows_alone<R: Rules<K>, const K: usize>(
        &mut self,
        block: &mut Block<R, K>,
        problem: &Problem,
        (x, frames): (&Iterate, &[Step]),
        (mu, curvature): (f64, Curvature),
    ) {
        let mut rows = block.remaining();
        while let Some(at) = rows.anchor() {
            let (z, mut local) = (at.coordinates(x, frames), Local::new());
            rows.add_to(&mut local, problem, (at, &z), mu, curvature);
            at.scatter(&local, frames, self);
        }
    }

    /// The rows of steps with the equalities and the cost of distance: together they decide how a step's frame bends.
    fn add_steps(
        &mut self,
        problem: &Problem,
        set: &mut ActiveSet,
        lambda: &[f64],
        (mu, curvature): (f64, Curvature),
    ) {
        let (frames, dual) = (&set.frames, 1.0 / DUAL_REGULARIZATION);
        let distance = Distance::of(&problem.planner);
        let mut rows = set.steps.remaining();
        for (index, (step, &force)) in frames.iter().zip(lambda).enumerate() {
            let mut d = StepDerivatives::default();
            d.gradients[0][1] = force + dual * step.across;
            d.gradients[1][1] = force;
            d.diagonal[1] = dual;
            d.add_cost(Coordinate::Along, &distance.jet(&[step.along]));
            for coordinate in Coordinate::BOTH {
                let (at, z) = (StepAt::of(index, coordinate), [step.coordinate(coordinate)]);
                let mut local = Local::new();
                rows.add_to(&mut local, problem, (at, &z), mu, curvature);
                d.add(coordinate, &local);
            }
            match curvature {
                Curvature::Convex => d.bend(step, force),
                Curvature::Exact => d.bend_exactly(step, force),
            }
            self.scatter_step(index / 2, Side::BOTH[index % 2], step, &d);
        }
    }

    fn add_pairs(
        &mut self,
        problem: &Problem,
        x: &Iterate,
        set: &mut ActiveSet,
        (mu, curvature): (f64, Curvature),
    ) {
        let mut rows = set.pairs.remaining();
        for i in 0..x.stages.len() {
            let (at, z, mut local) = (PairAt(i as u32), x.pair(i), Local::new());
            costs::of_pair(problem, i, &mut |cost| {
                local.add_cost(&curvature.of(cost, &z))
            });
            rows.add_to(&mut local, problem, (at, &z), mu, curvature);
            at.scatter(&local, &set.frames, self);
        }
    }

    fn add_bends(&mut self, problem: &Problem, x: &Iterate) {
        for variable in 0..STAGE {
            costs::of_bend(problem, variable, &mut |cost| {
                for stage in 1..x.stages.len() - 1 {
                    let z = [stage - 1, stage, stage + 1].map(|i| x.stages[i][variable]);
                    let local = Local::of_cost(&cost.convex_jet(&z));
                    self.scatter_bend(stage, variable, &local);
                }
            });
        }
    }

    fn add_points(
        &mut self,
        problem: &Problem,
        x: &Iterate,
        set: &mut ActiveSet,
        (mu, curvature): (f64, Curvature),
    ) {
        let mut rows = set.points.remaining();
        for stage in 0..x.stages.len() {
            for robot in Side::BOTH {
                let at = PointAt::new(stage, robot);
                let (z, mut local, mut any) = (x.point(stage, robot), Local::new(), false);
                costs::of_point(problem, (stage, robot), &mut |cost| {
                    any = true;
                    local.add_cost(&curvature.of(cost, &z));
                });
                let count = rows.add_to(&mut local, problem, (at, &z), mu, curvature);
                if any || count > 0 {
                    at.scatter(&local, &set.frames, self);
                }
            }
        }
    }
}
