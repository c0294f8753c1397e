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

    /// Copies another matrix of the same order and adds `shift` to the diagonal.
    pub fn copy_shifted(&mut self, other: &Self, shift: f64) {
        self.columns.clone_from(&other.columns);
        for column in &mut self.columns {
            column[0] += shift;
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

    /// Solves with the factorization, in place.
    pub fn solve(&self, x: &mut [f64]) {
        let order = x.len();
        for j in 0..order {
            let xj = x[j];
            let reach = HALF_BANDWIDTH.min(order - 1 - j);
            for (t, &l) in x[j + 1..=j + reach].iter_mut().zip(&self.columns[j][1..]) {
                *t -= l * xj;
            }
        }
        for j in (0..order).rev() {
            let reach = HALF_BANDWIDTH.min(order - 1 - j);
            let dot: f64 = x[j + 1..=j + reach]
                .iter()
                .zip(&self.columns[j][1..])
                .map(|(a, b)| a * b)
                .sum();
            x[j] = x[j] / self.columns[j][0] - dot;
        }
    }
}
