use crate::search::{Bound, least};
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_model::Side;

/// The axle centers stay in the scene's rectangle; margin in m.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let area = subject.scene.area;
    let mut tightest = Tightest::new();
    for (reading, steps) in &subject.readings {
        for side in Side::BOTH {
            least(reading, steps, &mut tightest, |stretch, so_far| {
                let slack = stretch.bow(side);
                let ends = [stretch.from, stretch.to].map(|pair| pair[side.index()].position());
                let sides = ends.map(|p| {
                    [
                        (p.x - area.min.x, "left", p),
                        (area.max.x - p.x, "right", p),
                        (p.y - area.min.y, "lower", p),
                        (area.max.y - p.y, "upper", p),
                    ]
                });
                // A segment is as close to a side as its closer end.
                let (room, which, place) = sides
                    .into_iter()
                    .flatten()
                    .reduce(|a, b| if b.0 < a.0 { b } else { a })?;
                (room - slack < so_far).then_some(Bound {
                    margin: room - slack,
                    slack,
                    place,
                    detail: move || format!("{side}, the {which} side of the area"),
                })
            });
        }
    }
    tightest
}
