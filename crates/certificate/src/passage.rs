use crate::motion::{Reading, Stretch};
use pairtrawl_geometry::Point;
use pairtrawl_model::Side;

/// A step is searched for passages in this many parts.
const PARTS: usize = 4;
/// Halvings of a part in which the line passes: the instant is then known to 1e-9 of a step.
const HALVINGS: usize = 28;

/// How safely the line between the robots passes over a point within a step: the point's distance from the nearer robot at
/// that instant, certainly no less, m; `None` when no passage is found.
///
/// With L and R the robots and p the point, g = (R - L) x (p - L) changes its sign when p crosses the carrier of the line; it
/// is continuous, so between two instants with different signs there is an instant at which p lies on it. These instants are
/// brought so close together that what the robots move meanwhile does not count.
pub(crate) fn best_passage(reading: &Reading<'_>, stretch: &Stretch, p: Point) -> Option<f64> {
    let line = |w: f64| Side::BOTH.map(|side| reading.pose(side, stretch.step, w).position());
    let side_of = |[left, right]: [Point; 2]| (right - left).cross(p - left);
    let mut best: Option<f64> = None;
    for part in 0..PARTS {
        let [mut a, mut b] = [part, part + 1].map(|k| k as f64 / PARTS as f64);
        let at_a = side_of(line(a));
        if at_a * side_of(line(b)) > 0.0 {
            continue;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (a + b);
            if at_a * side_of(line(middle)) > 0.0 {
                a = middle;
            } else {
                b = middle;
            }
        }
        let ends @ [left, right] = line(b);
        let width = right.distance(left);
        let along = (p - left).dot(right - left) / width;
        // From now to the passage neither robot moves more than this, nor does the line turn by more.
        let moved = 4.0 * stretch.travel() * (b - a);
        if along >= moved && along <= width - moved {
            let [from_left, from_right] = ends.map(|end| end.distance(p));
            let margin = from_left.min(from_right) - moved;
            best = Some(best.map_or(margin, |known| known.max(margin)));
        }
    }
    best
}
