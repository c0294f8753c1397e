use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::Point;
use pairtrawl_model::numbers::length;

/// Greatest displacement across the mid-step heading, m.
const SLIP: f64 = 1e-4;

/// The displacement of each step across the mid-step heading is at most 0.1 mm; margin in m.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let mut tightest = Tightest::new();
    for (side, i, from, to) in subject.robot_steps() {
        let middle = Point::unit(from.lerp(to, 0.5).heading);
        let across = middle.cross(to.position() - from.position()).abs();
        tightest.consider(SLIP - across, i, from.position(), || {
            format!("{side} slips {} sideways", length(across))
        });
    }
    tightest
}
