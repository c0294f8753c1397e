use std::ops::Range;

/// Scalar half-bandwidth: six pose variables a stage, second differences couple like coordinates two stages apart.
pub const HALF_BANDWIDTH: usize = 12;
const COLUMN: usize = HALF_BANDWIDTH + 1;

/// The entries of a column from the diagonal down.
type Column = [f64; COLUMN];

/// A symmetric matrix of half-bandwidth 12, its lower triangle by columns; factorized in place as `L D L^T`.
#[derive(Clone, Debug, Default)]
pub struct BandMatrix {
    /// `columns[j][k]` is entry `(j + k, j)`.
    columns: Vec<Column>,
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
    ///
    /// Two columns at a time while both have all of their entries: what they subtract from the columns behind them goes
    /// through the registers once, in the same order as one by one.
    pub fn factorize(&mut self, tiny: f64) -> Result<(), usize> {
        let order = self.columns.len();
        let mut j = 0;
        while let Some(([a, b], behind)) = split_pair(&mut self.columns[j..]) {
            let first = scale(a, tiny).ok_or(j)?;
            subtract(b, &first, a, 1);
            let second = scale(b, tiny).ok_or(j + 1)?;
            subtract_pair(behind, (&first, a), (&second, b));
            (*a, *b) = (first, second);
            j += 2;
        }
        while j < order {
            let (head, tail) = self.columns.split_at_mut(j + 1);
            let column = &mut head[j];
            let scaled = scale(column, tiny).ok_or(j)?;
            for (k, target) in (1..).zip(tail.iter_mut().take(HALF_BANDWIDTH)) {
                subtract(target, &scaled, column, k);
            }
            *column = scaled;
            j += 1;
        }
        Ok(())
    }

    /// Solves with the factorization for several right-hand sides at once, in place: one waits for no division or sum of
    /// another.
    pub fn solve<const K: usize>(&self, mut x: [&mut [f64]; K]) {
        // Columns of which all entries lie within the matrix, and the others.
        let whole = self.columns.len().saturating_sub(HALF_BANDWIDTH);
        let (wholes, rest) = self.columns.split_at(whole);
        for (j, column) in wholes.iter().enumerate() {
            for x in &mut x {
                if let Some(x) = x[j..].first_chunk_mut::<COLUMN>() {
                    eliminate(x, column);
                }
            }
        }
        for (j, column) in (whole..self.columns.len()).zip(rest) {
            for x in &mut x {
                let xj = x[j];
                for (t, &l) in x[j + 1..].iter_mut().zip(&column[1..]) {
                    *t -= l * xj;
                }
            }
        }
        for (j, column) in (whole..self.columns.len()).zip(rest).rev() {
            let inverse = 1.0 / column[0];
            for x in &mut x {
                let products = x[j + 1..].iter().zip(&column[1..]).map(|(a, b)| a * b);
                let dot: f64 = products.sum();
                x[j] = x[j] * inverse - dot;
            }
        }
        for (j, column) in wholes.iter().enumerate().rev() {
            let inverse = 1.0 / column[0];
            for x in &mut x {
                if let Some(x) = x[j..].first_chunk_mut::<COLUMN>() {
                    x[0] = x[0] * inverse - dot_of_band(x, column);
                }
            }
        }
    }
}

/// The first two columns, and the twelve behind them, all of whose entries lie within the matrix.
fn split_pair(columns: &mut [Column]) -> Option<([&mut Column; 2], &mut [Column; HALF_BANDWIDTH])> {
    let (pair, behind) = columns.split_first_chunk_mut::<2>()?;
    let behind = behind.first_chunk_mut::<HALF_BANDWIDTH>()?;
    Some((pair.each_mut(), behind))
}

/// A column divided by its pivot, which stays. `None` when that is not above `tiny`.
#[inline]
fn scale(column: &Column, tiny: f64) -> Option<Column> {
    let pivot = column[0];
    if pivot.is_nan() || pivot <= tiny {
        return None;
    }
    let inverse = 1.0 / pivot;
    let mut scaled = column.map(|entry| entry * inverse);
    scaled[0] = pivot;
    Some(scaled)
}

/// What a column takes off the `k`th one behind it.
#[inline]
fn subtract(target: &mut Column, scaled: &Column, column: &Column, k: usize) {
    for (t, &c) in target.iter_mut().zip(&column[k..]) {
        *t -= scaled[k] * c;
    }
}

/// What two neighboring columns, each with its scaled self, take off the twelve behind them.
#[inline]
fn subtract_pair(
    behind: &mut [Column; HALF_BANDWIDTH],
    (first, a): (&Column, &Column),
    (second, b): (&Column, &Column),
) {
    /// Column `K` behind the second one, of which the length of all loops is known.
    #[inline(always)]
    fn one<const K: usize>(
        t: &mut Column,
        (first, a): (&Column, &Column),
        (second, b): (&Column, &Column),
    ) {
        let (f, s) = (first[K + 1], second[K]);
        for m in 0..COLUMN - 1 - K {
            t[m] = (t[m] - f * a[K + 1 + m]) - s * b[K + m];
        }
        t[COLUMN - 1 - K] -= s * b[COLUMN - 1];
    }
    let [t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12] = behind;
    let (a, b) = ((first, a), (second, b));
    one::<1>(t1, a, b);
    one::<2>(t2, a, b);
    one::<3>(t3, a, b);
    one::<4>(t4, a, b);
    one::<5>(t5, a, b);
    one::<6>(t6, a, b);
    one::<7>(t7, a, b);
    one::<8>(t8, a, b);
    one::<9>(t9, a, b);
    one::<10>(t10, a, b);
    one::<11>(t11, a, b);
    // The first of the two does not reach that far.
    t12[0] -= second[HALF_BANDWIDTH] * b.1[HALF_BANDWIDTH];
}

/// Takes what the first of thirteen entries of a right-hand side contributes off the others.
#[inline]
fn eliminate(x: &mut Column, column: &Column) {
    let ([first, below @ ..], [_, column @ ..]) = (x, column);
    let products = column.map(|entry| entry * *first);
    for (x, product) in below.iter_mut().zip(products) {
        *x -= product;
    }
}

/// Scalar product of the twelve entries below the diagonal in four sums side by side, those that were found last added last.
#[inline]
fn dot_of_band(a: &Column, b: &Column) -> f64 {
    let mut sums = [0.0; 4];
    for k in (1..COLUMN).step_by(4).rev() {
        for (m, sum) in sums.iter_mut().enumerate() {
            *sum += a[k + m] * b[k + m];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}
