//! Fills the condensed Newton system with the derivatives of all costs and rows.
//!
//! Slacks, violations and multipliers of the inequalities are eliminated row by row; the equalities (no sideways slip) by
//! dual regularization, `A dx + h = delta (lambda+ - lambda)`, which leaves `A^T A / delta` in the band.

use crate::active::ActiveSet;
use crate::anchor::{Anchor, PairAt, PointAt};
use crate::block::{Block, Item, by_anchor};
use crate::costs;
use crate::costs::distance::Distance;
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
        mu: f64,
    ) {
        self.reset(x.stages.len());
        self.add_steps(problem, x, set, lambda, mu);
        self.add_pairs(problem, x, set, mu);
        self.add_bends(problem, x);
        self.add_points(problem, x, set, mu);
        let at = (x, set.frames.as_slice());
        self.add_rows_alone(&mut set.bodies, problem, at, mu);
        self.add_rows_alone(&mut set.lines, problem, at, mu);
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
        mu: f64,
    ) {
        for group in by_anchor(&mut block.items) {
            let (at, mut local) = (group[0].at, Local::new());
            add_rows(&mut local, group, problem, (x, frames), mu);
            at.scatter(&local, frames, self);
        }
    }

    /// The rows of steps with the equalities and the cost of distance: together they decide how a step's frame bends.
    fn add_steps(
        &mut self,
        problem: &Problem,
        x: &Iterate,
        set: &mut ActiveSet,
        lambda: &[f64],
        mu: f64,
    ) {
        let (frames, dual) = (&set.frames, 1.0 / DUAL_REGULARIZATION);
        let distance = Distance::of(&problem.planner);
        let mut groups = by_anchor(&mut set.steps.items).peekable();
        for (index, (step, &force)) in frames.iter().zip(lambda).enumerate() {
            let mut d = StepDerivatives::default();
            d.gradients[0][1] = force + dual * step.across;
            d.gradients[1][1] = force;
            d.diagonal[1] = dual;
            d.add_cost(Coordinate::Along, &distance.jet(&[step.along]));
            while let Some(group) = groups.next_if(|group| group[0].at.index() == index) {
                let (at, mut local) = (group[0].at, Local::new());
                add_rows(&mut local, group, problem, (x, frames), mu);
                d.add(at.coordinate(), &local);
            }
            d.bend(step, force);
            self.scatter_step(index / 2, Side::BOTH[index % 2], step, &d);
        }
    }

    fn add_pairs(&mut self, problem: &Problem, x: &Iterate, set: &mut ActiveSet, mu: f64) {
        let mut groups = by_anchor(&mut set.pairs.items).peekable();
        for i in 0..x.stages.len() {
            let (at, z, mut local) = (PairAt(i as u32), x.pair(i), Local::new());
            costs::of_pair(problem, i, &mut |cost| local.add_cost(&cost.convex_jet(&z)));
            if let Some(group) = groups.next_if(|group| group[0].at == at) {
                add_rows(&mut local, group, problem, (x, &set.frames), mu);
            }
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

    fn add_points(&mut self, problem: &Problem, x: &Iterate, set: &mut ActiveSet, mu: f64) {
        let mut groups = by_anchor(&mut set.points.items).peekable();
        for stage in 0..x.stages.len() {
            for robot in Side::BOTH {
                let at = PointAt::new(stage, robot);
                let (z, mut local, mut any) = (x.point(stage, robot), Local::new(), false);
                costs::of_point(problem, (stage, robot), &mut |cost| {
                    any = true;
                    local.add_cost(&cost.convex_jet(&z));
                });
                if let Some(group) = groups.next_if(|group| group[0].at == at) {
                    any = true;
                    add_rows(&mut local, group, problem, (x, &set.frames), mu);
                }
                if any {
                    at.scatter(&local, &set.frames, self);
                }
            }
        }
    }
}

/// Adds the rows of one anchor.
#[inline]
fn add_rows<R: Rules<K>, const K: usize>(
    local: &mut Local<K>,
    group: &mut [Item<R, K>],
    problem: &Problem,
    (x, frames): (&Iterate, &[Step]),
    mu: f64,
) {
    let at = group[0].at;
    let z = at.coordinates(x, frames);
    for item in group {
        (item.row.c, item.gradient) = item.rule.slope(problem, at, &z);
        local.add_row(&mut item.row, &item.gradient, mu);
    }
}
