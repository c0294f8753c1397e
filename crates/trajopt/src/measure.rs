//! What a point is worth: merit and residuals of all rows and costs together.

use crate::active::ActiveSet;
use crate::iterate::{Iterate, STAGE};
use crate::merit::{Merit, Residuals};
use crate::problem::Problem;
use crate::row::{Row, larger};
use crate::step::{STEP_BOUNDS, Step};
use crate::term::Term;
use pairtrawl_model::Side;

impl ActiveSet {
    /// Merit and residuals of the point at which the rows stand.
    pub fn measure(&mut self, problem: &Problem, x: &Iterate, mu: f64) -> (Merit, Residuals) {
        each_row_mut!(self, row, { row.rest() });
        let merit = self.trial_merit(problem, x, 0.0);
        (merit, self.advance(0.0, mu))
    }

    /// Merit at a trial point, slacks stepped by `alpha`; rows keep the values of their constraints there.
    pub fn trial_merit(&mut self, problem: &Problem, x: &Iterate, alpha: f64) -> Merit {
        let mut merit = Merit {
            cost: objective(problem, x),
            ..Merit::default()
        };
        let bounds = problem.step_bounds();
        let steps = self.steps.chunks_exact_mut(STEP_BOUNDS);
        for ((at, rows), frame) in steps.enumerate().zip(&mut self.frames) {
            let step = problem.step(x, at / 2, Side::BOTH[at % 2]);
            *frame = step;
            merit.theta += step.across.abs();
            merit.cost += problem.distance_weight() * step.along;
            for (row, bound) in rows.iter_mut().zip(&bounds) {
                merit.add(row, alpha, bound.value(&step));
            }
        }
        let turning = merit.elastic;
        for pair in &mut self.pairs {
            let stage = pair.stage as usize;
            let z = x.pair(stage);
            merit.add(
                &mut pair.row,
                alpha,
                problem.pair_term(pair.kind, stage, |t| t.value(&z)),
            );
        }
        for point in &mut self.points {
            let z = x.point(point.stage as usize, point.robot);
            merit.add(
                &mut point.row,
                alpha,
                problem.point_term(&point.kind, |t| t.value(&z)),
            );
        }
        for quad in &mut self.quads {
            let z = x.quad(quad.step as usize);
            merit.add(
                &mut quad.row,
                alpha,
                problem.quad_distance(quad.piece, quad.tier).value(&z),
            );
        }
        merit.violation = merit.elastic - turning;
        merit
    }

    /// All rows go to the last trial point; how feasible and complementary they are there.
    pub fn advance(&mut self, alpha: f64, mu: f64) -> Residuals {
        let mut r = Residuals::default();
        each_row_mut!(self, row, {
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

impl Merit {
    #[inline]
    fn add<const K: usize>(&mut self, row: &mut Row<K>, alpha: f64, c: f64) {
        row.c = c;
        let (s, e) = row.stepped(alpha, c);
        self.theta += (c - s + e).abs();
        row.add_to(self, s, e);
    }
}

/// The objective but for driven distance, which is summed with the bounds of the steps.
fn objective(problem: &Problem, x: &Iterate) -> f64 {
    let (expansion, weights) = (problem.expansion(), problem.smoothness());
    let count = x.stages.len();
    // Turning is -t2 delta, which telescopes, plus an elastic row.
    let turned = |v: usize| x.stages[count - 1][v] - x.stages[0][v];
    let mut total = -problem.turn_weight() * (turned(2) + turned(5));
    for i in 0..count {
        total += expansion.value(&x.pair(i));
    }
    for w in x.stages.windows(3) {
        for v in 0..STAGE {
            let difference = w[0][v] - 2.0 * w[1][v] + w[2][v];
            total += weights[v % 3] * difference * difference;
        }
    }
    total
}
