//! The Newton direction of the condensed system, and what it means for slacks, violations and multipliers.

use crate::anchor::Anchor;
use crate::assembly::DUAL_REGULARIZATION;
use crate::block::{Block, inner};
use crate::iterate::{Direction, STAGE};
use crate::linear::BandMatrix;
use crate::rule::Rules;
use crate::state::State;
use crate::step::Step;
use crate::system::System;
use pairtrawl_model::Side;
use std::ops::Range;

/// Factorization and direction.
#[derive(Clone, Debug, Default)]
pub(crate) struct Newton {
    factor: BandMatrix,
    pub direction: Direction,
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
                self.direction.inner.clear();
                self.direction
                    .inner
                    .extend(system.gradient.iter().map(|g| -g));
                self.direction.length = 0.0;
                if !free_length {
                    self.factor.solve([&mut self.direction.inner]);
                    return self.direction.inner.iter().all(|d| d.is_finite());
                }
                self.arrow.clone_from(&system.arrow);
                self.factor
                    .solve([&mut self.direction.inner, &mut self.arrow]);
                let schur = system.length.diagonal + shift - dot(&system.arrow, &self.arrow);
                if schur > SMALLEST_PIVOT {
                    self.direction.length = (-system.length.gradient
                        - dot(&system.arrow, &self.direction.inner))
                        / schur;
                    for (d, a) in self.direction.inner.iter_mut().zip(&self.arrow) {
                        *d -= self.direction.length * a;
                    }
                    return self.direction.inner.iter().all(|d| d.is_finite());
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
            .extend(columns.map(|(g, a)| -g - a * self.direction.length));
        system
            .matrix
            .subtract_outside(block.clone(), &self.direction.inner, &mut self.arrow);
        self.factor.solve([&mut self.arrow]);
        self.direction.inner[block].copy_from_slice(&self.arrow);
        self.arrow.iter().all(|d| d.is_finite())
    }

    /// Slope of the barrier function along the direction.
    pub fn slope(&self, system: &System) -> f64 {
        let objective = dot(&system.objective, &self.direction.inner);
        let barrier: f64 = self.slopes.iter().sum();
        objective + system.length.objective * self.direction.length + barrier
    }

    /// Longest primal step that all rows and the net length allow.
    pub fn longest(&self, state: &State) -> f64 {
        // The net keeps half of its length in a step: what is convex in it is so only for positive lengths.
        let of_length = if self.direction.length < 0.0 {
            (-0.5 * state.x.net_length / self.direction.length).min(1.0)
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
        let (mu, set) = (state.mu, &mut state.set);
        self.limits[part.clone()].fill(1.0);
        self.slopes[part.clone()].fill(0.0);
        let (frames, part) = (&set.frames, &part);
        self.recover_slips(&state.lambda, frames, frozen, part);
        self.recover_rows(&mut set.steps, frames, mu, part);
        self.recover_rows(&mut set.pairs, frames, mu, part);
        self.recover_rows(&mut set.points, frames, mu, part);
        self.recover_rows(&mut set.bodies, frames, mu, part);
        self.recover_rows(&mut set.lines, frames, mu, part);
    }

    fn recover_slips(
        &mut self,
        lambda: &[f64],
        frames: &[Step],
        frozen: Option<Side>,
        part: &Range<usize>,
    ) {
        for i in part.start..part.end.min(frames.len() / 2) {
            let (a, b) = (self.direction.stage(i), self.direction.stage(i + 1));
            for robot in Side::BOTH.into_iter().filter(|r| frozen != Some(*r)) {
                let (at, k) = (2 * i + robot.index(), 3 * robot.index());
                let (_, across, _) = frames[at].change(&a[k..k + 3], &b[k..k + 3]);
                self.lambda[at] = lambda[at] + (frames[at].across + across) / DUAL_REGULARIZATION;
            }
        }
    }

    fn recover_rows<R: Rules<K>, const K: usize>(
        &mut self,
        block: &mut Block<R, K>,
        frames: &[Step],
        mu: f64,
        part: &Range<usize>,
    ) {
        for rows in block.within(part).chunk_by_mut(|a, b| a.at == b.at) {
            let at = rows[0].at;
            let (i, change) = (at.stage(), at.change(&self.direction, frames));
            let (mut limit, mut slope) = (self.limits[i], self.slopes[i]);
            for item in rows {
                item.row.recover(mu, inner(&item.gradient, &change));
                item.row.limit_step(&mut limit);
                slope += item.row.barrier_slope(mu);
            }
            (self.limits[i], self.slopes[i]) = (limit, slope);
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
