//! Bounds that the Newton step does not feel yet.
//!
//! A slack that shrinks too fast would end the step of the whole course early, one row of a hundred thousand. Its multiplier
//! is still small, so that the condensed matrix hardly resists. Such rows take the step of their multiplier at once, and the
//! direction is found again: the others then go almost as far as they want. On a long course that is done where such rows
//! are, and the rest of the direction stays. The curvature of the slip's frame stays that of the assembled multipliers.

use crate::anchor::Anchor;
use crate::block::Block;
use crate::local::Local;
use crate::problem::Problem;
use crate::rule::Rules;
use crate::state::State;
use crate::step::Step;
use crate::system::System;
use crate::workspace::Workspace;
use std::ops::Range;

/// Directions at most that are found again in an iteration.
const ROUNDS: usize = 3;
/// The same for parts of a course.
const PART_ROUNDS: usize = 6;
/// Rows that would end the step before this share of it are reinforced.
const SHORT: f64 = 0.75;
/// Stages on either side of a reinforced row whose direction is found again.
const REACH: usize = 30;
/// Parts that make up more than this share of the course are not worth the trouble.
const GREATEST_SHARE: f64 = 0.5;

impl Workspace {
    /// The Newton direction at the assembled point, rows that would end the step early reinforced; the longest primal step
    /// length. `None` when the matrix cannot be factorized.
    pub fn direction(&mut self, problem: &Problem, state: &mut State, shift: f64) -> Option<f64> {
        let free_length = problem.net_length.is_none();
        let newton = &mut self.newton;
        if !newton.solve(&self.system, free_length, shift) {
            return None;
        }
        newton.recover(state, problem.frozen);
        let (mut rounds, mut part_rounds) = (0, 0);
        let longest = loop {
            let longest = newton.longest(state);
            if longest >= SHORT || rounds == ROUNDS || part_rounds == PART_ROUNDS {
                break longest;
            }
            self.system
                .reinforce(state, &newton.limits, &mut self.parts);
            if self.parts.is_empty() {
                break longest;
            }
            let stages: usize = self.parts.iter().map(Range::len).sum();
            let in_parts = stages as f64 <= GREATEST_SHARE * state.x.stages.len() as f64
                && self
                    .parts
                    .iter()
                    .all(|part| newton.solve_part(&self.system, part.clone()));
            if in_parts {
                part_rounds += 1;
                for part in &self.parts {
                    // The step to the first stage of the part changes as well.
                    newton.recover_part(state, problem.frozen, part.start - 1..part.end);
                }
            } else {
                rounds += 1;
                if !newton.solve(&self.system, free_length, shift) {
                    return None;
                }
                newton.recover(state, problem.frozen);
            }
        };
        state.lambda.clone_from(&newton.lambda);
        Some(longest)
    }
}

impl System {
    /// Raises the multipliers of the rows that would end the step early, and adds what that changes. `parts` become the
    /// inner stages around them.
    fn reinforce(&mut self, state: &mut State, limits: &[f64], parts: &mut Vec<Range<usize>>) {
        let count = state.x.stages.len();
        parts.clear();
        for (i, &limit) in limits.iter().enumerate() {
            if limit < SHORT && self.reinforce_stage(state, i) {
                let (start, end) = (
                    i.saturating_sub(REACH).max(1),
                    (i + 2 + REACH).min(count - 1),
                );
                match parts.last_mut() {
                    Some(last) if start <= last.end => last.end = end,
                    _ => parts.push(start..end),
                }
            }
        }
    }

    /// The rows of a stage and of the step from it. False when none was raised.
    fn reinforce_stage(&mut self, state: &mut State, i: usize) -> bool {
        let (mu, set) = (state.mu, &mut state.set);
        let (frames, stage) = (&set.frames, i..i + 1);
        let raised = [
            self.reinforce_rows(&mut set.steps, frames, mu, &stage),
            self.reinforce_rows(&mut set.pairs, frames, mu, &stage),
            self.reinforce_rows(&mut set.points, frames, mu, &stage),
            self.reinforce_rows(&mut set.bodies, frames, mu, &stage),
            self.reinforce_rows(&mut set.lines, frames, mu, &stage),
        ];
        raised.contains(&true)
    }

    fn reinforce_rows<R: Rules<K>, const K: usize>(
        &mut self,
        block: &mut Block<R, K>,
        frames: &[Step],
        mu: f64,
        stage: &Range<usize>,
    ) -> bool {
        let mut any = false;
        for item in block.within(stage) {
            if let Some(added) = item.row.reinforce(mu, SHORT) {
                any = true;
                let local = Local::of_row(&item.gradient, added);
                item.at.scatter(&local, frames, self);
            }
        }
        any
    }
}
