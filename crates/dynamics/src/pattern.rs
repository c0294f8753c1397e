//! Which parts of a step depend on each other, in which order they are eliminated, and where the blocks of the matrix and of its
//! factor are kept.
//!
//! Parts (robots, hinges, objects) that take part have a slot each, in the order of elimination. Most of it stays what it was from step to
//! step: the order is found anew only when two parts depend on each other that did not, or when many no longer do.

use crate::elimination::{Elimination, NONE};

/// The order is found anew when fewer than three quarters of the ties are still wanted.
const WANTED: usize = 4;
/// So many ties that are no longer wanted do not matter.
const SPARE: usize = 16;

/// Slots of parts, and the places of blocks.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pattern {
    /// By part: its slot, or [`NONE`].
    slots: Vec<u32>,
    /// How many slots there are.
    size: usize,
    /// Matrix: the slots that come before and are tied, in ascending order, from `row_begins[i]` to `row_begins[i + 1]`. Block (i, j)
    /// is kept at the number of slots + its place in this list, block (i, i) at i.
    row_begins: Vec<u32>,
    columns: Vec<u32>,
    /// Factor: the slots below the diagonal of each column, in ascending order. Blocks are kept as those of the matrix.
    pub(crate) column_begins: Vec<u32>,
    pub(crate) rows: Vec<u32>,
    /// For each block of the factor below the diagonal: where the matrix keeps it, or [`NONE`].
    pub(crate) sources: Vec<u32>,
    /// What is subtracted from each column, from `update_begins[j]` to `update_begins[j + 1]`.
    pub(crate) update_begins: Vec<u32>,
    pub(crate) updates: Vec<Update>,
    /// Where the products of the updates go, and where those of each column begin.
    pub(crate) targets: Vec<u32>,
    pub(crate) target_begins: Vec<u32>,
    wanted: Vec<(u32, u32)>,
    missing: bool,
    filled: Vec<u32>,
    elimination: Elimination,
}

/// The blocks `entry..end` of the factor, each times the transpose of the first of them, are subtracted from targets.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Update {
    pub(crate) entry: u32,
    pub(crate) end: u32,
}

impl Pattern {
    /// For a step in which these parts (true) take part.
    pub(crate) fn begin(&mut self, present: impl ExactSizeIterator<Item = bool>) {
        self.wanted.clear();
        self.missing = present.len() != self.slots.len();
        self.slots.resize(present.len(), NONE);
        for (slot, present) in self.slots.iter_mut().zip(present) {
            if present != (*slot != NONE) {
                *slot = if present { 0 } else { NONE };
                self.missing = true;
            }
        }
    }

    /// Two parts depend on each other.
    pub(crate) fn tie(&mut self, a: usize, b: usize) {
        if a == b {
            return;
        }
        self.wanted.push((a as u32, b as u32));
        self.missing = self.missing || self.find(self.slots[a], self.slots[b]) == NONE;
    }

    /// All ties are known. True when the order is a new one.
    pub(crate) fn finish(&mut self) -> bool {
        let stale = WANTED * self.wanted.len() + SPARE < (WANTED - 1) * self.columns.len();
        if self.missing || stale {
            self.order();
            self.lay_out_matrix();
            self.lay_out_factor();
            self.lay_out_updates();
            return true;
        }
        false
    }

    /// How many parts take part.
    pub(crate) fn size(&self) -> usize {
        self.size
    }

    /// How many blocks the matrix has.
    pub(crate) fn matrix_blocks(&self) -> usize {
        self.size() + self.columns.len()
    }

    /// How many blocks the factor has.
    pub(crate) fn factor_blocks(&self) -> usize {
        self.size() + self.rows.len()
    }

    /// The slot of a part that takes part.
    pub(crate) fn slot(&self, part: usize) -> u32 {
        self.slots[part]
    }

    /// Where the matrix keeps the block of two slots that are the same or tied.
    pub(crate) fn block(&self, a: u32, b: u32) -> usize {
        if a == b {
            a as usize
        } else {
            self.find(a, b) as usize
        }
    }

    /// Slots of the off-diagonal blocks of the matrix, in the order in which they are kept.
    pub(crate) fn off_diagonal(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.row_begins
            .windows(2)
            .enumerate()
            .flat_map(|(i, ends)| {
                let columns = &self.columns[ends[0] as usize..ends[1] as usize];
                columns.iter().map(move |&j| (i, j as usize))
            })
    }

    fn find(&self, a: u32, b: u32) -> u32 {
        let (row, column) = (a.max(b) as usize, a.min(b));
        let begin = self.row_begins[row];
        let columns = &self.columns[begin as usize..self.row_begins[row + 1] as usize];
        match columns.iter().position(|&c| c == column) {
            Some(place) => self.size as u32 + begin + place as u32,
            None => NONE,
        }
    }

    /// Gives the parts their slots.
    fn order(&mut self) {
        self.size = 0;
        for slot in self.slots.iter_mut().filter(|slot| **slot != NONE) {
            *slot = self.size as u32;
            self.size += 1;
        }
        self.elimination.begin(self.size);
        for &(a, b) in &self.wanted {
            self.elimination
                .tie(self.slots[a as usize], self.slots[b as usize]);
        }
        self.elimination.run(self.size);
        for slot in self.slots.iter_mut().filter(|slot| **slot != NONE) {
            *slot = self.elimination.ranks[*slot as usize];
        }
    }

    fn lay_out_matrix(&mut self) {
        for (a, b) in &mut self.wanted {
            let (i, j) = (self.slots[*a as usize], self.slots[*b as usize]);
            (*a, *b) = (i.max(j), i.min(j));
        }
        self.wanted.sort_unstable();
        self.wanted.dedup();
        self.row_begins.clear();
        self.columns.clear();
        for &(row, column) in &self.wanted {
            while self.row_begins.len() <= row as usize {
                self.row_begins.push(self.columns.len() as u32);
            }
            self.columns.push(column);
        }
        self.row_begins
            .resize(self.size + 1, self.columns.len() as u32);
    }

    fn lay_out_factor(&mut self) {
        self.column_begins.clear();
        self.rows.clear();
        self.sources.clear();
        for k in 0..self.size {
            let begin = self.rows.len();
            self.column_begins.push(begin as u32);
            let Elimination {
                fill,
                begins,
                ranks,
                ..
            } = &self.elimination;
            let neighbors = &fill[begins[k]..begins[k + 1]];
            self.rows
                .extend(neighbors.iter().map(|&other| ranks[other as usize]));
            self.rows[begin..].sort_unstable();
            for at in begin..self.rows.len() {
                let source = self.find(self.rows[at], k as u32);
                self.sources.push(source);
            }
        }
        self.column_begins.push(self.rows.len() as u32);
    }

    fn lay_out_updates(&mut self) {
        // How many there are for each column; then where they begin.
        self.update_begins.clear();
        self.update_begins.resize(self.size + 1, 0);
        for &row in &self.rows {
            self.update_begins[row as usize + 1] += 1;
        }
        for j in 0..self.size {
            self.update_begins[j + 1] += self.update_begins[j];
        }
        self.updates.clear();
        self.updates.resize(self.rows.len(), Update::default());
        self.filled.clone_from(&self.update_begins);
        for ends in self.column_begins.windows(2) {
            for at in ends[0]..ends[1] {
                let place = &mut self.filled[self.rows[at as usize] as usize];
                let base = self.size as u32;
                self.updates[*place as usize] = Update {
                    entry: base + at,
                    end: base + ends[1],
                };
                *place += 1;
            }
        }
        self.targets.clear();
        self.target_begins.clear();
        let base = self.size as u32;
        for j in 0..self.size {
            self.target_begins.push(self.targets.len() as u32);
            let updates = self.update_begins[j] as usize..self.update_begins[j + 1] as usize;
            for update in &self.updates[updates] {
                self.targets.push(j as u32);
                // Both lists ascend, and every row of the update is one of the column's.
                let mut at = self.column_begins[j];
                for entry in update.entry + 1..update.end {
                    while self.rows[at as usize] != self.rows[(entry - base) as usize] {
                        at += 1;
                    }
                    self.targets.push(base + at);
                }
            }
        }
    }
}
