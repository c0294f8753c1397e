use super::carried::{Carried, spread};
use super::cell::Cell;
use super::proof::GridEvidence;
use super::things::Things;
use pairtrawl_geometry::{Bounds, Point};
use pairtrawl_model::{Scene, Side};

/// The coarsest cells, in units of the length scale.
const COARSEST: f64 = 0.4;
/// Cells are not made finer than this, in units of the length scale ...
const FINEST: f64 = 0.005;
/// ... nor more than this many: what is still open then stays unproven.
const MOST_CELLS: usize = 2_000_000;
/// Below this diagonal a robot that stands in a mixed cell is taken to get to its neighbors, in units
/// of the length scale.
const FINE: f64 = 0.08;
/// Distances this close to the radius leave a cell undecided, m: rounding and the tolerance of the claims.
const CLOSE: f64 = 1e-6;

/// The area, cut into equal cells that fill it exactly, and as many cells around it as the largest circle of a robot may
/// leave it by.
pub(super) struct FreeSpace {
    min: Point,
    size: Point,
    columns: usize,
    rows: usize,
    cells: Vec<Cell>,
    /// The largest circle of a robot, if its center is off the axle.
    carried: Option<Carried>,
    /// The scene's length scale, m.
    scale: f64,
}

/// A robot with the places where it starts and ends.
#[derive(Clone, Copy)]
pub(super) struct Run {
    pub(super) side: Side,
    pub(super) name: &'static str,
    pub(super) start: Point,
    pub(super) end: Point,
}

/// Where each robot may get (over-estimated) and surely gets (under-estimated).
pub(super) struct Reached {
    /// Left, then right robot.
    pub(super) may: [Vec<bool>; 2],
    pub(super) surely: [Vec<bool>; 2],
    /// What is known of the way of the largest circle, if that is another than the axle center's.
    ways: [Way; 2],
}

/// What is known of a way from start to end.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    /// There is none.
    Cut,
    /// There may be one.
    Open,
    /// There surely is one.
    Sure,
}

/// Both robots of a scene.
pub(super) fn runs(scene: &Scene) -> [Run; 2] {
    let run = |side, name, start: pairtrawl_geometry::Pose, end: pairtrawl_geometry::Pose| Run {
        side,
        name,
        start: start.position(),
        end: end.position(),
    };
    [
        run(Side::Left, "left robot", scene.start.left, scene.end.left),
        run(
            Side::Right,
            "right robot",
            scene.start.right,
            scene.end.right,
        ),
    ]
}

impl FreeSpace {
    /// The coarsest grid.
    pub(super) fn new(things: &Things<'_>) -> Self {
        let area = things.scene.area;
        let extent = area.max - area.min;
        let longest = extent.x.max(extent.y);
        // Areas too large for the coarsest cells get larger ones.
        let cell = (COARSEST * things.scale).max(longest / (MOST_CELLS as f64).sqrt());
        let count = |length: f64| ((length / cell).ceil() as usize).max(1);
        let (columns, rows) = (count(extent.x), count(extent.y));
        let size = Point::new(extent.x / columns as f64, extent.y / rows as f64);
        // Whole cells around the area, so that they halve as those within do.
        let beyond = |size: f64| (things.largest.offset() / size).ceil() as usize;
        let (aside, above) = (beyond(size.x), beyond(size.y));
        let is_within = |i: usize| {
            let (column, row) = (i % (columns + 2 * aside), i / (columns + 2 * aside));
            (aside..aside + columns).contains(&column) && (above..above + rows).contains(&row)
        };
        let (all_columns, all_rows) = (columns + 2 * aside, rows + 2 * above);
        // Axle centers stay in the area.
        let cell = |i: usize| match is_within(i) {
            true => Cell::Mixed,
            false => Cell::Blocked,
        };
        let mut space = Self {
            min: area.min - Point::new(aside as f64 * size.x, above as f64 * size.y),
            size,
            columns: all_columns,
            rows: all_rows,
            cells: (0..all_columns * all_rows).map(cell).collect(),
            carried: Carried::new(things, all_columns * all_rows),
            scale: things.scale,
        };
        space.classify(things);
        space
    }

    /// The grid with cells of half the size; `None` at the limit.
    pub(super) fn refined(&self, things: &Things<'_>) -> Option<Self> {
        let (columns, rows, size) = (2 * self.columns, 2 * self.rows, self.size * 0.5);
        if size.x.max(size.y) < FINEST * things.scale || columns * rows > MOST_CELLS {
            return None;
        }
        let parent = |i: usize| (i / columns / 2) * self.columns + (i % columns) / 2;
        let cells = (0..columns * rows).map(|i| self.cells[parent(i)]);
        let carried = self.carried.as_ref();
        let mut space = Self {
            min: self.min,
            size,
            columns,
            rows,
            cells: cells.collect(),
            carried: carried.map(|c| c.refined(columns * rows, parent)),
            scale: self.scale,
        };
        space.classify(things);
        Some(space)
    }

    /// Decides the mixed cells as far as the distance at their centers tells.
    fn classify(&mut self, things: &Things<'_>) {
        let half = 0.5 * self.size.norm();
        let scene_area = things.scene.area;
        let area = Bounds {
            min: scene_area.min,
            max: scene_area.max,
        };
        let decided = |cells: &[Cell], radius: f64, offset: f64| -> Vec<Cell> {
            let decide = |(i, &cell): (usize, &Cell)| {
                if cell != Cell::Mixed {
                    return cell;
                }
                // Farther out no center gets whose axle stays in the area.
                if offset > 0.0 && self.bounds(i).distance(&area) > offset + CLOSE {
                    return Cell::Blocked;
                }
                match things.nearest(self.center(i), radius + half + CLOSE, None) {
                    None => Cell::Free,
                    Some((distance, _)) if distance + half < radius - CLOSE => Cell::Blocked,
                    Some(_) => Cell::Mixed,
                }
            };
            cells.iter().enumerate().map(decide).collect()
        };
        let cells = decided(&self.cells, things.keep, 0.0);
        let carried = self.carried.as_ref().map(|carried| Carried {
            cells: decided(
                &carried.cells,
                carried.circle.radius,
                carried.circle.offset(),
            ),
            ..*carried
        });
        (self.cells, self.carried) = (cells, carried);
    }

    pub(super) fn center(&self, i: usize) -> Point {
        let at = |k: usize| k as f64 + 0.5;
        self.min
            + Point::new(
                at(i % self.columns) * self.size.x,
                at(i / self.columns) * self.size.y,
            )
    }

    pub(super) fn bounds(&self, i: usize) -> Bounds {
        let half = self.size * 0.5;
        Bounds {
            min: self.center(i) - half,
            max: self.center(i) + half,
        }
    }

    /// The cells that share a side or a corner with this one, and itself.
    pub(super) fn neighbors(&self, i: usize) -> impl Iterator<Item = usize> + use<> {
        let (column, row, columns) = (i % self.columns, i / self.columns, self.columns);
        let (right, top) = (
            (column + 1).min(self.columns - 1),
            (row + 1).min(self.rows - 1),
        );
        (row.saturating_sub(1)..=top)
            .flat_map(move |r| (column.saturating_sub(1)..=right).map(move |c| r * columns + c))
    }

    pub(super) fn is_at_edge(&self, i: usize) -> bool {
        let (column, row) = (i % self.columns, i / self.columns);
        column == 0 || row == 0 || column + 1 == self.columns || row + 1 == self.rows
    }

    /// Columns and rows.
    pub(super) fn shape(&self) -> (usize, usize) {
        (self.columns, self.rows)
    }

    /// The grid as the evidence of a proof, with the cells that a robot may reach.
    pub(super) fn evidence(&self, may: &[bool]) -> GridEvidence {
        let blocked = self.cells.iter().filter(|cell| **cell == Cell::Blocked);
        GridEvidence {
            columns: self.columns,
            rows: self.rows,
            blocked: blocked.count(),
            reached: may.iter().filter(|may| **may).count(),
        }
    }

    /// Number of cells.
    pub(super) fn len(&self) -> usize {
        self.cells.len()
    }

    /// Size of a cell, m.
    pub(super) fn size(&self) -> Point {
        self.size
    }

    /// The cell of a point; that nearest to it for a point outside the area.
    pub(super) fn index(&self, p: Point) -> usize {
        let clamp = |v: f64, n: usize| (v.max(0.0) as usize).min(n - 1);
        let d = p - self.min;
        clamp(d.y / self.size.y, self.rows) * self.columns + clamp(d.x / self.size.x, self.columns)
    }

    /// The cells that a box meets.
    pub(super) fn cells_near(&self, near: &Bounds) -> impl Iterator<Item = usize> + '_ {
        let (low, high) = (self.index(near.min), self.index(near.max));
        let columns = low % self.columns..=high % self.columns;
        (low / self.columns..=high / self.columns).flat_map(move |row| {
            columns
                .clone()
                .map(move |column| row * self.columns + column)
        })
    }

    /// The cells joined to `from` by cells that pass; neighbors share a corner or, if `by_sides`, a side.
    fn flood(
        &self,
        from: impl Iterator<Item = usize>,
        by_sides: bool,
        passes: impl Fn(usize) -> bool,
    ) -> Vec<bool> {
        let mut reached = vec![false; self.cells.len()];
        let mut front: Vec<usize> = from.filter(|&i| passes(i)).collect();
        front.iter().for_each(|&i| reached[i] = true);
        while let Some(i) = front.pop() {
            let (column, row) = (i % self.columns, i / self.columns);
            for j in self.neighbors(i) {
                let side = j % self.columns == column || j / self.columns == row;
                if (!by_sides || side) && !reached[j] && passes(j) {
                    reached[j] = true;
                    front.push(j);
                }
            }
        }
        reached
    }

    /// The cell of a point and, on fine grids, those around it: a robot that starts or ends beside an obstacle stands in
    /// a mixed cell on every grid. What is sure only ends the search, so that this cannot make a proof false.
    fn at(&self, p: Point) -> impl Iterator<Item = usize> + use<> {
        let own = self.index(p);
        let fine = self.size.norm() < FINE * self.scale;
        self.neighbors(own).filter(move |&i| fine || i == own)
    }

    /// True when sure cells join two places.
    fn is_joined(&self, [from, to]: [Point; 2], cells: &[Cell]) -> bool {
        let surely = self.flood(self.at(from), true, |i| cells[i] == Cell::Free);
        self.at(to).any(|i| surely[i])
    }

    /// Where the robots get from their starts; `None` when one of their ends lies in a surely blocked cell, which makes
    /// the scene bad input.
    pub(super) fn reach(&self, scene: &Scene) -> Option<Reached> {
        let runs = runs(scene);
        let mut ways = [Way::Open; 2];
        if self.carried.is_none() {
            ways = [Way::Sure; 2];
        }
        let mut near = [None, None];
        if let Some(carried) = &self.carried {
            for run in runs {
                let ends = [scene.start, scene.end].map(|pair| pair.robot(run.side));
                let [start, end] = ends.map(|pose| self.index(carried.circle.center_at(pose)));
                let passes = |i: usize| carried.cells[i] != Cell::Blocked;
                if !(passes(start) && passes(end)) {
                    return None;
                }
                let may = self.flood(std::iter::once(start), false, passes);
                let side = run.side.index();
                ways[side] = if may[end] { Way::Open } else { Way::Cut };
                if self.is_joined(
                    ends.map(|pose| carried.circle.center_at(pose)),
                    &carried.cells,
                ) {
                    ways[side] = Way::Sure;
                }
                let reach = [self.size.x, self.size.y]
                    .map(|size| (carried.circle.offset() / size).ceil() as usize + 1);
                near[side] = Some(spread(&may, self.columns, reach));
            }
        }
        let blocked = |p: Point| self.cells[self.index(p)] == Cell::Blocked;
        if runs
            .iter()
            .any(|run| blocked(run.start) || blocked(run.end))
        {
            return None;
        }
        Some(Reached {
            may: runs.map(|run| {
                let own = std::iter::once(self.index(run.start));
                let near = &near[run.side.index()];
                self.flood(own, false, |i| {
                    self.cells[i] != Cell::Blocked && near.as_ref().is_none_or(|near| near[i])
                })
            }),
            surely: runs
                .map(|run| self.flood(self.at(run.start), true, |i| self.cells[i] == Cell::Free)),
            ways,
        })
    }
}

impl Reached {
    /// A robot that cannot get from its start to its end.
    pub(super) fn robot_without_way(&self, space: &FreeSpace, scene: &Scene) -> Option<Run> {
        let both = runs(scene).into_iter().zip(&self.may);
        both.into_iter()
            .find(|(run, may)| {
                self.ways[run.side.index()] == Way::Cut || !may[space.index(run.end)]
            })
            .map(|(run, _)| run)
    }

    /// True when both robots surely get to their ends, each on its own.
    pub(super) fn has_sure_way(&self, space: &FreeSpace, scene: &Scene) -> bool {
        self.ways == [Way::Sure; 2]
            && runs(scene)
                .into_iter()
                .zip(&self.surely)
                .all(|(run, surely)| space.at(run.end).any(|i| surely[i]))
    }
}
