use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::{Bounds, Point, Segment, SweptLine};

/// The line between the robots passes over every object's center at some instant.
///
/// The margin of an object is its distance from the nearer robot when the line passes over it, the best over all
/// passages, or minus its distance from the swept region when none does, m. Its step is that of the best passage.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let lines: Vec<(SweptLine, Bounds)> = (0..subject.steps())
        .map(|i| {
            let corners @ [l0, l1, r1, r0] = subject.corners(i);
            (
                SweptLine {
                    left: Segment::new(l0, l1),
                    right: Segment::new(r0, r1),
                },
                Bounds::of(&corners),
            )
        })
        .collect();
    let mut tightest = Tightest::new();
    for (j, object) in subject.scene.objects.iter().enumerate() {
        let (margin, step) = best_passage(&lines, object.position);
        tightest.consider(margin, step, object.position, || {
            if margin >= 0.0 {
                format!(
                    "object {j}, {margin:.4} m from the nearer robot when the line passes over it"
                )
            } else {
                format!("object {j}, {:.4} m outside the swept region", -margin)
            }
        });
    }
    tightest
}

/// The best margin over all steps and the step where it is attained; NaN for a point that is not finite.
fn best_passage(lines: &[(SweptLine, Bounds)], p: Point) -> (f64, usize) {
    if !p.is_finite() {
        return (f64::NAN, 0);
    }
    let at = Bounds::of(&[p]);
    let mut best = (f64::NEG_INFINITY, 0);
    for (i, (line, bounds)) in lines.iter().enumerate() {
        // A box that is farther away than what is known already cannot improve it.
        let away = bounds.distance(&at);
        if away > 0.0 && -away <= best.0 {
            continue;
        }
        let margin = line.coverage(p).margin;
        if margin > best.0 {
            best = (margin, i);
        }
    }
    best
}
