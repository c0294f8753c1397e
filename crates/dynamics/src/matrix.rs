//! Symmetric matrices of blocks on a pattern.

use crate::block::{self, Block, Triple};
use crate::pattern::Pattern;

/// The blocks of the lower triangle: those of the diagonal (whole), then the others, as the pattern keeps them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Matrix {
    pub(crate) blocks: Vec<Block>,
}

impl Matrix {
    /// Zero, on this pattern.
    pub(crate) fn reset(&mut self, pattern: &Pattern) {
        self.blocks.clear();
        self.blocks.resize(pattern.matrix_blocks(), block::ZERO);
    }

    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.blocks.clone_from(&other.blocks);
    }

    /// The diagonal entries of a slot.
    pub(crate) fn diagonal(&self, slot: u32) -> Triple {
        let block = &self.blocks[slot as usize];
        [block[0][0], block[1][1], block[2][2]]
    }

    /// `out = A x`.
    pub(crate) fn multiply(&self, pattern: &Pattern, x: &[Triple], out: &mut [Triple]) {
        for ((o, x), block) in out.iter_mut().zip(x).zip(&self.blocks) {
            *o = [0.0; 3];
            block::multiply_add(block, x, o);
        }
        for ((i, j), block) in pattern.off_diagonal().zip(&self.blocks[x.len()..]) {
            block::multiply_add(block, &x[j], &mut out[i]);
            let mirrored = block::transposed_times(block, &x[i]);
            for (o, value) in out[j].iter_mut().zip(mirrored) {
                *o += value;
            }
        }
    }
}
