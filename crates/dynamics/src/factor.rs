//! The Cholesky factor of a matrix of blocks, column by column, and solutions with it.
//!
//! A column is what the matrix has there minus the products of the columns before (George and Liu, Computer Solution of Large Sparse
//! Positive Definite Systems, 1981, chapter 5); the pattern says which. A column of a matrix that is what it was, with
//! nothing new in those that it depends on, is kept.

use crate::block::{self, Block, Triple};
use crate::elimination::NONE;
use crate::matrix::Matrix;
use crate::pattern::Pattern;

/// A factor L with A = L L^T.
#[derive(Clone, Debug, Default)]
pub(crate) struct Factor {
    /// As the pattern keeps them.
    blocks: Vec<Block>,
    /// The matrix whose factor it is.
    known: Vec<Block>,
    changed: Vec<bool>,
}

impl Factor {
    /// Forgets what it is; the pattern is another.
    pub(crate) fn reset(&mut self) {
        self.known.clear();
    }

    /// Becomes the factor of a matrix. Gives the number of products of blocks that this took.
    pub(crate) fn update(&mut self, pattern: &Pattern, matrix: &Matrix) -> u64 {
        let size = pattern.size();
        let anew = self.known.len() != matrix.blocks.len();
        self.changed.clear();
        self.changed.resize(size, anew);
        self.known.resize(matrix.blocks.len(), block::ZERO);
        self.blocks.resize(pattern.factor_blocks(), block::ZERO);
        let mut products = 0;
        for j in 0..size {
            let (begin, end) = (pattern.column_begins[j], pattern.column_begins[j + 1]);
            let column = begin as usize..end as usize;
            let sources = &pattern.sources[column.clone()];
            if !self.changed[j] && !self.differs(j, sources, matrix) {
                continue;
            }
            // Everything that depends on a column comes after the first of what does.
            if let Some(&next) = pattern.rows.get(column.start).filter(|_| begin < end) {
                self.changed[next as usize] = true;
            }
            self.load(j, size + column.start, sources, matrix);
            products += self.subtract(pattern, j);
            let below = size + column.start..size + column.end;
            let (diagonals, rest) = self.blocks.split_at_mut(size);
            block::cholesky(&mut diagonals[j]);
            for entry in &mut rest[below.start - size..below.end - size] {
                block::divide(entry, &diagonals[j]);
            }
        }
        products
    }

    fn differs(&self, j: usize, sources: &[u32], matrix: &Matrix) -> bool {
        let changed = |at: usize| self.known[at] != matrix.blocks[at];
        changed(j) || (sources.iter().filter(|s| **s != NONE)).any(|&s| changed(s as usize))
    }

    /// What the matrix has in a column.
    fn load(&mut self, j: usize, begin: usize, sources: &[u32], matrix: &Matrix) {
        self.known[j] = matrix.blocks[j];
        self.blocks[j] = matrix.blocks[j];
        for (entry, &source) in self.blocks[begin..].iter_mut().zip(sources) {
            *entry = block::ZERO;
            if source != NONE {
                *entry = matrix.blocks[source as usize];
                self.known[source as usize] = *entry;
            }
        }
    }

    /// Subtracts what the columns before have to do with a column.
    fn subtract(&mut self, pattern: &Pattern, j: usize) -> u64 {
        let updates = pattern.update_begins[j] as usize..pattern.update_begins[j + 1] as usize;
        let begin = pattern.target_begins[j] as usize;
        let mut targets = pattern.targets[begin..].iter();
        let mut products = 0;
        for update in &pattern.updates[updates] {
            let entries = update.entry as usize..update.end as usize;
            products += entries.len() as u64;
            let first = self.blocks[entries.start];
            for (entry, &target) in entries.zip(targets.by_ref()) {
                let from = self.blocks[entry];
                block::subtract_product(&mut self.blocks[target as usize], &from, &first);
            }
        }
        products
    }

    /// Solves A x = b in place.
    pub(crate) fn solve(&self, pattern: &Pattern, x: &mut [Triple]) {
        let size = pattern.size();
        let (diagonals, below) = self.blocks.split_at(size);
        let column =
            |j: usize| pattern.column_begins[j] as usize..pattern.column_begins[j + 1] as usize;
        for j in 0..size {
            let mut own = x[j];
            block::solve_lower(&diagonals[j], &mut own);
            x[j] = own;
            for (entry, &row) in below[column(j)].iter().zip(&pattern.rows[column(j)]) {
                block::multiply_subtract(entry, &own, &mut x[row as usize]);
            }
        }
        for j in (0..size).rev() {
            let mut own = x[j];
            for (entry, &row) in below[column(j)].iter().zip(&pattern.rows[column(j)]) {
                let part = block::transposed_times(entry, &x[row as usize]);
                for (o, value) in own.iter_mut().zip(part) {
                    *o -= value;
                }
            }
            block::solve_upper(&diagonals[j], &mut own);
            x[j] = own;
        }
    }
}
