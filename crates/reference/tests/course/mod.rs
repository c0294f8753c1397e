//! Courses for tests: a pair abreast that drives straight on, then a left turn, then a right turn.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::PairTrajectory;

/// Distance of each robot from the middle, m.
const HALF: f64 = 0.4;
/// Length of the middle's way, m.
const LENGTH: f64 = 4.0;

/// Curvature of the middle's way after `s` m, 1/m; it changes gently from 0 to 0.6 and on to -0.6.
fn curvature(s: f64) -> f64 {
    0.6 * (1.5 * (s - 1.0).max(0.0)).sin()
}

/// The course in `count` even steps, all lengths multiplied by `scale`. Both robots roll on parallel curves.
pub fn course(count: usize, scale: f64) -> PairTrajectory {
    let mut trajectory = PairTrajectory {
        step_time: 0.248,
        ..PairTrajectory::default()
    };
    let (mut middle, mut heading) = (Point::ZERO, 0.0);
    let fine = 10_000;
    for k in 0..=fine {
        if k % (fine / count) == 0 {
            let side = Point::unit(heading).perp() * HALF;
            let at = |p: Point| Pose::at(p * scale, heading);
            trajectory.left.push(at(middle + side));
            trajectory.right.push(at(middle - side));
        }
        let ds = LENGTH / fine as f64;
        let turn = curvature((k as f64 + 0.5) * ds) * ds;
        middle += Point::unit(heading + 0.5 * turn) * ds;
        heading += turn;
    }
    trajectory
}

/// The course with a wait of three steps, and a turn on the spot of the left robot, which ends its way.
pub fn with_waits() -> PairTrajectory {
    let mut t = course(100, 1.0);
    for _ in 0..3 {
        t.left.insert(20, t.left[20]);
        t.right.insert(20, t.right[20]);
    }
    for _ in 0..4 {
        let mut left = t.left[t.len() - 1];
        left.heading += 0.08;
        let right = t.right[t.len() - 1];
        t.left.push(left);
        t.right.push(right);
    }
    t
}
