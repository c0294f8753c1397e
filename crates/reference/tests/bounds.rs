//! What is claimed to hold on a stretch, against dense samples on random steps, wild ones included.

use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{PairTrajectory, Side};
use pairtrawl_reference::{Reference, ReferenceLimits};
use proptest::prelude::*;

/// Two steps by random forward moves, turns and slips.
fn poses() -> impl Strategy<Value = Vec<Pose>> {
    let step = (0.0..0.06_f64, -0.3..0.3_f64, -1e-4..1e-4_f64);
    (prop::collection::vec(step, 2..5), -4.0..4.0_f64).prop_map(|(steps, heading)| {
        let mut poses = vec![Pose::new(1.0, -2.0, heading)];
        for (along, turn, slip) in steps {
            let last = poses[poses.len() - 1];
            let forward = Point::unit(last.heading + 0.5 * turn);
            let place = last.position() + forward * along + forward.perp() * slip;
            poses.push(Pose::at(place, last.heading + turn));
        }
        poses
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn bounds_contain_dense_samples_and_the_curve_rolls(poses in poses(), a in 0.0..0.9_f64, width in 0.01..1.0_f64) {
        let stretch = [a, (a + width).min(1.0)];
        let t = PairTrajectory { left: poses.clone(), right: poses.clone(), step_time: 0.25 };
        let limits = ReferenceLimits::of(&Default::default());
        let r = Reference::new(&Default::default(), &Default::default(), &t, &limits).unwrap();
        for step in r.steps(Side::Left) {
            let b = step.bounds(stretch);
            for k in 0..=200 {
                let w = stretch[0] + (stretch[1] - stretch[0]) * f64::from(k) / 200.0;
                let s = step.at(w);
                let slack = 1e-14;
                prop_assert!(b.speed[0] - slack <= s.speed && s.speed <= b.speed[1] + slack);
                prop_assert!(b.rate[0] - slack <= s.rate && s.rate <= b.rate[1] + slack);
                prop_assert!(s.speed_slope.abs() <= b.speed_slope + slack);
                prop_assert!(s.rate_slope.abs() <= b.rate_slope + slack);
                prop_assert!(s.speed.abs() <= b.fastest() + slack && s.rate.abs() <= b.sharpest() + slack);
            }
            // The position is the integral of the velocity: many short steps by the midpoint rule, extrapolated.
            let rolled = |count: i32| (0..count).fold(step.pose(0.0).position(), |p, k| {
                let w = (f64::from(k) + 0.5) / f64::from(count);
                p + Point::unit(step.heading(w)) * (step.at(w).speed / f64::from(count))
            });
            let (half, whole) = (rolled(1000), rolled(2000));
            let exact = whole + (whole - half) / 3.0;
            prop_assert!(exact.distance(step.pose(1.0).position()) < 1e-10, "{}", exact.distance(step.pose(1.0).position()));
        }
        for (i, steps) in r.steps(Side::Left).windows(2).enumerate() {
            let (before, after) = (steps[0].at(1.0), steps[1].at(0.0));
            prop_assert!(before.pose.position().distance(after.pose.position()) < 1e-12, "step {i}");
            prop_assert!((before.speed - after.speed).abs() < 1e-12 && (before.rate - after.rate).abs() < 1e-12);
        }
    }
}
