use super::free_space::FreeSpace;
use super::things::Things;
use pairtrawl_geometry::{Bounds, Point};

/// No more cells than this are looked at.
const MOST_CELLS: usize = 100_000;
/// A cell is inside an obstacle when it is this deep at least, m.
const CLOSE: f64 = 1e-6;

/// The cells that a line from `center`, no longer than `reach` and in no obstacle's inside, may get to: those joined to
/// the center's own by cells within reach that are not wholly inside one obstacle. `None` when there are too many cells.
///
/// The line may leave the area, so every cell at its edge is joined to every other.
pub(super) fn joined(
    things: &Things<'_>,
    space: &FreeSpace,
    center: Point,
    reach: f64,
) -> Option<Vec<bool>> {
    let near: Vec<usize> = space
        .cells_near(&Bounds::of_disc(center, reach.max(0.0)))
        .take(MOST_CELLS + 1)
        .collect();
    if near.len() > MOST_CELLS {
        return None;
    }
    let at = Bounds::of(&[center]);
    let half = 0.5 * space.size().norm();
    let mut open = vec![false; space.len()];
    for &i in &near {
        let inside = |d: f64| d < -(half + CLOSE);
        let within = space.bounds(i).distance(&at) <= reach;
        open[i] = within
            && !things
                .obstacles
                .distance(space.center(i), 0.0)
                .is_some_and(|(d, _)| inside(d));
    }
    let edge: Vec<usize> = near
        .iter()
        .copied()
        .filter(|&i| open[i] && space.is_at_edge(i))
        .collect();
    let mut reached = vec![false; space.len()];
    let own = space.index(center);
    reached[own] = true;
    let mut front = vec![own];
    while let Some(i) = front.pop() {
        let mut visit = |j: usize| {
            if open[j] && !std::mem::replace(&mut reached[j], true) {
                front.push(j);
            }
        };
        if space.is_at_edge(i) {
            edge.iter().for_each(|&j| visit(j));
        }
        space.neighbors(i).for_each(visit);
    }
    Some(reached)
}
