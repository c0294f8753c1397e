use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::Hull;

/// The convex hull of left[i], left[i+1], right[i+1], right[i] overlaps no obstacle. Touching is no overlap. The margin
/// is the distance, or minus the depth of the overlap, m.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let obstacles = match &subject.obstacles {
        Ok(obstacles) => obstacles,
        Err(reason) => return Tightest::unusable(None, reason.as_str()),
    };
    let mut tightest = Tightest::new();
    for i in 0..subject.steps() {
        let swept = Hull::of(&subject.corners(i));
        if let Some((gap, part)) = obstacles.gap(&swept, tightest.margin()) {
            tightest.consider(gap.distance, i, gap.place, || {
                if gap.distance < 0.0 {
                    format!("the swept net overlaps {part} by {:.4} m", -gap.distance)
                } else {
                    format!("the swept net passes {part} at {:.4} m", gap.distance)
                }
            });
        }
    }
    tightest
}
