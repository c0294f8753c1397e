//! The Newton direction of the condensed system, and what it means for slacks, violations and multipliers.

use crate::assembly::{DUAL_REGULARIZATION, System};
use crate::iterate::STAGE;
use crate::linear::BandMatrix;
use crate::row::Row;
use crate::state::State;
use crate::step::{Coordinate, STEP_BOUNDS};
use crate::term::PAIR;
use pairtrawl_model::Side;
use std::ops::Range;

/// Factorization and direction.
#[derive(Clone, Debug, Default)]
pub(crate) struct Newton {
    factor: BandMatrix,
    /// Of the inner stages.
    pub direction: Vec<f64>,
    /// Of the net length.
    pub length: f64,
    arrow: Vec<f64>,
    /// New multipliers of the equalities.
    pub lambda: Vec<f64>,
    /// Longest primal step that the rows of each stage, and of the step from it, allow.
    pub limits: Vec<f64>,
    /// Slope of the barrier function along the direction by the same rows.
    slopes: Vec<f64>,
    shift: f64,
}

const GREATEST_SHIFT: f64 = 1e10;
const SMALLEST_PIVOT: f64 = 1e-8;

impl Newton {
    /// Solves `(matrix + shift I) direction = -gradient` with the net length as one dense row; the shift grows until the
    /// matrix is positive definite. False when it cannot be made so.
    pub fn solve(&mut self, system: &System, free_length: bool, least_shift: f64) -> bool {
        let mut shift = least_shift;
        while shift < GREATEST_SHIFT {
            self.factor
                .copy_block(&system.matrix, 0..system.gradient.len(), shift);
            self.shift = shift;
            if self.factor.factorize(SMALLEST_PIVOT).is_ok() {
                self.direction.clear();
                self.direction.extend(system.gradient.iter().map(|g| -g));
                self.length = 0.0;
                if !free_length {
                    self.factor.solve([&mut self.direction]);
                    return self.direction.iter().all(|d| d.is_finite());
                }
                self.arrow.clone_from(&system.arrow);
                self.factor.solve([&mut self.direction, &mut self.arrow]);
                let schur = system.length.diagonal + shift - dot(&system.arrow, &self.arrow);
                if schur > SMALLEST_PIVOT {
                    self.length =
                        (-system.length.gradient - dot(&system.arrow, &self.direction)) / schur;
                    for (d, a) in self.direction.iter_mut().zip(&self.arrow) {
                        *d -= self.length * a;
                    }
                    return self.direction.iter().all(|d| d.is_finite());
                }
            }
            shift *= 10.0;
        }
        false
    }

    /// Solves for a range of inner stages alone, all else staying as it is. False when that part of the matrix is not positive
    /// definite.
    pub fn solve_part(&mut self, system: &System, stages: Range<usize>) -> bool {
        let block = (stages.start - 1) * STAGE..(stages.end - 1) * STAGE;
        self.factor
            .copy_block(&system.matrix, block.clone(), self.shift);
        if self.factor.factorize(SMALLEST_PIVOT).is_err() {
            return false;
        }
        self.arrow.clear();
        let columns = system.gradient[block.clone()]
            .iter()
            .zip(&system.arrow[block.clone()]);
        self.arrow
            .extend(columns.map(|(g, a)| -g - a * self.length));
        system
            .matrix
            .subtract_outside(block.clone(), &self.direction, &mut self.arrow);
        self.factor.solve([&mut self.arrow]);
        self.direction[block].copy_from_slice(&self.arrow);
        self.arrow.iter().all(|d| d.is_finite())
    }

    /// Slope of the barrier function along the direction.
    pub fn slope(&self, system: &System) -> f64 {
        let objective = dot(&system.objective, &self.direction);
        let barrier: f64 = self.slopes.iter().sum();
        objective + system.length.objective * self.length + barrier
    }

    fn stage(&self, i: usize, count: usize) -> [f64; STAGE] {
        if i == 0 || i + 1 == count {
            return [0.0; STAGE];
        }
        let b = (i - 1) * STAGE;
        std::array::from_fn(|v| self.direction[b + v])
    }

    /// Longest primal step that all rows and the net length allow.
    pub fn longest(&self, state: &State) -> f64 {
        // The net keeps half of its length in a step: what is convex in it is so only for positive lengths.
        let of_length = if self.length < 0.0 {
            (-0.5 * state.x.net_length / self.length).min(1.0)
        } else {
            1.0
        };
        self.limits.iter().fold(of_length, |m, &l| m.min(l))
    }

    /// What the direction means for all rows, and for the multipliers of the equalities (they always take the full step).
    pub fn recover(&mut self, state: &mut State, frozen: Option<Side>) {
        let count = state.x.stages.len();
        self.lambda.clone_from(&state.lambda);
        self.limits.resize(count, 1.0);
        self.slopes.resize(count, 0.0);
        self.recover_part(state, frozen, 0..count);
    }

    /// As [`Self::recover`] for the rows of a range of stages and of the steps from them.
    pub fn recover_part(&mut self, state: &mut State, frozen: Option<Side>, part: Range<usize>) {
        let (count, mu, set) = (state.x.stages.len(), state.mu, &mut state.set);
        self.limits[part.clone()].fill(1.0);
        self.slopes[part.clone()].fill(0.0);
        let steps = part.start..part.end.min(count - 1);
        for (i, robot) in steps.flat_map(|i| Side::BOTH.map(|robot| (i, robot))) {
            let at = 2 * i + robot.index();
            let k = 3 * robot.index();
            let (a, b) = (self.stage(i, count), self.stage(i + 1, count));
            let step = &set.frames[at];
            let (along, across, turn) = step.change(&a[k..k + 3], &b[k..k + 3]);
            let rows = &mut set.steps[at * STEP_BOUNDS..(at + 1) * STEP_BOUNDS];
            for (kind, row) in rows.iter_mut().enumerate() {
                let change = [along, across, turn][Coordinate::of_bound(kind).index()];
                finish(
                    row,
                    mu,
                    &[change],
                    (&mut self.limits[i], &mut self.slopes[i]),
                );
            }
            if frozen != Some(robot) {
                self.lambda[at] = state.lambda[at] + (step.across + across) / DUAL_REGULARIZATION;
            }
        }
        for pair in within(&mut set.pairs, &part, |p| p.stage) {
            let i = pair.stage as usize;
            let d = self.stage(i, count);
            let local: [f64; PAIR] = [d[0] - d[3], d[1] - d[4], d[2], d[5], self.length];
            finish(
                &mut pair.row,
                mu,
                &local,
                (&mut self.limits[i], &mut self.slopes[i]),
            );
        }
        for point in within(&mut set.points, &part, |p| p.stage) {
            let i = point.stage as usize;
            let d = self.stage(i, count);
            let k = 3 * point.robot.index();
            let local = [d[k], d[k + 1]];
            finish(
                &mut point.row,
                mu,
                &local,
                (&mut self.limits[i], &mut self.slopes[i]),
            );
        }
        for quad in within(&mut set.quads, &part, |q| q.step) {
            let i = quad.step as usize;
            let (a, b) = (self.stage(i, count), self.stage(i + 1, count));
            let local = [a[0], a[1], a[3], a[4], b[0], b[1], b[3], b[4]];
            finish(
                &mut quad.row,
                mu,
                &local,
                (&mut self.limits[i], &mut self.slopes[i]),
            );
        }
    }
}

/// The rows of a range of stages, out of a list in the order of stages.
pub(crate) fn within<'a, T>(
    rows: &'a mut [T],
    part: &Range<usize>,
    stage: impl Fn(&T) -> u32,
) -> &'a mut [T] {
    let first = rows.partition_point(|r| (stage(r) as usize) < part.start);
    let end = rows.partition_point(|r| (stage(r) as usize) < part.end);
    &mut rows[first..end]
}

#[inline]
fn finish<const K: usize>(
    row: &mut Row<K>,
    mu: f64,
    local: &[f64; K],
    (limit, slope): (&mut f64, &mut f64),
) {
    row.recover(mu, inner(&row.gradient, local));
    row.limit_step(limit);
    *slope += row.barrier_slope(mu);
}

#[inline]
fn inner<const K: usize>(a: &[f64; K], b: &[f64; K]) -> f64 {
    (0..K).map(|i| a[i] * b[i]).sum()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
