//! Ticks of an axis and lengths that people like to read.

use crate::svg::Rounded;

/// The exponent of the greatest power of ten that is not above a value; 0 when the value is not positive and finite.
pub(crate) fn decade(value: f64) -> i32 {
    if !(value.is_finite() && value > 0.0) {
        return 0;
    }
    let mut exponent = 0;
    while power_of_ten(exponent + 1) <= value {
        exponent += 1;
    }
    while power_of_ten(exponent) > value {
        exponent -= 1;
    }
    exponent
}

/// 10 to an integer.
pub(crate) fn power_of_ten(exponent: i32) -> f64 {
    let power = (0..exponent.abs()).fold(1.0, |p, _| 10.0 * p);
    if exponent < 0 { 1.0 / power } else { power }
}

/// The largest of 1, 2, 5 times a power of ten that is not above `bound` (positive and finite).
pub(crate) fn nice_below(bound: f64) -> f64 {
    let power = power_of_ten(decade(bound));
    // 1e-9: a bound that is a nice number but for rounding is taken itself.
    [10.0, 5.0, 2.0]
        .iter()
        .map(|k| k * power)
        .find(|v| *v <= bound * (1.0 + 1e-9))
        .unwrap_or(power)
}

/// Ticks of an axis: round values and their labels.
#[derive(Debug)]
pub(crate) struct Ticks {
    /// Where the ticks are, increasing.
    pub values: Vec<f64>,
    decimals: usize,
}

impl Ticks {
    /// Ticks at round values within `[min, max]`, at most `most` intervals of them (one at least).
    pub fn new(min: f64, max: f64, most: usize) -> Self {
        let span = max - min;
        if !(span.is_finite() && span > 0.0) {
            return Self {
                values: Vec::new(),
                decimals: 0,
            };
        }
        let least = span / most.max(1) as f64;
        let mut step = nice_below(least);
        while step < least * (1.0 - 1e-9) {
            // 1 -> 2 -> 5 -> 10, whichever comes next.
            step = nice_below(step * 2.5);
        }
        let first = (min / step - 1e-9).ceil();
        let count = ((max / step + 1e-9).floor() - first).max(0.0) as usize + 1;
        Self {
            values: (0..count).map(|i| (first + i as f64) * step).collect(),
            decimals: usize::try_from(-decade(step * (1.0 + 1e-9))).unwrap_or(0),
        }
    }

    /// The label of a tick, with as many decimals as the step needs.
    pub fn label(&self, value: f64) -> String {
        let text = format!("{value:.*}", self.decimals);
        let is_zero = text.trim_matches(['-', '0', '.']).is_empty();
        match is_zero {
            true => Rounded(0.0, 0).to_string(),
            false => text.replace('-', "\u{2212}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        for (min, max, most) in [
            (0.0, 15.0, 10),
            (-0.5, 9.5, 7),
            (3.2, 3.9, 5),
            (0.0, 1e4, 8),
        ] {
            let ticks = Ticks::new(min, max, most);
            assert!(ticks.values.len() >= 2 && ticks.values.len() <= most + 1);
            let step = ticks.values[1] - ticks.values[0];
            let mantissa = step / libm::exp10(libm::log10(step).floor());
            assert!(
                [1.0, 2.0, 5.0, 10.0]
                    .iter()
                    .any(|m| (mantissa - m).abs() < 1e-6),
                "{step}"
            );
            for v in &ticks.values {
                assert!(*v >= min - 1e-9 && *v <= max + 1e-9);
            }
            // No room for another tick on either side.
            assert!(
                ticks.values[0] - step < min && ticks.values[ticks.values.len() - 1] + step > max
            );
        }
    }

    #[test]
    fn decades_are_exact() {
        for (value, exponent) in [
            (1.0, 0),
            (0.24, -1),
            (1000.0, 3),
            (999.9, 2),
            (1e-3, -3),
            (5e-6, -6),
        ] {
            assert_eq!(decade(value), exponent, "{value}");
        }
        assert_eq!(decade(0.0), 0);
        assert_eq!(decade(f64::NAN), 0);
        assert_eq!(power_of_ten(-4), 1e-4);
    }

    #[test]
    fn labels_have_the_decimals_of_the_step() {
        let ticks = Ticks::new(-0.5, 0.5, 4);
        let labels: Vec<_> = ticks.values.iter().map(|v| ticks.label(*v)).collect();
        assert_eq!(labels, ["\u{2212}0.5", "0", "0.5"]);
        assert_eq!(Ticks::new(0.0, 3000.0, 3).label(1000.0), "1000");
    }

    #[test]
    fn an_empty_or_endless_range_has_no_ticks() {
        assert!(Ticks::new(1.0, 1.0, 5).values.is_empty());
        assert!(Ticks::new(0.0, f64::INFINITY, 5).values.is_empty());
        assert!(Ticks::new(f64::NAN, 1.0, 5).values.is_empty());
    }
}
