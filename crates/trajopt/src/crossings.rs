//! Where the line between the robots passes over each object.

use crate::iterate::Iterate;
use crate::problem::Problem;
use pairtrawl_model::Side;

/// Waypoints between those that are tried first for the crossing of an object.
const STRIDE: usize = 4;
/// Waypoints by which a crossing moves at most from one look to the next.
const FARTHEST_CROSSING: usize = 100;

/// The waypoint at which the line passes over each object: of those where it does, the one nearest the object along the
/// direction of travel; else the one where it nearly does. Looked up around the earlier ones unless that list is empty.
pub(crate) fn refresh_crossings(crossings: &mut Vec<usize>, problem: &Problem, x: &Iterate) {
    let first = crossings.is_empty();
    let n = x.stages.len();
    for (id, &(object, _)) in problem.objects.iter().enumerate() {
        let miss = |i: usize| {
            let (l, r) = (x.position(i, Side::Left), x.position(i, Side::Right));
            let rung = l - r;
            let length = rung.norm();
            let along = (object - r).dot(rung) / length;
            let ahead = (object - r).cross(rung).abs() / length;
            ahead + 4.0 * (-along).max(along - length).max(0.0)
        };
        let nearest = |window: &mut dyn Iterator<Item = usize>| {
            window
                .min_by(|&a, &b| miss(a).total_cmp(&miss(b)))
                .unwrap_or(1)
        };
        let around =
            |k: usize, reach: usize| k.saturating_sub(reach).max(1)..(k + reach + 1).min(n - 1);
        if first {
            let coarse = nearest(&mut (1..n - 1).step_by(STRIDE));
            crossings.push(nearest(&mut around(coarse, STRIDE)));
        } else {
            let reach = (n / 8).min(FARTHEST_CROSSING);
            crossings[id] = nearest(&mut around(crossings[id], reach));
        }
    }
}
