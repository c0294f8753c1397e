//! The one derivative check: gradient and Hessian of a jet against differences of values alone, and the slope against the jet.

use crate::term::{Jet, Term};

/// A derivative found from values, and how far it may be off.
#[derive(Clone, Copy, Debug)]
pub struct Estimate {
    pub value: f64,
    pub error: f64,
}

/// Extrapolates a difference quotient whose error is even in `h` to `h = 0` (Ridders, Adv. Eng. Software 4, 1982).
pub fn extrapolated(quotient: impl Fn(f64) -> f64, widest: f64) -> Estimate {
    const LEVELS: usize = 8;
    const SHRINK: f64 = 1.6;
    let mut best = Estimate {
        value: f64::NAN,
        error: f64::INFINITY,
    };
    let mut previous = [0.0; LEVELS];
    let mut h = widest;
    for level in 0..LEVELS {
        let mut row = [quotient(h); LEVELS];
        let mut factor = SHRINK * SHRINK;
        for k in 1..=level {
            row[k] = (factor * row[k - 1] - previous[k - 1]) / (factor - 1.0);
            factor *= SHRINK * SHRINK;
            let error = (row[k] - row[k - 1])
                .abs()
                .max((row[k] - previous[k - 1]).abs());
            if error < best.error {
                best = Estimate {
                    value: row[k],
                    error,
                };
            }
        }
        previous = row;
        h /= SHRINK;
    }
    best
}

/// First derivative at zero of a function of one variable.
pub fn slope(f: impl Fn(f64) -> f64, widest: f64) -> Estimate {
    extrapolated(|h| (f(h) - f(-h)) / (2.0 * h), widest)
}

/// What a check found.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// Differences do not settle: the function bends sharply within reach.
    Rough,
    /// A derivative is not that of the value.
    Wrong(String),
}

/// False for what is not a number.
fn within(error: f64, bound: f64) -> bool {
    error.abs() <= bound
}

fn moved<const K: usize>(z: &[f64; K], changes: &[(usize, f64)]) -> [f64; K] {
    let mut moved = *z;
    for &(i, change) in changes {
        moved[i] += change;
    }
    moved
}

/// Checks value, gradient, Hessian and its symmetry, and that the slope says the same, at a point, from values at most about `reach` away.
pub fn check<const K: usize>(term: &dyn Term<K>, z: &[f64; K], reach: f64) -> Result<(), Fault> {
    let jet = term.jet(z);
    let value = term.value(z);
    if !within(jet.value - value, 1e-12 * (1.0 + value.abs())) {
        return Err(Fault::Wrong(format!("value {} for {value}", jet.value)));
    }
    let largest = |m: f64, v: &f64| m.max(v.abs());
    let steepest = 1.0 + jet.gradient.iter().fold(0.0, largest);
    let (value_of_slope, gradient_of_slope) = term.slope(z);
    if !within(value_of_slope - value, 1e-12 * (1.0 + value.abs())) {
        let message = format!("slope: value {value_of_slope} for {value} at {z:?}");
        return Err(Fault::Wrong(message));
    }
    for (i, (given, expected)) in gradient_of_slope.iter().zip(&jet.gradient).enumerate() {
        if !within(given - expected, 1e-12 * steepest) {
            let message = format!("slope: gradient[{i}] {given} for {expected} at {z:?}");
            return Err(Fault::Wrong(message));
        }
    }
    let sharpest = 1.0 + jet.hessian.iter().flatten().fold(0.0, largest);
    let compare = |what: &str, given: f64, found: Estimate, scale: f64| {
        if !within(found.error, 1e-5 * scale) {
            return Err(Fault::Rough);
        }
        if !within(given - found.value, 1e-6 * scale + 3.0 * found.error) {
            let message = format!("{what}: {given}, by differences {found:?}, at {z:?}");
            return Err(Fault::Wrong(message));
        }
        Ok(())
    };
    let at = |changes: &[(usize, f64)]| term.value(&moved(z, changes));
    for i in 0..K {
        let found = slope(|h| at(&[(i, h)]), reach);
        compare(&format!("gradient[{i}]"), jet.gradient[i], found, steepest)?;
        let bend = |h: f64| (at(&[(i, h)]) - 2.0 * value + at(&[(i, -h)])) / (h * h);
        let found = extrapolated(bend, reach);
        compare(
            &format!("hessian[{i}][{i}]"),
            jet.hessian[i][i],
            found,
            sharpest,
        )?;
        for j in 0..i {
            let mixed = |h: f64| {
                let corner = |a: f64, b: f64| at(&[(i, a * h), (j, b * h)]);
                (corner(1.0, 1.0) - corner(1.0, -1.0) - corner(-1.0, 1.0) + corner(-1.0, -1.0))
                    / (4.0 * h * h)
            };
            let found = extrapolated(mixed, reach);
            compare(
                &format!("hessian[{i}][{j}]"),
                jet.hessian[i][j],
                found,
                sharpest,
            )?;
            let skew = jet.hessian[i][j] - jet.hessian[j][i];
            if !within(skew, 1e-13 * sharpest) {
                return Err(Fault::Wrong(format!(
                    "hessian not symmetric at {i}, {j}: {skew}"
                )));
            }
        }
    }
    Ok(())
}

/// Value and gradient, as `Term::slope` has them.
type Slope<const K: usize> = (f64, [f64; K]);

/// A term with errors planted into its jet and its slope.
struct Planted<'a, const K: usize> {
    term: &'a dyn Term<K>,
    in_jet: &'a dyn Fn(&mut Jet<K>),
    in_slope: &'a dyn Fn(&mut Slope<K>),
}

impl<const K: usize> Term<K> for Planted<'_, K> {
    fn value(&self, z: &[f64; K]) -> f64 {
        self.term.value(z)
    }

    fn slope(&self, z: &[f64; K]) -> Slope<K> {
        let mut slope = self.term.slope(z);
        (self.in_slope)(&mut slope);
        slope
    }

    fn jet(&self, z: &[f64; K]) -> Jet<K> {
        let mut jet = self.term.jet(z);
        (self.in_jet)(&mut jet);
        jet
    }
}

/// The check passes at a point, and fails there for each of many planted errors.
pub fn assert_checked<const K: usize>(term: &dyn Term<K>, z: &[f64; K], reach: f64) {
    assert_eq!(check(term, z, reach), Ok(()), "at {z:?}, reach {reach}");
    let jet = term.jet(z);
    let largest = |m: f64, v: &f64| m.max(v.abs());
    let gradient_error = 1e-3 * (1.0 + jet.gradient.iter().fold(0.0, largest));
    let hessian_error = 1e-3 * (1.0 + jet.hessian.iter().flatten().fold(0.0, largest));
    let refuses_both = |in_jet: &dyn Fn(&mut Jet<K>), in_slope: &dyn Fn(&mut Slope<K>)| {
        let planted = Planted {
            term,
            in_jet,
            in_slope,
        };
        let verdict = check(&planted, z, reach);
        assert!(
            matches!(verdict, Err(Fault::Wrong(_))),
            "{verdict:?} at {z:?}"
        );
    };
    let refuses = |in_jet: &dyn Fn(&mut Jet<K>)| refuses_both(in_jet, &|_| {});
    let tiny = 1e-10 * (1.0 + jet.gradient.iter().fold(0.0, largest));
    refuses_both(&|_| {}, &|slope| slope.0 += 1e-9 * (1.0 + slope.0.abs()));
    refuses(&|jet| jet.value += 1e-9 * (1.0 + jet.value.abs()));
    for i in 0..K {
        refuses(&|jet| jet.gradient[i] += gradient_error);
        // The slope alone is held to the jet; with the jet it is held to the values.
        refuses_both(&|_| {}, &|slope| slope.1[i] += tiny);
        refuses_both(&|jet| jet.gradient[i] += gradient_error, &|slope| {
            slope.1[i] += gradient_error;
        });
        for j in 0..K {
            // Alone it also breaks the symmetry; with its mirror only the value is wrong.
            refuses(&|jet| jet.hessian[i][j] += hessian_error);
            refuses(&|jet| {
                let wrong = jet.hessian[i][j] + hessian_error;
                jet.set_mixed(i, j, wrong);
            });
        }
    }
}

#[test]
fn differences_of_a_known_function() {
    let found = slope(|h| (1.0 + h).exp(), 0.1);
    assert!((found.value - 1.0_f64.exp()).abs() < 1e-10, "{found:?}");
    let found = extrapolated(|h| (h.cos() - 2.0 + h.cos()) / (h * h), 0.1);
    assert!((found.value + 1.0).abs() < 1e-9, "{found:?}");
}

#[test]
fn a_kink_within_reach_is_not_taken_for_smooth() {
    struct Kink;
    impl Term<1> for Kink {
        fn value(&self, z: &[f64; 1]) -> f64 {
            z[0].abs()
        }
        fn slope(&self, z: &[f64; 1]) -> (f64, [f64; 1]) {
            (z[0].abs(), [z[0].signum()])
        }
        fn jet(&self, z: &[f64; 1]) -> Jet<1> {
            let mut jet = Jet::constant(z[0].abs());
            jet.gradient = [z[0].signum()];
            jet
        }
    }
    assert_eq!(check(&Kink, &[1e-4], 0.1), Err(Fault::Rough));
    assert_eq!(check(&Kink, &[0.2], 0.1), Ok(()));
}
