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
