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

/// Maximal rectangles of blocked cells (they may overlap) that cover every blocked cell with a free one among its eight
/// neighbors. Cells deeper inside bound nothing and may stay uncovered, so the boundary of the union is exactly the
/// boundary between blocked and free cells.
pub fn blocked_rectangles(map: &OccupancyMap) -> Vec<CellRange> {
    let counts = BlockedCounts::new(map);
    let mut covered = vec![false; map.columns * map.rows];
    let mut rectangles = Vec::new();
    for row in 0..map.rows {
        for column in 0..map.columns {
            if !covered[row * map.columns + column]
                && map.is_blocked(column as i64, row as i64)
                && has_free_neighbor(map, column, row)
            {
                let rectangle = counts.largest_around(column, row);
                for r in rectangle.low.1..rectangle.high.1 {
                    covered[r * map.columns + rectangle.low.0..r * map.columns + rectangle.high.0]
                        .fill(true);
                }
                rectangles.push(rectangle);
            }
        }
    }
    rectangles
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

    /// The larger of the maximal rectangles that grow from a blocked cell sideways first and upwards first.
    fn largest_around(&self, column: usize, row: usize) -> CellRange {
        let cell = CellRange {
            low: (column, row),
            high: (column + 1, row + 1),
        };
        let sideways = self.grown_vertically(self.grown_sideways(cell));
        let upwards = self.grown_sideways(self.grown_vertically(cell));
        let size = |r: &CellRange| (r.high.0 - r.low.0) * (r.high.1 - r.low.1);
        if size(&upwards) > size(&sideways) {
            upwards
        } else {
            sideways
        }
    }

    fn grown_sideways(&self, mut r: CellRange) -> CellRange {
        while r.low.0 > 0 && self.is_full((r.low.0 - 1, r.low.1), (r.low.0, r.high.1)) {
            r.low.0 -= 1;
        }
        while r.high.0 < self.columns && self.is_full((r.high.0, r.low.1), (r.high.0 + 1, r.high.1))
        {
            r.high.0 += 1;
        }
        r
    }

    fn grown_vertically(&self, mut r: CellRange) -> CellRange {
        while r.low.1 > 0 && self.is_full((r.low.0, r.low.1 - 1), (r.high.0, r.low.1)) {
            r.low.1 -= 1;
        }
        while r.high.1 < self.rows && self.is_full((r.low.0, r.high.1), (r.high.0, r.high.1 + 1)) {
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
            let rectangles = blocked_rectangles(&map);
            for row in 0..rows {
                for column in 0..columns {
                    let covered = rectangles.iter().any(|r| (r.low.0..r.high.0).contains(&column) && (r.low.1..r.high.1).contains(&row));
                    if !map.is_blocked(column as i64, row as i64) {
                        prop_assert!(!covered);
                    } else if has_free_neighbor(&map, column, row) {
                        prop_assert!(covered);
                    }
                }
            }
        }
    }
}
