/// A cubic polynomial c0 + c1 w + c2 w^2 + c3 w^3.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Cubic(pub [f64; 4]);

impl Cubic {
    /// The value at w.
    pub fn at(&self, w: f64) -> f64 {
        let [c0, c1, c2, c3] = self.0;
        c0 + w * (c1 + w * (c2 + w * c3))
    }

    /// The derivative by w.
    pub fn slope(&self) -> Self {
        let [_, c1, c2, c3] = self.0;
        Self([c1, 2.0 * c2, 3.0 * c3, 0.0])
    }

    /// The integral from 0 to w.
    pub fn integral(&self, w: f64) -> f64 {
        let [c0, c1, c2, c3] = self.0;
        w * (c0 + w * (c1 / 2.0 + w * (c2 / 3.0 + w * c3 / 4.0)))
    }

    /// Least and greatest value on [a, b]: at its ends, or where the derivative vanishes. An error of such a place counts
    /// only squared, so the values are right to rounding.
    pub fn range(&self, [a, b]: [f64; 2]) -> [f64; 2] {
        let [c, half_b, a2, _] = self.slope().0;
        let half_b = 0.5 * half_b;
        // The stable pair of roots of a2 w^2 + 2 half_b w + c.
        let q = -(half_b + half_b.signum() * (half_b * half_b - a2 * c).max(0.0).sqrt());
        let (from, to) = (self.at(a), self.at(b));
        [q / a2, c / q]
            .into_iter()
            .filter(|w| *w > a && *w < b)
            .map(|w| self.at(w))
            .fold([from.min(to), from.max(to)], |[low, high], value| {
                [low.min(value), high.max(value)]
            })
    }

    /// The greatest magnitude on [a, b].
    pub fn magnitude(&self, stretch: [f64; 2]) -> f64 {
        let [low, high] = self.range(stretch);
        high.max(-low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_range_is_that_of_ten_thousand_samples() {
        let polynomials = [
            [0.3, -1.0, 2.0, -0.7],
            [0.0, 1.0, -1.0, 0.0],
            [1.0, 0.0, 0.0, 4.0],
            [0.2, -3.0, 0.0, 4.0],
            [-0.2, 0.5, 0.0, 0.0],
            [0.5, 0.0, 0.0, 0.0],
            [1.0, -6.0, 12.0, -8.0],
            [0.05, 1e-9, -1e-9, 1e-17],
        ];
        for c in polynomials {
            for stretch in [[0.0, 1.0], [0.0, 0.5], [0.25, 0.75], [0.9, 1.0]] {
                let [a, b] = stretch;
                let values = (0..=10_000).map(|k| Cubic(c).at(a + (b - a) * f64::from(k) * 1e-4));
                let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
                for v in values {
                    (low, high) = (low.min(v), high.max(v));
                }
                let [least, greatest] = Cubic(c).range(stretch);
                assert!(
                    least <= low + 1e-15 && low - least < 1e-7,
                    "{c:?} {stretch:?}"
                );
                assert!(
                    greatest >= high - 1e-15 && greatest - high < 1e-7,
                    "{c:?} {stretch:?}"
                );
            }
        }
    }
}
