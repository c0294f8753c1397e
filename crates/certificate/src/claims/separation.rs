use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::{Point, Segment};

/// d_min / d_max of the claim; the planner's own ratio does not enter.
const MIN_RATIO: f64 = 0.1;

/// At every instant max(0.1 d_max, 2 robot radius) <= axle distance <= d_max; margin in m.
///
/// The vector between the axles is linear in time, so its length is convex: least where the segment that it traces is
/// nearest to the origin, greatest at an end.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let greatest = subject.net_length;
    if !(greatest.is_finite() && greatest > 0.0) {
        return Tightest::unusable(
            None,
            format!("the net length {greatest} m is not a positive number"),
        );
    }
    let least = (MIN_RATIO * greatest).max(2.0 * subject.scene.robot.radius);
    let mut tightest = Tightest::new();
    for i in 0..subject.steps() {
        let [l0, l1, r1, r0] = subject.corners(i);
        let between = Segment::new(l0 - r0, l1 - r1);
        let t = between.nearest_parameter(Point::ZERO);
        let d = between.at(t).norm();
        tightest.consider(
            d - least,
            i,
            l0.lerp(l1, t).lerp(r0.lerp(r1, t), 0.5),
            || format!("the axles come within {d:.4} m, at least {least:.4} m are needed"),
        );
        for (d, place) in [
            (between.a.norm(), l0.lerp(r0, 0.5)),
            (between.b.norm(), l1.lerp(r1, 0.5)),
        ] {
            tightest.consider(greatest - d, i, place, || {
                format!("the axles are {d:.4} m apart, the net is {greatest} m long")
            });
        }
    }
    tightest
}
