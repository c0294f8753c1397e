use crate::search::{Bound, least};
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::Hull;
use pairtrawl_model::numbers::length;

/// The center of every circle of each robot's body keeps at least its radius from every obstacle; margin in m beyond the
/// radius.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let obstacles = match &subject.obstacles {
        Ok(obstacles) => obstacles,
        Err(reason) => return Tightest::unusable(None, reason.as_str()),
    };
    let mut tightest = Tightest::new();
    for (reading, steps) in &subject.readings {
        for (side, circle, name) in subject.circles() {
            let radius = circle.radius;
            least(reading, steps, &mut tightest, |stretch, so_far| {
                let (ends, slack) = stretch.path_of(side, &circle);
                let (gap, part) = obstacles.gap(&Hull::of(&ends), so_far + radius + slack)?;
                let (distance, name) = (gap.distance - slack, &name);
                Some(Bound {
                    margin: distance - radius,
                    slack,
                    place: gap.place,
                    detail: move || {
                        format!(
                            "{name}, {} from {part}, radius {}",
                            length(distance),
                            length(radius)
                        )
                    },
                })
            });
        }
    }
    tightest
}
