use crate::motion::{Reading, Stretch};
use crate::passage::best_passage;
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::{Bounds, Point, Segment, SweptLine};
use pairtrawl_model::numbers::length;

/// The line between the robots passes over the center of every object that is not left, at some instant.
///
/// The margin of an object is its distance from the nearer robot when the line passes over it, the best over all
/// passages, or minus its distance from the swept region when none does, m. Its step is that of the best passage.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let mut tightest = Tightest::new();
    for (reading, steps) in &subject.readings {
        let bounds: Vec<Bounds> = steps.iter().map(Stretch::bounds).collect();
        for (j, object) in subject.scene.objects.iter().enumerate() {
            if object.leave {
                continue;
            }
            let (margin, step) = best(reading, steps, &bounds, object.position);
            tightest.consider(margin, step, object.position, || {
                let on = reading.suffix();
                if margin >= 0.0 {
                    format!(
                        "object {j}, {} from the nearer robot when the line passes over it{on}",
                        length(margin)
                    )
                } else {
                    format!(
                        "object {j}, {} outside the swept region{on}",
                        length(-margin)
                    )
                }
            });
        }
    }
    tightest
}

/// The best margin over all steps and the step where it is attained; NaN for a point that is not finite.
fn best(reading: &Reading<'_>, steps: &[Stretch], bounds: &[Bounds], p: Point) -> (f64, usize) {
    if !p.is_finite() {
        return (f64::NAN, 0);
    }
    let at = Bounds::of(&[p]);
    let mut best = (f64::NEG_INFINITY, 0);
    for (stretch, bounds) in steps.iter().zip(bounds) {
        // A box that is farther away than what is known already cannot improve it.
        let away = bounds.distance(&at);
        if away > 0.0 && -away <= best.0 {
            continue;
        }
        let [l0, l1, r1, r0] = stretch.corners();
        let even = SweptLine {
            left: Segment::new(l0, l1),
            right: Segment::new(r0, r1),
        };
        // A line that cannot come to the point within the step does not pass over it.
        let far = even.at(0.0).distance(p) > stretch.travel();
        if far && best.0 >= 0.0 {
            continue;
        }
        let passage = match reading {
            Reading::Linear(_) => None,
            Reading::Smooth(_) if far => None,
            Reading::Smooth(_) => best_passage(reading, stretch, p),
        };
        let margin = passage.unwrap_or_else(|| match reading {
            Reading::Linear(_) => even.coverage(p).margin,
            // Where only even motion would pass over the point, it is missed by less than that strays.
            Reading::Smooth(_) => even.coverage(p).margin.min(-stretch.greatest_bow()),
        });
        if margin > best.0 {
            best = (margin, stretch.step);
        }
    }
    best
}
