//! The Newton direction of the condensed system, and what it means for slacks, violations and multipliers.

use crate::assembly::{DUAL_REGULARIZATION, System};
use crate::interior_point::State;
use crate::iterate::STAGE;
use crate::linear::BandMatrix;
use crate::row::Row;
use crate::step::{Coordinate, STEP_BOUNDS, TURN_COST};
use crate::term::PAIR;

/// Factorization and direction.
#[derive(Clone, Debug, Default)]
pub(crate) struct Newton {
    factor: BandMatrix,
    /// Of the inner stages.
    pub direction: Vec<f64>,
    /// Of the net length.
    pub length: f64,
    arrow: Vec<f64>,
}

const GREATEST_SHIFT: f64 = 1e10;
const SMALLEST_PIVOT: f64 = 1e-8;

impl Newton {
    /// Solves `(matrix + shift I) direction = -gradient` with the net length as one dense row; the shift grows until the
    /// matrix is positive definite. False when it cannot be made so.
    pub fn solve(&mut self, system: &System, free_length: bool, least_shift: f64) -> bool {
        let mut shift = least_shift;
        while shift < GREATEST_SHIFT {
            self.factor.copy_shifted(&system.matrix, shift);
            if self.factor.factorize(SMALLEST_PIVOT).is_ok() {
                self.direction.clear();
                self.direction.extend(system.gradient.iter().map(|g| -g));
                self.factor.solve(&mut self.direction);
                self.length = 0.0;
                if !free_length {
                    return self.direction.iter().all(|d| d.is_finite());
                }
                self.arrow.clone_from(&system.arrow);
                self.factor.solve(&mut self.arrow);
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

    /// Slope of the objective along the direction.
    pub fn objective_slope(&self, system: &System) -> f64 {
        dot(&system.objective, &self.direction) + system.length.objective * self.length
    }

    fn stage(&self, i: usize, count: usize) -> [f64; STAGE] {
        if i == 0 || i + 1 == count {
            return [0.0; STAGE];
        }
        let b = (i - 1) * STAGE;
        std::array::from_fn(|v| self.direction[b + v])
    }

    /// Steps of all rows, the longest primal step length, and new multipliers of the equalities (they always take the full step).
    pub fn recover(&self, state: &mut State, system: &System, frozen: Option<usize>) -> f64 {
        let count = state.x.stages.len();
        let mu = state.mu;
        let mut longest = 1.0;
        // The net keeps half of its length in a step: what is convex in it is so only for positive lengths.
        if self.length < 0.0 {
            longest = (-0.5 * state.x.net_length / self.length).min(1.0);
        }
        for (at, rows) in state.set.steps.chunks_exact_mut(STEP_BOUNDS).enumerate() {
            let (i, k) = (at / 2, 3 * (at % 2));
            let (a, b) = (self.stage(i, count), self.stage(i + 1, count));
            let step = &system.steps[at];
            let (along, across, turn) = step.change(&a[k..k + 3], &b[k..k + 3]);
            for (kind, row) in rows.iter_mut().enumerate() {
                let change = if coordinate_of(kind) == Coordinate::Along {
                    along
                } else {
                    turn
                };
                finish(row, mu, &[change], &mut longest);
            }
            if frozen == Some(at % 2) {
                continue;
            }
            state.lambda[at] += (step.across + across) / DUAL_REGULARIZATION;
        }
        for pair in &mut state.set.pairs {
            let d = self.stage(pair.stage as usize, count);
            let local: [f64; PAIR] = [d[0] - d[3], d[1] - d[4], d[2], d[5], self.length];
            finish(&mut pair.row, mu, &local, &mut longest);
        }
        for point in &mut state.set.points {
            let d = self.stage(point.stage as usize, count);
            let k = 3 * point.robot as usize;
            finish(&mut point.row, mu, &[d[k], d[k + 1]], &mut longest);
        }
        for rung in &mut state.set.rungs {
            let d = self.stage(rung.stage as usize, count);
            finish(&mut rung.row, mu, &[d[0], d[1], d[3], d[4]], &mut longest);
        }
        longest
    }
}

/// The coordinate that a bound of a step is on, by its index.
fn coordinate_of(kind: usize) -> Coordinate {
    const { assert!(TURN_COST == 4 && STEP_BOUNDS == 5) };
    if kind < 2 {
        Coordinate::Along
    } else {
        Coordinate::Turn
    }
}

#[inline]
fn finish<const K: usize>(row: &mut Row<K>, mu: f64, local: &[f64; K], longest: &mut f64) {
    row.recover(mu, row.residual(), inner(&row.gradient, local));
    row.limit_step(longest);
}

#[inline]
fn inner<const K: usize>(a: &[f64; K], b: &[f64; K]) -> f64 {
    (0..K).map(|i| a[i] * b[i]).sum()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
