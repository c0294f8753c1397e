use crate::search::{Bound, least};
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::Hull;
use pairtrawl_model::Side;
use pairtrawl_model::numbers::length;

/// Each path keeps at least the robot radius from every obstacle; margin in m beyond the radius.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let obstacles = match &subject.obstacles {
        Ok(obstacles) => obstacles,
        Err(reason) => return Tightest::unusable(None, reason.as_str()),
    };
    let radius = subject.scene.robot.radius;
    let mut tightest = Tightest::new();
    for (reading, steps) in &subject.readings {
        for side in Side::BOTH {
            least(reading, steps, &mut tightest, |stretch, so_far| {
                let slack = stretch.bow(side);
                let ends = [stretch.from, stretch.to].map(|pair| pair[side.index()].position());
                let (gap, part) = obstacles.gap(&Hull::of(&ends), so_far + radius + slack)?;
                let distance = gap.distance - slack;
                Some(Bound {
                    margin: distance - radius,
                    slack,
                    place: gap.place,
                    detail: move || {
                        format!(
                            "{side}, {} from {part}, radius {}",
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
