//! Symmetric positive definite systems with two bands beside the diagonal: elastic bands with bending stiffness.

/// The matrix: `diagonal[i]`, `first[i]` at (i, i + 1), `second[i]` at (i, i + 2).
#[derive(Clone, Debug, Default)]
pub(crate) struct Pentadiagonal {
    pub diagonal: Vec<f64>,
    pub first: Vec<f64>,
    pub second: Vec<f64>,
}

impl Pentadiagonal {
    pub fn zeros(n: usize) -> Self {
        Self {
            diagonal: vec![0.0; n],
            first: vec![0.0; n],
            second: vec![0.0; n],
        }
    }

    /// Adds `weight (sum_k c_k x_(i+k))^2 / 2`'s Hessian for up to three consecutive unknowns.
    pub fn add(&mut self, i: usize, c: [f64; 3], weight: f64) {
        for k in 0..3 {
            if i + k >= self.diagonal.len() {
                continue;
            }
            self.diagonal[i + k] += weight * c[k] * c[k];
            if k + 1 < 3 && i + k + 1 < self.diagonal.len() {
                self.first[i + k] += weight * c[k] * c[k + 1];
            }
        }
        if i + 2 < self.diagonal.len() {
            self.second[i] += weight * c[0] * c[2];
        }
    }

    /// Factorizes in place as L D L^T.
    pub fn factorize(mut self) -> Factor {
        let n = self.diagonal.len();
        for i in 0..n {
            if i >= 1 {
                // first holds L's first band scaled by D until here.
                let l1 = self.first[i - 1];
                let d1 = self.diagonal[i - 1];
                self.diagonal[i] -= l1 * l1 / d1;
                self.first[i] -= l1 / d1 * self.second[i - 1];
            }
            if i >= 2 {
                let l2 = self.second[i - 2];
                self.diagonal[i] -= l2 * l2 / self.diagonal[i - 2];
            }
        }
        Factor(self)
    }
}

/// L D L^T of a [`Pentadiagonal`], bands scaled by D.
pub(crate) struct Factor(Pentadiagonal);

impl Factor {
    /// Solves in place.
    pub fn solve(&self, b: &mut [f64]) {
        let Pentadiagonal {
            diagonal: d,
            first,
            second,
        } = &self.0;
        let n = b.len();
        for i in 0..n {
            if i >= 1 {
                b[i] -= first[i - 1] / d[i - 1] * b[i - 1];
            }
            if i >= 2 {
                b[i] -= second[i - 2] / d[i - 2] * b[i - 2];
            }
        }
        for i in (0..n).rev() {
            let mut v = b[i];
            if i + 1 < n {
                v -= first[i] * b[i + 1];
            }
            if i + 2 < n {
                v -= second[i] * b[i + 2];
            }
            b[i] = v / d[i];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_a_band_matrix() {
        let n = 9;
        let mut m = Pentadiagonal::zeros(n);
        for i in 0..n {
            m.add(i, [1.0, 0.0, 0.0], 0.5 + 0.1 * i as f64);
        }
        for i in 0..n - 2 {
            m.add(i, [1.0, -2.0, 1.0], 3.0 + i as f64);
        }
        for i in 0..n - 1 {
            m.add(i, [-1.0, 1.0, 0.0], 2.0);
        }
        let x: Vec<f64> = (0..n).map(|i| libm::sin(i as f64 * 1.7)).collect();
        let mut b: Vec<f64> = (0..n)
            .map(|i| {
                let mut v = m.diagonal[i] * x[i];
                for (k, band) in [(1, &m.first), (2, &m.second)] {
                    if i + k < n {
                        v += band[i] * x[i + k];
                    }
                    if i >= k {
                        v += band[i - k] * x[i - k];
                    }
                }
                v
            })
            .collect();
        m.clone().factorize().solve(&mut b);
        for (a, b) in x.iter().zip(&b) {
            assert!((a - b).abs() < 1e-12);
        }
    }
}
