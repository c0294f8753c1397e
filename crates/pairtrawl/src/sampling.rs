//! More waypoints sample the same motion more finely, and the run time stays.
//!
//! The paper's J_s adds squared second differences with unit step: with twice the waypoints it weighs an eighth. Turning costs
//! its amount alone, however sudden, so that headings would bend within one step however short that is, and the
//! accelerations that robots keep to would slow the pair there. Where waypoints lie closer than by default the solver therefore
//! weighs J_s as they lie by default; reports show the literal J.

use pairtrawl_model::PairTrajectory;
use pairtrawl_trajopt::Problem;
use std::borrow::Cow;

/// Steps of the greatest length in the longer path, as a part of all steps: 1 / 1.3 by default (`baseline`).
const BY_DEFAULT: f64 = 1.3;
/// Up to here the sampling counts as the default one, which may have a few more waypoints for turns or after a failure.
const STILL_DEFAULT: f64 = 1.45;
/// From here on the weight follows the sampling, between it is interpolated.
const FINER: f64 = 1.75;

/// The problem as it is solved from this start, both in units of the length scale.
pub(crate) fn weighed<'a>(problem: &'a Problem, start: &PairTrajectory) -> Cow<'a, Problem> {
    let (left, right) = start.path_lengths();
    let steps = start.len().saturating_sub(1) as f64;
    let finer = times_finer(steps * problem.planner.max_step / left.max(right));
    if finer <= 1.0 {
        return Cow::Borrowed(problem);
    }
    let mut weighed = problem.clone();
    let cube = finer * finer * finer;
    weighed.planner.b1 *= cube;
    weighed.planner.b2 *= cube;
    // The cube keeps the weight of a meter. One more power keeps the run time, measured on four scenes.
    weighed.planner.b3 *= cube * finer;
    Cow::Owned(weighed)
}

/// How many times closer than by default waypoints lie, from how many times more steps there are than the longer path needs.
fn times_finer(reserve: f64) -> f64 {
    // A path without length has no sampling.
    if !reserve.is_finite() || reserve <= STILL_DEFAULT {
        return 1.0;
    }
    let full = reserve.max(FINER) / BY_DEFAULT;
    let part = ((reserve - STILL_DEFAULT) / (FINER - STILL_DEFAULT)).min(1.0);
    1.0 + part * (full - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_weight_is_that_of_the_paper_by_default_and_grows_without_a_jump() {
        assert_eq!(times_finer(BY_DEFAULT), 1.0);
        assert_eq!(times_finer(f64::INFINITY), 1.0);
        assert!((times_finer(2.0 * BY_DEFAULT) - 2.0).abs() < 1e-12);
        let samples: Vec<f64> = (0..400).map(|i| times_finer(0.01 * f64::from(i))).collect();
        assert!(
            samples
                .windows(2)
                .all(|w| w[1] >= w[0] && w[1] - w[0] < 0.02)
        );
    }
}
