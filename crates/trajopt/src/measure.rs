//! What a point is worth: merit and residuals of all costs and rows together.

use crate::active::ActiveSet;
use crate::costs;
use crate::costs::distance::Distance;
use crate::costs::turning::Turning;
use crate::iterate::{Iterate, STAGE};
use crate::merit::{Merit, Residuals};
use crate::problem::Problem;
use crate::row::{Row, larger};
use crate::step::Step;
use crate::term::Term;
use pairtrawl_model::Side;

impl ActiveSet {
    /// Merit and residuals of the point at which the rows stand.
    pub fn measure(&mut self, problem: &Problem, x: &Iterate, mu: f64) -> (Merit, Residuals) {
        self.rows_mut().for_each(Row::rest);
        let merit = self.trial_merit(problem, x, 0.0);
        (merit, self.advance(0.0, mu))
    }

    /// Merit at a trial point, slacks stepped by `alpha`; rows keep the values of their constraints there.
    pub fn trial_merit(&mut self, problem: &Problem, x: &Iterate, alpha: f64) -> Merit {
        let mut merit = Merit::default();
        let distance = Distance::of(&problem.planner);
        for (at, frame) in self.frames.iter_mut().enumerate() {
            *frame = Step::seen(problem, x, at / 2, Side::BOTH[at % 2]);
            merit.theta += frame.across.abs();
            merit.cost += distance.value(&[frame.along]);
        }
        merit.cost += other_costs(problem, x);
        let point = (x, &self.frames[..]);
        self.steps.add_to(&mut merit, problem, point, alpha);
        // Of steps only turning gives way, and that is its cost.
        let turning = merit.elastic;
        self.pairs.add_to(&mut merit, problem, point, alpha);
        self.points.add_to(&mut merit, problem, point, alpha);
        self.bodies.add_to(&mut merit, problem, point, alpha);
        self.lines.add_to(&mut merit, problem, point, alpha);
        merit.violation = merit.elastic - turning;
        merit
    }

    /// All rows go to the last trial point; how feasible and complementary they are there.
    pub fn advance(&mut self, alpha: f64, mu: f64) -> Residuals {
        let mut r = Residuals::default();
        self.rows_mut().for_each(|row| {
            row.advance(alpha);
            let (largest, products) = row.complementarity(mu);
            r.complementarity = larger(r.complementarity, largest);
            r.gap += products;
            r.products += row.products();
            r.primal = larger(r.primal, row.residual().abs());
        });
        let slip = |m: f64, step: &Step| m.max(step.across.abs());
        r.primal = self.frames.iter().fold(r.primal, slip);
        r
    }
}

/// The objective but for driven distance, and for that part of turning which is an elastic row.
fn other_costs(problem: &Problem, x: &Iterate) -> f64 {
    let count = x.stages.len();
    let turned = |v: usize| x.stages[count - 1][v] - x.stages[0][v];
    let mut total = Turning::minimized(&problem.planner).linear(turned(2) + turned(5));
    for i in 0..count {
        let z = x.pair(i);
        costs::of_pair(problem, i, &mut |cost| total += cost.value(&z));
        for robot in Side::BOTH {
            let z = x.point(i, robot);
            costs::of_point(problem, (i, robot), &mut |cost| total += cost.value(&z));
        }
    }
    for i in 1..count - 1 {
        for v in 0..STAGE {
            let z = [i - 1, i, i + 1].map(|k| x.stages[k][v]);
            costs::of_bend(problem, v, &mut |cost| total += cost.value(&z));
        }
    }
    total
}
