use pairtrawl_geometry::{Bounds, Gap, Hull, Point, Polygon};
use pairtrawl_model::OccupancyMap;

/// The blocked cells of a map as runs along rows and along columns, in the map's own frame (m from its corner).
///
/// Cells are closed squares. A hull without area may lie on the border of two blocked cells and be inside neither; the
/// two families cover such borders: what lies between two rows is inside a run along a column, and the reverse.
pub(crate) struct MapRuns<'a> {
    map: &'a OccupancyMap,
    /// Per row: blocked columns as half-open ranges, ascending.
    rows: Vec<Vec<(usize, usize)>>,
    /// Per column: blocked rows as half-open ranges, ascending.
    columns: Vec<Vec<(usize, usize)>>,
}

/// What of the map is nearest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MapPart {
    Cell { column: usize, row: usize },
    Outside,
}

impl<'a> MapRuns<'a> {
    /// Reads the runs off the map, or says what is malformed.
    pub(crate) fn new(map: &'a OccupancyMap) -> Result<Self, String> {
        let (columns, rows) = (map.columns, map.rows);
        if columns == 0 || rows == 0 || columns.checked_mul(rows) != Some(map.blocked.len()) {
            return Err(format!(
                "the map has {columns} x {rows} cells but data for {}",
                map.blocked.len()
            ));
        }
        if !(map.origin.is_finite() && map.resolution.is_finite() && map.resolution > 0.0) {
            return Err(format!(
                "the map's resolution {} m or its origin is not usable",
                map.resolution
            ));
        }
        let blocked = |column: usize, row: usize| map.blocked[row * columns + column];
        Ok(Self {
            map,
            rows: (0..rows)
                .map(|r| runs(columns, |c| blocked(c, r)))
                .collect(),
            columns: (0..columns)
                .map(|c| runs(rows, |r| blocked(c, r)))
                .collect(),
        })
    }

    /// The signed distance of a hull (map frame of the scene) to the nearest blocked cell or to the outside of the map,
    /// when it is below `bound`, with the place in the scene's frame.
    pub(crate) fn gap(&self, hull: &Hull, bound: f64) -> Option<(Gap, MapPart)> {
        let resolution = self.map.resolution;
        let vertices: Vec<Point> = hull
            .vertices()
            .iter()
            .map(|&v| self.map.to_cells(v) * resolution)
            .collect();
        let own = Hull::of(&vertices);
        let mut best = Best { bound, found: None };
        self.outside(&own, &mut best);
        self.visit(&own, &self.rows, false, &mut best);
        // Runs along columns matter only where the hull overlaps them.
        best.bound = best.bound.min(f64::MIN_POSITIVE);
        self.visit(&own, &self.columns, true, &mut best);
        best.found.map(|(gap, part)| {
            let place = self.map.from_cells(gap.place / resolution);
            (
                Gap {
                    distance: gap.distance,
                    place,
                },
                part,
            )
        })
    }

    /// The signed distance of a point to the nearest blocked cell or to the outside of the map when it is below `bound`.
    /// Inside a blocked cell it is minus the depth in the runs through it, which the true depth may exceed.
    pub(crate) fn distance(&self, p: Point, bound: f64) -> Option<(f64, MapPart)> {
        let r = self.map.resolution;
        let cell = self.map.to_cells(p);
        let own = cell * r;
        let mut best = Best { bound, found: None };
        let far = Point::new(self.map.columns as f64, self.map.rows as f64) * r;
        let edge = own.x.min(own.y).min(far.x - own.x).min(far.y - own.y);
        best.consider(
            Gap {
                distance: edge,
                place: own,
            },
            || MapPart::Outside,
        );
        if edge <= 0.0 {
            return best.found.map(|(gap, part)| (gap.distance, part));
        }
        let (column, row) = (cell.x as usize, cell.y as usize);
        if self.map.is_blocked(column as i64, row as i64) {
            let depth = run_depth(&self.rows[row], cell.x, cell.y).max(run_depth(
                &self.columns[column],
                cell.y,
                cell.x,
            ));
            best.consider(
                Gap {
                    distance: -depth * r,
                    place: own,
                },
                || MapPart::Cell { column, row },
            );
            return best.found.map(|(gap, part)| (gap.distance, part));
        }
        for k in 0.. {
            // Rows at k cells above and below: at least k - 1 cell heights away.
            if k as f64 - 1.0 > best.bound / r || k > self.map.rows {
                break;
            }
            let above = Some(row + k).filter(|&line| line < self.map.rows);
            let below = row.checked_sub(k).filter(|_| k > 0);
            for line in [above, below].into_iter().flatten() {
                let dy = (line as f64 - cell.y)
                    .max(cell.y - (line + 1) as f64)
                    .max(0.0);
                let runs = &self.rows[line];
                let next = runs.partition_point(|&(_, end)| end as f64 <= cell.x);
                for &(start, end) in &runs[next.saturating_sub(1)..runs.len().min(next + 1)] {
                    let dx = (start as f64 - cell.x).max(cell.x - end as f64).max(0.0);
                    let distance = Point::new(dx, dy).norm() * r;
                    best.consider(
                        Gap {
                            distance,
                            place: own,
                        },
                        || MapPart::Cell {
                            column: column.clamp(start, end - 1),
                            row: line,
                        },
                    );
                }
            }
        }
        best.found.map(|(gap, part)| (gap.distance, part))
    }

    /// The runs that meet a box of the scene's frame, as rectangles in that frame.
    pub(crate) fn rectangles(&self, near: &Bounds) -> Vec<Polygon> {
        let corners = [
            near.min,
            Point::new(near.max.x, near.min.y),
            near.max,
            Point::new(near.min.x, near.max.y),
        ];
        let cells = Bounds::of(&corners.map(|p| self.map.to_cells(p)));
        let mut out = Vec::new();
        for (lines, along_columns) in [(&self.rows, false), (&self.columns, true)] {
            let swap = |p: Point| {
                if along_columns {
                    Point::new(p.y, p.x)
                } else {
                    p
                }
            };
            let (min, max) = (swap(cells.min), swap(cells.max));
            let clamp = |v: f64| v.clamp(0.0, lines.len() as f64) as usize;
            let (low, high) = (clamp(min.y.floor()), clamp(max.y.ceil()));
            for (line, runs) in lines.iter().enumerate().take(high).skip(low) {
                for &(start, end) in runs {
                    if end as f64 >= min.x && start as f64 <= max.x {
                        let corner = |a: usize, b: usize| {
                            self.map.from_cells(swap(Point::new(a as f64, b as f64)))
                        };
                        let ring = [
                            (start, line),
                            (end, line),
                            (end, line + 1),
                            (start, line + 1),
                        ];
                        out.push(Polygon::new(ring.map(|(a, b)| corner(a, b)).to_vec()));
                    }
                }
            }
        }
        out
    }

    /// The outline of a cell in the scene's frame.
    pub(crate) fn cell(&self, column: usize, row: usize) -> Polygon {
        let corner = |x: usize, y: usize| self.map.from_cells(Point::new(x as f64, y as f64));
        let ring = [
            (column, row),
            (column + 1, row),
            (column + 1, row + 1),
            (column, row + 1),
        ];
        Polygon::new(ring.map(|(x, y)| corner(x, y)).to_vec())
    }

    /// The border of the map in the scene's frame.
    pub(crate) fn border(&self) -> Polygon {
        let corner = |x: usize, y: usize| self.map.from_cells(Point::new(x as f64, y as f64));
        let (w, h) = (self.map.columns, self.map.rows);
        Polygon::new(
            [(0, 0), (w, 0), (w, h), (0, h)]
                .map(|(x, y)| corner(x, y))
                .to_vec(),
        )
    }

    /// Everything beyond the map's four sides is blocked.
    fn outside(&self, hull: &Hull, best: &mut Best) {
        let far = Point::new(self.map.columns as f64, self.map.rows as f64) * self.map.resolution;
        for &v in hull.vertices() {
            let distance = v.x.min(v.y).min(far.x - v.x).min(far.y - v.y);
            best.consider(Gap { distance, place: v }, || MapPart::Outside);
        }
    }

    /// Compares the hull with the runs of one family near it.
    fn visit(
        &self,
        hull: &Hull,
        lines: &[Vec<(usize, usize)>],
        along_columns: bool,
        best: &mut Best,
    ) {
        let r = self.map.resolution;
        // Lines run along the first axis and are stacked along the second one.
        let swap = |p: Point| {
            if along_columns {
                Point::new(p.y, p.x)
            } else {
                p
            }
        };
        let reach = |best: &Best| {
            // One cell more guards against rounding at the borders of cells.
            let b = hull.bounds().grown(best.bound.max(0.0) + r);
            (swap(b.min) / r, swap(b.max) / r)
        };
        let (min, max) = reach(best);
        let clamp = |v: f64| v.clamp(0.0, lines.len() as f64) as usize;
        // From the middle of the hull outward, so that the bound shrinks early.
        let middle = clamp(0.5 * (swap(hull.bounds().min).y + swap(hull.bounds().max).y) / r);
        let (low, high) = (clamp(min.y.floor()), clamp(max.y.ceil()));
        let upward = (middle.clamp(low, high)..high).map(Some);
        let downward = (low..middle.clamp(low, high)).rev().map(Some);
        for line in interleave(upward, downward) {
            let (min, max) = reach(best);
            if ((line + 1) as f64) < min.y || (line as f64) > max.y {
                continue;
            }
            let runs = &lines[line];
            let first = runs.partition_point(|&(_, end)| (end as f64) < min.x);
            for &(start, end) in runs[first..]
                .iter()
                .take_while(|&&(start, _)| start as f64 <= max.x)
            {
                let corner = |a: usize, b: usize| swap(Point::new(a as f64, b as f64)) * r;
                let cells = Bounds {
                    min: corner(start, line),
                    max: corner(end, line + 1),
                };
                if cells.distance(&hull.bounds()) < best.bound.max(f64::MIN_POSITIVE) {
                    let gap = hull.gap_to_polygon(&Polygon::rectangle(cells.min, cells.max));
                    best.consider(gap, || {
                        let along =
                            (swap(gap.place).x / r).clamp(start as f64, (end - 1) as f64) as usize;
                        let (column, row) = if along_columns {
                            (line, along)
                        } else {
                            (along, line)
                        };
                        MapPart::Cell { column, row }
                    });
                }
            }
        }
    }
}

struct Best {
    bound: f64,
    found: Option<(Gap, MapPart)>,
}

impl Best {
    fn consider(&mut self, gap: Gap, part: impl FnOnce() -> MapPart) {
        if gap.distance < self.bound {
            self.bound = gap.distance;
            self.found = Some((gap, part()));
        }
    }
}

/// How deep a point (in cells, first coordinate along the line) lies in the run of a line that contains it.
fn run_depth(runs: &[(usize, usize)], along: f64, across: f64) -> f64 {
    let next = runs.partition_point(|&(_, end)| end as f64 <= along);
    runs.get(next).map_or(0.0, |&(start, end)| {
        let edge = across.fract().min(1.0 - across.fract());
        (along - start as f64)
            .min(end as f64 - along)
            .min(edge)
            .max(0.0)
    })
}

/// The half-open ranges of consecutive indices below `n` for which `blocked` holds.
fn runs(n: usize, blocked: impl Fn(usize) -> bool) -> Vec<(usize, usize)> {
    let mut out: Vec<(usize, usize)> = Vec::new();
    for i in (0..n).filter(|&i| blocked(i)) {
        match out.last_mut() {
            Some((_, end)) if *end == i => *end = i + 1,
            _ => out.push((i, i + 1)),
        }
    }
    out
}

/// Alternates between two sequences until both are used up.
fn interleave(
    mut a: impl Iterator<Item = Option<usize>>,
    mut b: impl Iterator<Item = Option<usize>>,
) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || match (a.next().flatten(), b.next().flatten()) {
        (None, None) => None,
        pair => Some(pair),
    })
    .flat_map(|(x, y)| [x, y].into_iter().flatten())
}
