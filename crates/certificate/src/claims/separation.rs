use crate::farthest::greatest_distance;
use crate::search::{Bound, least};
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::{Point, Segment};
use pairtrawl_model::Side;
use pairtrawl_model::numbers::length;

/// d_min / d_max of the claim; the planner's own ratio does not enter.
const MIN_RATIO: f64 = 0.1;

/// At every instant max(0.1 d_max, 2 robot radius) <= axle distance <= d_max; margin in m.
///
/// The vector between the axles strays from even motion by at most the bows of both robots; were it even, its length would
/// be least where the segment that it traces is nearest to the origin.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let greatest = subject.net_length;
    if !(greatest.is_finite() && greatest > 0.0) {
        return Tightest::unusable(
            None,
            format!("the net length {greatest} m is not a positive number"),
        );
    }
    let least_distance = (MIN_RATIO * greatest).max(subject.scene.robot.least_separation());
    let mut tightest = Tightest::new();
    for (reading, steps) in &subject.readings {
        least(reading, steps, &mut tightest, |stretch, _| {
            let [l0, l1, r1, r0] = stretch.corners();
            let between = Segment::new(l0 - r0, l1 - r1);
            let t = between.nearest_parameter(Point::ZERO);
            let slack = stretch.bow(Side::Left) + stretch.bow(Side::Right);
            let d = between.at(t).norm() - slack;
            Some(Bound {
                margin: d - least_distance,
                slack,
                place: l0.lerp(l1, t).lerp(r0.lerp(r1, t), 0.5),
                detail: move || {
                    format!(
                        "the axles come within {}, at least {} are needed",
                        length(d),
                        length(least_distance)
                    )
                },
            })
        });
        least(reading, steps, &mut tightest, |stretch, so_far| {
            let (d, slack, place) = greatest_distance(reading, stretch, 0.0, greatest - so_far)?;
            Some(Bound {
                margin: greatest - d,
                slack,
                place,
                detail: move || {
                    format!(
                        "the axles are {} apart, the net is {} long",
                        length(d),
                        length(greatest)
                    )
                },
            })
        });
    }
    tightest
}
