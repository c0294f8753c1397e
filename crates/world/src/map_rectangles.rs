//! The blocked cells of an occupancy map as few rectangles.

use pairtrawl_geometry::Point;
use pairtrawl_model::OccupancyMap;

/// A half-open range of cells: columns `low.0..high.0`, rows `low.1..high.1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CellRange {
    /// First column and row.
    pub low: (usize, usize),
    /// Column and row after the last.
    pub high: (usize, usize),
}

impl CellRange {
    /// Corners counter-clockwise from the lower left one, map frame, m.
    pub fn corners(&self, map: &OccupancyMap) -> Vec<Point> {
        let (x0, y0) = (self.low.0 as f64, self.low.1 as f64);
        let (x1, y1) = (self.high.0 as f64, self.high.1 as f64);
        rectangle(map, Point::new(x0, y0), Point::new(x1, y1))
    }
}

/// Rectangles reach at most this number of cells to each side of the cell that they start from.
const REACH: usize = 128;
/// Rectangles reach at most so deep, m, into blocked cells beyond those that they are there to cover.
const DEPTH: f64 = 0.5;

/// Rectangles of blocked cells (they may overlap) that cover every blocked cell with a free one among its eight neighbors.
/// Cells deeper inside bound nothing and may stay uncovered, so the boundary of the union is exactly the boundary between
/// blocked and free cells.
///
/// Greedy: the first uncovered cell in reading order grows as far as all cells are blocked, sideways first or upwards
/// first, whichever covers more; then what covers nothing new is cut off but for [`DEPTH`].
pub fn blocked_rectangles(map: &OccupancyMap) -> Vec<CellRange> {
    let counts = BlockedCounts::new(map);
    // Cells at the boundary that no rectangle covers yet.
    let mut open: Vec<bool> = (0..map.columns * map.rows)
        .map(|i| map.blocked[i] && has_free_neighbor(map, i % map.columns, i / map.columns))
        .collect();
    let depth = (DEPTH / map.resolution).ceil().min(REACH as f64) as usize;
    let mut rectangles = Vec::new();
    for start in 0..open.len() {
        if !open[start] {
            continue;
        }
        let cell = (start % map.columns, start / map.columns);
        let [sideways, upwards] = counts
            .maximal_around(cell)
            .map(|r| (r, open_cells(&open, map.columns, &r)));
        let (whole, (_, needed)) = if upwards.1.0 > sideways.1.0 {
            upwards
        } else {
            sideways
        };
        let rectangle = CellRange {
            low: (
                whole.low.0.max(needed.low.0.saturating_sub(depth)),
                whole.low.1.max(needed.low.1.saturating_sub(depth)),
            ),
            high: (
                whole.high.0.min(needed.high.0 + depth),
                whole.high.1.min(needed.high.1 + depth),
            ),
        };
        for row in rectangle.low.1..rectangle.high.1 {
            open[row * map.columns + rectangle.low.0..row * map.columns + rectangle.high.0]
                .fill(false);
        }
        rectangles.push(rectangle);
    }
    rectangles
}

/// How many open cells a rectangle has, and the rectangle around those.
fn open_cells(open: &[bool], columns: usize, within: &CellRange) -> (usize, CellRange) {
    let mut count = 0;
    let mut around = CellRange {
        low: within.high,
        high: within.low,
    };
    for row in within.low.1..within.high.1 {
        for column in within.low.0..within.high.0 {
            if open[row * columns + column] {
                count += 1;
                around.low = (around.low.0.min(column), around.low.1.min(row));
                around.high = (around.high.0.max(column + 1), around.high.1.max(row + 1));
            }
        }
    }
    (count, around)
}

/// Four rectangles that cover the outside of a map as far as anything can matter, corners as of [`CellRange::corners`].
pub fn outside_rectangles(map: &OccupancyMap) -> [Vec<Point>; 4] {
    let (w, h) = (map.columns as f64, map.rows as f64);
    let far = w + h + 10.0 / map.resolution;
    [
        rectangle(map, Point::new(-far, -far), Point::new(0.0, h + far)),
        rectangle(map, Point::new(w, -far), Point::new(w + far, h + far)),
        rectangle(map, Point::new(-far, -far), Point::new(w + far, 0.0)),
        rectangle(map, Point::new(-far, h), Point::new(w + far, h + far)),
    ]
}

fn rectangle(map: &OccupancyMap, low: Point, high: Point) -> Vec<Point> {
    [
        low,
        Point::new(high.x, low.y),
        high,
        Point::new(low.x, high.y),
    ]
    .map(|c| map.from_cells(c))
    .to_vec()
}

fn has_free_neighbor(map: &OccupancyMap, column: usize, row: usize) -> bool {
    let (column, row) = (column as i64, row as i64);
    (row - 1..=row + 1).any(|r| (column - 1..=column + 1).any(|c| !map.is_blocked(c, r)))
}

/// Number of blocked cells left of and below each corner, so that any rectangle is counted in constant time.
struct BlockedCounts {
    columns: usize,
    rows: usize,
    sums: Vec<u32>,
}

impl BlockedCounts {
    fn new(map: &OccupancyMap) -> Self {
        let stride = map.columns + 1;
        let mut sums = vec![0; stride * (map.rows + 1)];
        for row in 0..map.rows {
            let mut line = 0;
            for column in 0..map.columns {
                line += u32::from(map.blocked[row * map.columns + column]);
                sums[(row + 1) * stride + column + 1] = sums[row * stride + column + 1] + line;
            }
        }
        Self {
            columns: map.columns,
            rows: map.rows,
            sums,
        }
    }

    fn is_full(&self, low: (usize, usize), high: (usize, usize)) -> bool {
        let at = |column: usize, row: usize| self.sums[row * (self.columns + 1) + column];
        let blocked = at(high.0, high.1) + at(low.0, low.1) - at(low.0, high.1) - at(high.0, low.1);
        blocked as usize == (high.0 - low.0) * (high.1 - low.1)
    }

    /// The rectangles that grow from a blocked cell sideways first and upwards first.
    fn maximal_around(&self, (column, row): (usize, usize)) -> [CellRange; 2] {
        let cell = CellRange {
            low: (column, row),
            high: (column + 1, row + 1),
        };
        [
            self.grown_vertically(self.grown_sideways(cell)),
            self.grown_sideways(self.grown_vertically(cell)),
        ]
    }

    fn grown_sideways(&self, mut r: CellRange) -> CellRange {
        let least = r.low.0.saturating_sub(REACH);
        let most = (r.high.0 + REACH).min(self.columns);
        while r.low.0 > least && self.is_full((r.low.0 - 1, r.low.1), (r.low.0, r.high.1)) {
            r.low.0 -= 1;
        }
        while r.high.0 < most && self.is_full((r.high.0, r.low.1), (r.high.0 + 1, r.high.1)) {
            r.high.0 += 1;
        }
        r
    }

    fn grown_vertically(&self, mut r: CellRange) -> CellRange {
        let least = r.low.1.saturating_sub(REACH);
        let most = (r.high.1 + REACH).min(self.rows);
        while r.low.1 > least && self.is_full((r.low.0, r.low.1 - 1), (r.high.0, r.low.1)) {
            r.low.1 -= 1;
        }
        while r.high.1 < most && self.is_full((r.low.0, r.high.1), (r.high.0, r.high.1 + 1)) {
            r.high.1 += 1;
        }
        r
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pairtrawl_geometry::Pose;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn rectangles_hold_blocked_cells_only_and_every_cell_at_the_boundary(
            columns in 1_usize..16, rows in 1_usize..16, noise in prop::collection::vec(0.0..1.0_f64, 256), density in 0.1..0.95_f64,
        ) {
            let blocked: Vec<bool> = (0..columns * rows).map(|i| noise[i] < density).collect();
            let map = OccupancyMap { origin: Pose::default(), resolution: 0.1, columns, rows, blocked };
            // Apart from the code under test: some cell inside the map is free and at most one column and one row away.
            let touches_free = |column: usize, row: usize| (0..columns * rows)
                .any(|i| !map.blocked[i] && (i % columns).abs_diff(column) <= 1 && (i / columns).abs_diff(row) <= 1);
            let rectangles = blocked_rectangles(&map);
            for row in 0..rows {
                for column in 0..columns {
                    let covered = rectangles.iter().any(|r| (r.low.0..r.high.0).contains(&column) && (r.low.1..r.high.1).contains(&row));
                    if !map.is_blocked(column as i64, row as i64) {
                        prop_assert!(!covered);
                    } else if touches_free(column, row) {
                        prop_assert!(covered);
                    }
                }
            }
        }
    }
}
