use crate::search::{Bound, least};
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::Hull;
use pairtrawl_model::numbers::length;

/// The convex hull of left[i], left[i+1], right[i+1], right[i] overlaps no obstacle, nor does the line between the robots on
/// the smooth curve at any instant. Touching is no overlap. The margin is the distance, or minus the depth of the overlap, m.
///
/// On the smooth curve the line stays within the greater bow of both robots of the hull of a stretch.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let obstacles = match &subject.obstacles {
        Ok(obstacles) => obstacles,
        Err(reason) => return Tightest::unusable(None, reason.as_str()),
    };
    let mut tightest = Tightest::new();
    for (reading, steps) in &subject.readings {
        least(reading, steps, &mut tightest, |stretch, so_far| {
            let slack = stretch.greatest_bow();
            let swept = Hull::of(&stretch.corners());
            let (gap, part) = obstacles.gap(&swept, so_far + slack)?;
            let margin = gap.distance - slack;
            Some(Bound {
                margin,
                slack,
                place: gap.place,
                detail: move || {
                    if margin < 0.0 {
                        format!("the swept net overlaps {part} by {}", length(-margin))
                    } else {
                        format!("the swept net passes {part} at {}", length(margin))
                    }
                },
            })
        });
    }
    tightest
}
