//! Which pairs can touch soon.
//!
//! Pairs are looked for with a skin around every shape and stay valid until something has moved by half of it (Verlet, Physical
//! Review 159, 1967). Things that move are swept along x; what is fixed lies in a grid.

use crate::outline::Outline;
use crate::solid::Solid;
use pairtrawl_geometry::Bounds;
use std::collections::BTreeMap;

/// Width of the skin, in units of the machine.
pub(crate) const SKIN: f64 = 0.02;
/// Side of a cell of the grid.
const CELL: f64 = 0.5;

/// Fixed shapes by the cells that they reach.
#[derive(Clone, Debug, Default)]
pub(crate) struct Grid {
    cells: BTreeMap<(i64, i64), Vec<usize>>,
    boxes: Vec<Bounds>,
    /// Larger than many cells: looked at always.
    large: Vec<usize>,
}

/// A shape over more cells than this is kept apart.
const MANY_CELLS: i64 = 1024;

impl Grid {
    pub(crate) fn new(shapes: &[Solid]) -> Self {
        let mut grid = Self::default();
        for (index, shape) in shapes.iter().enumerate() {
            let bounds = shape.outline().bounds(0.0);
            grid.boxes.push(bounds);
            let [(x0, y0), (x1, y1)] = cells(&bounds);
            if (x1 - x0 + 1).saturating_mul(y1 - y0 + 1) > MANY_CELLS {
                grid.large.push(index);
                continue;
            }
            for x in x0..=x1 {
                for y in y0..=y1 {
                    grid.cells.entry((x, y)).or_default().push(index);
                }
            }
        }
        grid
    }

    /// Adds the shapes whose bounds meet these, in ascending order.
    fn find(&self, bounds: &Bounds, found: &mut Vec<usize>) {
        found.clear();
        if self.boxes.is_empty() {
            return;
        }
        let meets = |index: &&usize| self.boxes[**index].meets(bounds);
        found.extend(self.large.iter().filter(meets));
        let [(x0, y0), (x1, y1)] = cells(bounds);
        for x in x0..=x1 {
            for y in y0..=y1 {
                if let Some(cell) = self.cells.get(&(x, y)) {
                    found.extend(cell.iter().filter(meets));
                }
            }
        }
        found.sort_unstable();
        found.dedup();
    }
}

fn cells(bounds: &Bounds) -> [(i64, i64); 2] {
    [bounds.min, bounds.max].map(|p| ((p.x / CELL).floor() as i64, (p.y / CELL).floor() as i64))
}

/// Pairs that are near each other.
#[derive(Clone, Debug, Default)]
pub(crate) struct Neighbors {
    /// Of two things that move, by index, the smaller first.
    pub(crate) moving: Vec<(usize, usize)>,
    /// Of a thing that moves and a fixed shape.
    pub(crate) fixed: Vec<(usize, usize)>,
    boxes: Vec<(usize, Bounds)>,
    found: Vec<usize>,
}

impl Neighbors {
    /// Looks anew. `shapes` are the things that move, those asleep left out, by index; `apart` says which pairs never touch.
    pub(crate) fn update<'a>(
        &mut self,
        shapes: impl Iterator<Item = (usize, Outline<'a>)>,
        grid: &Grid,
        apart: impl Fn(usize, usize) -> bool,
    ) {
        self.moving.clear();
        self.fixed.clear();
        self.boxes.clear();
        self.boxes
            .extend(shapes.map(|(index, outline)| (index, outline.bounds(0.5 * SKIN))));
        for (index, bounds) in &self.boxes {
            grid.find(bounds, &mut self.found);
            self.fixed
                .extend(self.found.iter().map(|&shape| (*index, shape)));
        }
        self.boxes
            .sort_unstable_by(|a, b| a.1.min.x.total_cmp(&b.1.min.x).then(a.0.cmp(&b.0)));
        for (k, (a, bounds)) in self.boxes.iter().enumerate() {
            for (b, other) in &self.boxes[k + 1..] {
                if other.min.x > bounds.max.x {
                    break;
                }
                let pair = (*a.min(b), *a.max(b));
                if bounds.meets(other) && !apart(pair.0, pair.1) {
                    self.moving.push(pair);
                }
            }
        }
        // The order in which contacts are found decides how sums are rounded.
        self.moving.sort_unstable();
        self.fixed.sort_unstable();
    }
}
