use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::Point;

/// A step may go back by this much, m: the rounding of a written plan.
const BACK: f64 = 1e-6;

/// The displacement of each step along the mid-step heading is at least -1e-6 m; margin in m.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let mut tightest = Tightest::new();
    for (side, i, from, to) in subject.robot_steps() {
        let middle = Point::unit(from.lerp(to, 0.5).heading);
        let along = (to.position() - from.position()).dot(middle);
        tightest.consider(along + BACK, i, from.position(), || {
            format!("{side} moves {along:.3e} m forward")
        });
    }
    tightest
}
