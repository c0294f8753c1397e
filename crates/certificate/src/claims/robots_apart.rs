use crate::search::{Bound, least};
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::{Point, Segment};
use pairtrawl_model::Side;
use pairtrawl_model::numbers::length;

/// No circle of one robot's body overlaps one of the other's at any instant; margin in m.
///
/// The vector between two centers strays from even motion by at most what both centers do; were it even, its length would
/// be least where the segment that it traces is nearest to the origin.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let circles = subject.body.circles();
    let mut tightest = Tightest::new();
    for (reading, steps) in &subject.readings {
        for (i, left) in circles.iter().enumerate() {
            for (j, right) in circles.iter().enumerate() {
                let reach = left.radius + right.radius;
                let offsets = left.offset() + right.offset();
                least(reading, steps, &mut tightest, |stretch, so_far| {
                    // Where the axles are tells most of the time.
                    let [l0, l1, r1, r0] = stretch.corners();
                    let axles = Segment::new(l0 - r0, l1 - r1).distance(Point::ZERO);
                    let slack = stretch.bow_off_axle(Side::Left, left.offset())
                        + stretch.bow_off_axle(Side::Right, right.offset());
                    if axles - offsets - reach - slack >= so_far {
                        return None;
                    }
                    let ([l0, l1], _) = stretch.path_of(Side::Left, left);
                    let ([r0, r1], _) = stretch.path_of(Side::Right, right);
                    let between = Segment::new(l0 - r0, l1 - r1);
                    let t = between.nearest_parameter(Point::ZERO);
                    let margin = between.at(t).norm() - slack - reach;
                    Some(Bound {
                        margin,
                        slack,
                        place: l0.lerp(l1, t).lerp(r0.lerp(r1, t), left.radius / reach),
                        detail: move || {
                            let gap = length(margin.abs());
                            let how = if margin < 0.0 {
                                "overlap by"
                            } else {
                                "stay apart by"
                            };
                            format!(
                                "circle {i} of the left robot's body and circle {j} of the right robot's {how} {gap}"
                            )
                        },
                    })
                });
            }
        }
    }
    tightest
}
