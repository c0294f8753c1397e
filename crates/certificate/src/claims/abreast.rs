use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::wrap_angle;

/// At every waypoint but the first and last, each heading is within `max_skew` of the vector from the right to the left
/// robot turned by -90 degrees; margin in rad.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let mut tightest = Tightest::new();
    let limit = subject.scene.planner.max_skew;
    for i in 1..subject.steps() {
        let pair = subject.trajectory.pair(i);
        if pair.separation() == 0.0 {
            return Tightest::unusable(
                Some(i),
                "the robots are at the same point: no line between them",
            );
        }
        for (side, pose) in [("left", pair.left), ("right", pair.right)] {
            let skew = wrap_angle(pose.heading - pair.normal_heading()).abs();
            tightest.consider(limit - skew, i, pose.position(), || {
                format!("{side} robot is skewed by {skew:.4} rad, limit {limit} rad")
            });
        }
    }
    tightest
}
