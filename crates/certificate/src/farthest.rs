use crate::motion::{Reading, Stretch};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::Side;

/// A bound of the greatest distance over a stretch between the points `behind` m behind both axles, m, how much above the
/// distance at an end of the stretch it is, and a place between the robots; `None` when it is no more than `enough`.
///
/// The square q of the distance d has q'' = 2 (|d'|^2 + d . d''), and |q'''| <= 6 |d'| |d''| + 2 |d| |d'''| = K. Hence q''
/// is at least q'' in the middle of the stretch minus K / 2, and q exceeds its greater end by at most an eighth of what
/// that lacks to 0.
pub(crate) fn greatest_distance(
    reading: &Reading<'_>,
    stretch: &Stretch,
    behind: f64,
    enough: f64,
) -> Option<(f64, f64, Point)> {
    let at_end = |pair: [Pose; 2]| {
        let [left, right] = pair.map(|pose| pose.hitch_point(behind));
        (left.distance(right), left.lerp(right, 0.5))
    };
    let (from, to) = (at_end(stretch.from), at_end(stretch.to));
    let (ends, place) = if to.0 > from.0 { to } else { from };
    let bows: f64 = Side::BOTH
        .map(|side| stretch.bow_off_axle(side, behind))
        .iter()
        .sum();
    if ends + bows <= enough {
        return None;
    }
    let [left, right] = Side::BOTH.map(|side| reading.middle(side, stretch, behind));
    let d = left.place - right.place;
    let velocity = left.velocity - right.velocity;
    let acceleration = left.acceleration - right.acceleration;
    let third: f64 = Side::BOTH
        .map(|side| stretch.third_behind(side, behind))
        .iter()
        .sum();
    let second = acceleration.norm() + 0.5 * third;
    let first = velocity.norm() + 0.5 * second;
    let change = 6.0 * first * second + 2.0 * (ends + bows) * third;
    let least_curvature = 2.0 * (velocity.norm_squared() + d.dot(acceleration)) - 0.5 * change;
    let excess = (-least_curvature).max(0.0) / 8.0;
    let bound = if excess > 0.0 {
        (ends * ends + excess).sqrt().min(ends + bows)
    } else {
        ends
    };
    Some((bound, bound - ends, place))
}
