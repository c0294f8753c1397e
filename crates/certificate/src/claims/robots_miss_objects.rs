use crate::search::{Bound, least};
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::{Bounds, Segment};
use pairtrawl_model::numbers::length;

/// Every circle of each robot's body keeps off every object's footprint circle; margin in m.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let mut tightest = Tightest::new();
    for (j, object) in subject.scene.objects.iter().enumerate() {
        let footprint = object.footprint_radius();
        if !(object.position.is_finite() && footprint.is_finite()) {
            return Tightest::unusable(
                None,
                format!("object {j} has a position or size that is not finite"),
            );
        }
        let center = Bounds::of(&[object.position]);
        for (reading, steps) in &subject.readings {
            for (side, circle, name) in subject.circles() {
                let (radius, offset) = (circle.radius, circle.offset());
                let reach = footprint + radius;
                least(reading, steps, &mut tightest, |stretch, so_far| {
                    // Where the axle is tells most of the time: it is near the circle.
                    let axles =
                        [stretch.from, stretch.to].map(|pair| pair[side.index()].position());
                    let away = Bounds::of(&axles).distance(&center) - offset;
                    if away - reach - stretch.bow_off_axle(side, offset) >= so_far {
                        return None;
                    }
                    let ([a, b], slack) = stretch.path_of(side, &circle);
                    let gap = Segment::new(a, b).gap_to_disc(object.position, reach);
                    let (margin, name) = (gap.distance - slack, &name);
                    Some(Bound {
                        margin,
                        slack,
                        place: gap.place,
                        detail: move || {
                            format!(
                                "{name}, {} from the footprint circle of object {j}, radius {}",
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
