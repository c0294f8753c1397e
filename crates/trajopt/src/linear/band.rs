use std::ops::Range;

/// Scalar half-bandwidth: six pose variables a stage, second differences couple like coordinates two stages apart.
pub const HALF_BANDWIDTH: usize = 12;
const COLUMN: usize = HALF_BANDWIDTH + 1;

/// A symmetric matrix of half-bandwidth 12, its lower triangle by columns; factorized in place as `L D L^T`.
#[derive(Clone, Debug, Default)]
pub struct BandMatrix {
    /// `columns[j][k]` is entry `(j + k, j)`.
    columns: Vec<[f64; COLUMN]>,
}

impl BandMatrix {
    /// Sets the order and zeroes every entry; allocates only when the order grows.
    pub fn reset(&mut self, order: usize) {
        self.columns.clear();
        self.columns.resize(order, [0.0; COLUMN]);
    }

    /// Adds to entry `(row, column)` with `row >= column` and `row - column <= 12`.
    #[inline]
    pub fn add_lower(&mut self, row: usize, column: usize, value: f64) {
        debug_assert!(row >= column && row - column <= HALF_BANDWIDTH);
        self.columns[column][row - column] += value;
    }

    /// Entry `(row, column)` of either triangle, before factorization.
    #[cfg(test)]
    pub fn entry(&self, row: usize, column: usize) -> f64 {
        let (low, high) = (row.min(column), row.max(column));
        if high - low > HALF_BANDWIDTH {
            0.0
        } else {
            self.columns[low][high - low]
        }
    }

    /// Copies the diagonal block of another matrix that a range of its columns makes, and adds `shift` to the diagonal.
    pub fn copy_block(&mut self, other: &Self, block: Range<usize>, shift: f64) {
        self.columns.clear();
        self.columns.extend_from_slice(&other.columns[block]);
        for column in &mut self.columns {
            column[0] += shift;
        }
    }

    /// Subtracts from a right-hand side of a diagonal block what the variables outside of it, which stay at `x`, contribute.
    pub fn subtract_outside(&self, block: Range<usize>, x: &[f64], rhs: &mut [f64]) {
        let before = block.start.saturating_sub(HALF_BANDWIDTH)..block.start;
        for c in before {
            let reach = block.end.min(c + COLUMN);
            for r in block.start..reach {
                rhs[r - block.start] -= self.columns[c][r - c] * x[c];
            }
        }
        let last = block.end.saturating_sub(HALF_BANDWIDTH).max(block.start)..block.end;
        for c in last {
            let entries = &self.columns[c][block.end - c..];
            for (entry, x) in entries.iter().zip(&x[block.end..]) {
                rhs[c - block.start] -= entry * x;
            }
        }
    }

    /// Factorizes in place as `L D L^T`. `Err(j)`: pivot `j` is not above `tiny`, the matrix is not positive definite.
    pub fn factorize(&mut self, tiny: f64) -> Result<(), usize> {
        let order = self.columns.len();
        for j in 0..order {
            let (head, tail) = self.columns.split_at_mut(j + 1);
            let column = &mut head[j];
            let pivot = column[0];
            if pivot.is_nan() || pivot <= tiny {
                return Err(j);
            }
            let inverse = 1.0 / pivot;
            let mut scaled = [0.0; COLUMN];
            for k in 1..COLUMN {
                scaled[k] = column[k] * inverse;
            }
            for (k, target) in tail.iter_mut().take(HALF_BANDWIDTH).enumerate() {
                let factor = scaled[k + 1];
                if factor != 0.0 {
                    for (t, &c) in target.iter_mut().zip(&column[k + 1..]) {
                        *t -= factor * c;
                    }
                }
            }
            column[1..].copy_from_slice(&scaled[1..]);
        }
        Ok(())
    }

    /// Solves with the factorization for several right-hand sides at once, in place: one waits for no division or sum of
    /// another.
    pub fn solve<const K: usize>(&self, mut x: [&mut [f64]; K]) {
        let order = self.columns.len();
        // Columns of which all entries lie within the matrix.
        let whole = order.saturating_sub(HALF_BANDWIDTH);
        for (j, column) in self.columns.iter().enumerate() {
            let below = &column[1..];
            for x in &mut x {
                let xj = x[j];
                if j < whole {
                    for (t, &l) in x[j + 1..][..HALF_BANDWIDTH].iter_mut().zip(below) {
                        *t -= l * xj;
                    }
                } else {
                    for (t, &l) in x[j + 1..].iter_mut().zip(below) {
                        *t -= l * xj;
                    }
                }
            }
        }
        for (j, column) in self.columns.iter().enumerate().rev() {
            let inverse = 1.0 / column[0];
            for x in &mut x {
                let dot = if j < whole {
                    dot_of_band(&x[j + 1..][..HALF_BANDWIDTH], &column[1..])
                } else {
                    x[j + 1..]
                        .iter()
                        .zip(&column[1..])
                        .map(|(a, b)| a * b)
                        .sum()
                };
                x[j] = x[j] * inverse - dot;
            }
        }
    }
}

/// Scalar product of twelve entries in four sums side by side, those that were found last added last.
#[inline]
fn dot_of_band(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    for k in (0..HALF_BANDWIDTH).step_by(4).rev() {
        for (m, sum) in sums.iter_mut().enumerate() {
            *sum += a[k + m] * b[k + m];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}
