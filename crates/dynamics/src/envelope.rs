//! Symmetric positive definite matrices that are zero outside of an envelope, their factors and solutions.
//!
//! Row i of the lower triangle is stored from its first column that can be nonzero to the diagonal. The factors A = L D L^T have
//! the same envelope (Jennings, Computer Journal 9, 1966; George and Liu, Computer Solution of Large Sparse Positive
//! Definite Systems, 1981, chapter 4). For a chain the envelope is a narrow band; objects in contact widen it where they lie.

/// A symmetric matrix within an envelope, or its factor L with the inverse of D on the diagonal.
#[derive(Clone, Debug, Default)]
pub(crate) struct Envelope {
    /// First stored column of each row.
    first: Vec<usize>,
    /// Where each row begins in `values`: entry (i, j) is at `begin[i] + j - first[i]`.
    begin: Vec<usize>,
    values: Vec<f64>,
}

impl Envelope {
    /// A zero matrix with these first columns.
    pub(crate) fn reset(&mut self, first: &[usize]) {
        self.first.clear();
        self.first.extend_from_slice(first);
        self.begin.clear();
        let mut total = 0;
        for (i, f) in first.iter().enumerate() {
            self.begin.push(total);
            total += i - f + 1;
        }
        self.values.clear();
        self.values.resize(total, 0.0);
    }

    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.first.clone_from(&other.first);
        self.begin.clone_from(&other.begin);
        self.values.clone_from(&other.values);
    }

    pub(crate) fn size(&self) -> usize {
        self.first.len()
    }

    /// The entry (i, i).
    pub(crate) fn diagonal(&self, i: usize) -> f64 {
        self.values[self.begin[i] + i - self.first[i]]
    }

    /// Adds to the entry (i, j) and its mirror image.
    pub(crate) fn add(&mut self, i: usize, j: usize, value: f64) {
        let (i, j) = if i >= j { (i, j) } else { (j, i) };
        self.values[self.begin[i] + j - self.first[i]] += value;
    }

    /// `out = A x`.
    pub(crate) fn multiply(&self, x: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for i in 0..self.size() {
            let (f, b) = (self.first[i], self.begin[i]);
            let row = &self.values[b..b + i - f];
            let xi = x[i];
            let mut sum = self.values[b + i - f] * xi;
            for ((value, xj), oj) in row.iter().zip(&x[f..i]).zip(&mut out[f..i]) {
                sum += value * xj;
                *oj += value * xi;
            }
            out[i] += sum;
        }
    }

    /// Replaces the matrix by its factors.
    pub(crate) fn factor(&mut self) {
        for i in 0..self.size() {
            let (fi, bi) = (self.first[i], self.begin[i]);
            let (before, rest) = self.values.split_at_mut(bi);
            let row = &mut rest[..=i - fi];
            for j in fi..i {
                let fj = self.first[j];
                let low = fi.max(fj);
                let bj = self.begin[j];
                let other = &before[bj + low - fj..bj + j - fj];
                row[j - fi] -= dot(&row[low - fi..j - fi], other);
            }
            let mut diagonal = row[i - fi];
            for j in fi..i {
                let pivot = before[self.begin[j] + j - self.first[j]];
                let value = row[j - fi];
                let scaled = value * pivot;
                diagonal -= value * scaled;
                row[j - fi] = scaled;
            }
            // The inverse is kept. Positive but for rounding: every term adds a positive semidefinite part to a mass.
            row[i - fi] = 1.0 / diagonal.max(1e-12);
        }
    }

    /// Solves with the factors, in place.
    pub(crate) fn solve(&self, x: &mut [f64]) {
        for i in 0..self.size() {
            let (f, b) = (self.first[i], self.begin[i]);
            x[i] -= dot(&self.values[b..b + i - f], &x[f..i]);
        }
        for (i, value) in x.iter_mut().enumerate() {
            *value *= self.diagonal(i);
        }
        for i in (0..self.size()).rev() {
            let (f, b) = (self.first[i], self.begin[i]);
            let xi = x[i];
            for (value, xj) in self.values[b..b + i - f].iter().zip(&mut x[f..i]) {
                *xj -= value * xi;
            }
        }
    }
}

/// Scalar product in four sums, in an order that does not depend on the machine.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a4, a_rest) = a.as_chunks::<4>();
    let (b4, b_rest) = b.as_chunks::<4>();
    let mut sums = [0.0; 4];
    for (x, y) in a4.iter().zip(b4) {
        for k in 0..4 {
            sums[k] += x[k] * y[k];
        }
    }
    let mut rest = 0.0;
    for (x, y) in a_rest.iter().zip(b_rest) {
        rest += x * y;
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_banded_system_is_solved() {
        let size = 12;
        let first: Vec<usize> = (0..size)
            .map(|i: usize| i.saturating_sub(1 + i % 5))
            .collect();
        let mut matrix = Envelope::default();
        matrix.reset(&first);
        for (i, &begin) in first.iter().enumerate() {
            for j in begin..i {
                matrix.add(j, i, 0.3 + 0.1 * ((i * 7 + j * 3) % 5) as f64);
            }
            matrix.add(i, i, 8.0 + i as f64);
        }
        let exact: Vec<f64> = (0..size).map(|i| i as f64 - 4.5).collect();
        let mut x = vec![0.0; size];
        matrix.multiply(&exact, &mut x);
        matrix.factor();
        matrix.solve(&mut x);
        for (a, b) in x.iter().zip(&exact) {
            assert!((a - b).abs() < 1e-12, "{x:?}");
        }
    }
}
