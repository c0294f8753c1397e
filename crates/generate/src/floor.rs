use crate::random::Random;
use pairtrawl_certificate::Clearance;
use pairtrawl_geometry::{Bounds, Hull, Point, Pose};
use pairtrawl_model::{OccupancyMap, Scene};
use std::borrow::Cow;
use std::collections::VecDeque;

/// Where the pair can come: the largest connected region of cells around whose center so much is free that the pair, as
/// narrow as it can make itself, passes. Two robots that touch, at the greatest skew, are (1 + cos max_skew) 2 radius
/// wide; half of that is what a cell's center keeps from obstacles. Cells that share an edge are connected.
///
/// Nothing else is asked: whether a planner finds its way is not looked at.
pub(crate) struct Floor<'a> {
    scene: &'a Scene,
    clearance: Clearance<'a>,
    grid: Grid<'a>,
    /// What a cell's center keeps from obstacles, m.
    keep: f64,
    /// Whether the region holds a cell; index `row * columns + column`.
    inside: Vec<bool>,
    /// The cells of the region, ascending.
    cells: Vec<usize>,
}

/// Cells of the map, or of the rectangle.
struct Grid<'a> {
    map: Cow<'a, OccupancyMap>,
}

impl<'a> Grid<'a> {
    /// The cells of a scene's map, or the grid over its rectangle.
    fn of(scene: &'a Scene) -> Self {
        let map = scene.map.as_ref().map(Cow::Borrowed);
        let map = map.unwrap_or_else(|| {
            let (size, resolution) = (scene.area.max - scene.area.min, scene.area.resolution);
            let count = |length: f64| (length / resolution - 1e-6).ceil().max(1.0) as usize;
            let (columns, rows) = (count(size.x), count(size.y));
            Cow::Owned(OccupancyMap {
                origin: Pose::at(scene.area.min, 0.0),
                resolution,
                columns,
                rows,
                blocked: vec![false; columns * rows],
            })
        });
        Self { map }
    }

    /// The point of a cell at shares of its edges, map frame.
    fn point(&self, cell: usize, along: f64, across: f64) -> Point {
        let (column, row) = (cell % self.map.columns, cell / self.map.columns);
        self.map
            .from_cells(Point::new(column as f64 + along, row as f64 + across))
    }

    fn center(&self, cell: usize) -> Point {
        self.point(cell, 0.5, 0.5)
    }

    fn neighbors(&self, cell: usize) -> impl Iterator<Item = usize> {
        let (columns, rows) = (self.map.columns, self.map.rows);
        let (column, row) = (cell % columns, cell / columns);
        [
            (column > 0).then(|| cell - 1),
            (column + 1 < columns).then_some(cell + 1),
            (row > 0).then(|| cell - columns),
            (row + 1 < rows).then_some(cell + columns),
        ]
        .into_iter()
        .flatten()
    }
}

impl<'a> Floor<'a> {
    /// The floor of a scene, whose objects, start and end are not looked at; `None` when the pair fits nowhere.
    pub(crate) fn of(scene: &'a Scene) -> Option<Self> {
        let clearance = Clearance::new(scene)?;
        let grid = Grid::of(scene);
        let keep = scene.robot.radius * (1.0 + libm::cos(scene.planner.max_skew));
        let wide: Vec<bool> = (0..grid.map.blocked.len())
            .map(|cell| !grid.map.blocked[cell] && clearance.is_free(grid.center(cell), keep))
            .collect();
        let cells = largest_region(&grid, &wide);
        let mut inside = vec![false; wide.len()];
        for &cell in &cells {
            inside[cell] = true;
        }
        (!cells.is_empty()).then_some(Self {
            scene,
            clearance,
            grid,
            keep,
            inside,
            cells,
        })
    }

    /// A point of the region, uniform over its area.
    pub(crate) fn draw(&self, random: &mut Random) -> Point {
        let cell = self.cells[random.index(0, self.cells.len())];
        self.grid.point(cell, random.unit(), random.unit())
    }

    /// A point uniform over all cells that are not blocked, in the region or not.
    pub(crate) fn draw_free(&self, random: &mut Random) -> Point {
        loop {
            let cell = random.index(0, self.inside.len());
            if !self.grid.map.blocked[cell] {
                return self.grid.point(cell, random.unit(), random.unit());
            }
        }
    }

    /// True when a point lies in a cell of the region.
    pub(crate) fn holds(&self, p: Point) -> bool {
        let c = self.grid.map.to_cells(p);
        let map = &self.grid.map;
        c.x >= 0.0
            && c.y >= 0.0
            && c.x < map.columns as f64
            && c.y < map.rows as f64
            && self.inside[c.y as usize * map.columns + c.x as usize]
    }

    /// True when a point lies in the free disc around a cell of the region: nothing stands between it and the region.
    pub(crate) fn touches(&self, p: Point) -> bool {
        let c = self.grid.map.to_cells(p);
        let map = &self.grid.map;
        let reach = (self.keep / map.resolution).ceil() as i64;
        let (column, row) = (c.x.floor() as i64, c.y.floor() as i64);
        let clip = |v: i64, n: usize| v.clamp(0, n as i64) as usize;
        (clip(row - reach, map.rows)..clip(row + reach + 1, map.rows)).any(|r| {
            (clip(column - reach, map.columns)..clip(column + reach + 1, map.columns)).any(|k| {
                let cell = r * map.columns + k;
                self.inside[cell] && self.grid.center(cell).distance(p) <= self.keep
            })
        })
    }

    /// True when everything within `keep` of a point is free and inside the area, m.
    pub(crate) fn is_free(&self, p: Point, keep: f64) -> bool {
        let area = &self.scene.area;
        let to_edge = (p.x - area.min.x)
            .min(area.max.x - p.x)
            .min(p.y - area.min.y)
            .min(area.max.y - p.y);
        to_edge >= keep && self.clearance.is_free(p, keep)
    }

    /// True when a convex region keeps this distance from obstacles, m, and its corners lie inside the area.
    pub(crate) fn has_room(&self, corners: &[Point], keep: f64) -> bool {
        let area = &self.scene.area;
        let bounds = Bounds {
            min: area.min,
            max: area.max,
        };
        let inside = corners.iter().all(|p| bounds.contains(*p));
        let distance = || self.clearance.distance(&Hull::of(corners));
        inside && distance().is_none_or(|distance| distance >= keep)
    }
}

/// The cells of the largest connected region, ascending; the one with the first cell among equals.
fn largest_region(grid: &Grid<'_>, wide: &[bool]) -> Vec<usize> {
    let mut seen = vec![false; wide.len()];
    let mut largest = Vec::new();
    for first in 0..wide.len() {
        if !wide[first] || std::mem::replace(&mut seen[first], true) {
            continue;
        }
        let mut region = vec![first];
        let mut open = VecDeque::from([first]);
        while let Some(cell) = open.pop_front() {
            for next in grid.neighbors(cell) {
                if wide[next] && !std::mem::replace(&mut seen[next], true) {
                    region.push(next);
                    open.push_back(next);
                }
            }
        }
        if region.len() > largest.len() {
            largest = region;
        }
    }
    largest.sort_unstable();
    largest
}
