//! The frame of a step: coordinates, their first-order change, and the curvature that the assembly keeps of them.

use super::between;
use super::derivative_check::{extrapolated, slope};
use crate::step::Step;
use fastrand::Rng;

fn random_step(random: &mut Rng) -> [[f64; 3]; 4] {
    let from: [f64; 3] = std::array::from_fn(|_| between(random, -3.0, 3.0));
    let short: [f64; 3] = std::array::from_fn(|_| between(random, -0.1, 0.1));
    let to = std::array::from_fn(|k| from[k] + short[k]);
    let mut change = || std::array::from_fn(|_| between(random, -1.0, 1.0));
    [from, to, change(), change()]
}

fn at([from, to, d_from, d_to]: &[[f64; 3]; 4], t: f64) -> Step {
    let go = |z: &[f64; 3], d: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|k| z[k] + t * d[k]) };
    Step::new(&go(from, d_from), &go(to, d_to))
}

#[test]
fn a_straight_and_a_turning_step() {
    let straight = Step::new(&[1.0, 2.0, 0.0], &[1.04, 2.0, 0.0]);
    assert!((straight.along - 0.04).abs() < 1e-15 && straight.across == 0.0);
    // Along the mid-step heading of 45 degrees.
    let (from, to) = (
        [0.0, 0.0, 0.8],
        [0.03, 0.03, std::f64::consts::FRAC_PI_2 - 0.8],
    );
    let turning = Step::new(&from, &to);
    assert!((turning.along - 0.03 * 2.0_f64.sqrt()).abs() < 1e-15);
    assert!(turning.across.abs() < 1e-15);
    assert_eq!(turning.turn, to[2] - from[2]);
}

#[test]
fn change_is_the_derivative() {
    let mut random = Rng::with_seed(10);
    for _ in 0..100 {
        let case = random_step(&mut random);
        let (along, across, turn) = at(&case, 0.0).change(&case[2], &case[3]);
        for (given, found) in [
            (along, slope(|t| at(&case, t).along, 0.05)),
            (across, slope(|t| at(&case, t).across, 0.05)),
            (turn, slope(|t| at(&case, t).turn, 0.05)),
        ] {
            assert!(found.error < 1e-8, "{found:?}");
            assert!((given - found.value).abs() < 1e-8, "{given} {found:?}");
        }
    }
}

/// On the linearized slip `d across = 0` the second derivative of `along` is that of a taut string, `along dpsi^2`, and
/// that of `across` is `-2 dalong dpsi - across dpsi^2`.
#[test]
fn curvature_of_the_frame() {
    let mut random = Rng::with_seed(11);
    for _ in 0..100 {
        let mut case = random_step(&mut random);
        let step = at(&case, 0.0);
        let (_, across, _) = step.change(&case[2], &case[3]);
        // Moves the far end sideways until nothing slips.
        case[3][0] += across * step.sin;
        case[3][1] -= across * step.cos;
        let (_, slip, _) = step.change(&case[2], &case[3]);
        assert!(slip.abs() < 1e-14);
        let dpsi = 0.5 * (case[2][2] + case[3][2]);
        let second = |f: &dyn Fn(&Step) -> f64| {
            let g = |t: f64| f(&at(&case, t));
            extrapolated(|h| (g(h) - 2.0 * g(0.0) + g(-h)) / (h * h), 0.1)
        };
        let found = second(&|s| s.along);
        assert!(
            (found.value - step.along * dpsi * dpsi).abs() < 1e-7,
            "{found:?}"
        );
        let (dx, dy) = (case[3][0] - case[2][0], case[3][1] - case[2][1]);
        let forward = dx * step.cos + dy * step.sin;
        let expected = -2.0 * forward * dpsi - step.across * dpsi * dpsi;
        let found = second(&|s| s.across);
        assert!(
            (found.value - expected).abs() < 1e-7,
            "{found:?} {expected}"
        );
    }
}
