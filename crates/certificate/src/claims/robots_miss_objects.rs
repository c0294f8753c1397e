use crate::search::{Bound, least};
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::{Bounds, Segment};
use pairtrawl_model::Side;
use pairtrawl_model::numbers::length;

/// Each path keeps at least the robot radius from every object's footprint circle; margin in m.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let radius = subject.scene.robot.radius;
    let mut tightest = Tightest::new();
    for (j, object) in subject.scene.objects.iter().enumerate() {
        let reach = object.footprint_radius() + radius;
        if !(object.position.is_finite() && reach.is_finite()) {
            return Tightest::unusable(
                None,
                format!("object {j} has a position or size that is not finite"),
            );
        }
        let center = Bounds::of(&[object.position]);
        for (reading, steps) in &subject.readings {
            for side in Side::BOTH {
                least(reading, steps, &mut tightest, |stretch, so_far| {
                    let slack = stretch.bow(side);
                    let [a, b] =
                        [stretch.from, stretch.to].map(|pair| pair[side.index()].position());
                    if Bounds::of(&[a, b]).distance(&center) - reach - slack >= so_far {
                        return None;
                    }
                    let gap = Segment::new(a, b).gap_to_disc(object.position, reach);
                    let margin = gap.distance - slack;
                    Some(Bound {
                        margin,
                        slack,
                        place: gap.place,
                        detail: move || {
                            format!(
                                "{side}, {} from the footprint circle of object {j}, radius {}",
                                length(margin + radius),
                                length(radius)
                            )
                        },
                    })
                });
            }
        }
    }
    tightest
}
