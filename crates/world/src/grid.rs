use crate::error::WorldError;
use crate::pieces::footprint_outline;
use crate::shape::{moved, overlaps_unit_square};
use pairtrawl_geometry::{Bounds, Convex, Point, Pose};
use pairtrawl_model::{Area, OccupancyMap, Scene};

/// The greatest number of cells of an occupancy grid: 4096 x 4096.
pub const MAX_CELLS: usize = 1 << 24;

/// The grid goes on this far around the area: robots stay inside of the area, their net and their corners need not.
pub const REACH: f64 = 1.0;

/// A piece that overlaps a cell by less than this part of its edge only touches it.
const TOUCH: f64 = 1e-6;

/// What a cell holds; the numbers are those of the paper's Map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Cell {
    /// Nothing.
    Free = 0,
    /// Any part of an obstacle.
    Obstacle = 1,
    /// Any part of an object's footprint, and no obstacle.
    Object = 2,
}

/// The paper's Map: square cells over the area and [`REACH`] around it. Turned with the ROS map, when the scene has one,
/// and then on its cells.
#[derive(Clone, Debug, PartialEq)]
pub struct OccupancyGrid {
    /// Pose of the outer corner of cell (column 0, row 0), map frame.
    pub origin: Pose,
    /// Edge length of a cell.
    pub resolution: f64,
    /// Cells along the grid's x axis.
    pub columns: usize,
    /// Cells along the grid's y axis.
    pub rows: usize,
    /// Index `row * columns + column`.
    pub cells: Vec<Cell>,
    /// The unit vector along the rows, map frame.
    axis: Point,
    area: Area,
    outside: Cell,
}

/// Which pieces overlap which cells.
pub(crate) struct Owners {
    /// `first[cell]..first[cell + 1]` is the range in `pieces`.
    first: Vec<u32>,
    pieces: Vec<u32>,
}

impl Owners {
    pub(crate) fn of(&self, cell: usize) -> &[u32] {
        &self.pieces[self.first[cell] as usize..self.first[cell + 1] as usize]
    }
}

impl OccupancyGrid {
    /// Rasterizes the scene. A cell that any obstacle overlaps is an obstacle, so no wall is too thin to be seen.
    pub(crate) fn new(scene: &Scene, pieces: &[Convex]) -> Result<(Self, Owners), WorldError> {
        let mut grid = Self::empty(&scene.area, scene.map.as_ref())?;
        let owners = grid.mark_pieces(pieces);
        if let Some(map) = &scene.map {
            let border = border_cells(map.resolution) as i64;
            for row in 0..grid.rows {
                for column in 0..grid.columns {
                    if map.is_blocked(column as i64 - border, row as i64 - border) {
                        grid.cells[row * grid.columns + column] = Cell::Obstacle;
                    }
                }
            }
        }
        for object in &scene.objects {
            let footprint = footprint_outline(object);
            grid.for_each_overlapped(&footprint, |cells, i| {
                if cells[i] == Cell::Free {
                    cells[i] = Cell::Object;
                }
            });
        }
        Ok((grid, owners))
    }

    /// What lies at a point; far from the area nothing, and obstacle outside a ROS map.
    pub fn cell_at(&self, p: Point) -> Cell {
        self.locate(p).map_or(self.outside, |(column, row)| {
            self.cells[row * self.columns + column]
        })
    }

    /// True when a robot's center or an object may be here as far as the scene's rectangle is concerned (border included).
    pub fn is_inside_area(&self, p: Point) -> bool {
        let Area { min, max, .. } = self.area;
        p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y
    }

    /// Column and row of the cell that holds a point, `None` outside the grid.
    pub fn locate(&self, p: Point) -> Option<(usize, usize)> {
        let c = self.to_cells(p);
        let inside =
            c.x >= 0.0 && c.y >= 0.0 && c.x < self.columns as f64 && c.y < self.rows as f64;
        inside.then_some((c.x as usize, c.y as usize))
    }

    /// Center of a cell, map frame.
    pub fn center(&self, column: usize, row: usize) -> Point {
        let c = Point::new(column as f64 + 0.5, row as f64 + 0.5) * self.resolution;
        self.origin.position() + turned(c, self.axis)
    }

    /// A map-frame point in cells: the integer parts are column and row.
    pub fn to_cells(&self, p: Point) -> Point {
        let back = Point::new(self.axis.x, -self.axis.y);
        turned(p - self.origin.position(), back) / self.resolution
    }

    /// The unit vector along the rows, map frame.
    pub(crate) fn axis(&self) -> Point {
        self.axis
    }

    fn empty(area: &Area, map: Option<&OccupancyMap>) -> Result<Self, WorldError> {
        let (corner, heading, resolution, width, height) = match map {
            Some(map) => {
                let size = Point::new(map.columns as f64, map.rows as f64) * map.resolution;
                (
                    map.origin.position(),
                    map.origin.heading,
                    map.resolution,
                    size.x,
                    size.y,
                )
            }
            None => (
                area.min,
                0.0,
                area.resolution,
                area.max.x - area.min.x,
                area.max.y - area.min.y,
            ),
        };
        let (columns, rows) = grid_size(width, height, resolution)?;
        let border = border_cells(resolution) as f64 * resolution;
        let axis = Point::unit(heading);
        let origin = corner - turned(Point::new(border, border), axis);
        Ok(Self {
            origin: Pose::at(origin, heading),
            resolution,
            columns,
            rows,
            cells: vec![Cell::Free; columns * rows],
            axis,
            area: *area,
            outside: if map.is_some() {
                Cell::Obstacle
            } else {
                Cell::Free
            },
        })
    }

    fn mark_pieces(&mut self, pieces: &[Convex]) -> Owners {
        let mut pairs: Vec<(u32, u32)> = Vec::new();
        for (k, piece) in pieces.iter().enumerate() {
            self.for_each_overlapped(piece, |cells, i| {
                cells[i] = Cell::Obstacle;
                pairs.push((i as u32, k as u32));
            });
        }
        pairs.sort_unstable();
        let mut first = vec![0_u32; self.cells.len() + 1];
        for &(cell, _) in &pairs {
            first[cell as usize + 1] += 1;
        }
        for i in 1..first.len() {
            first[i] += first[i - 1];
        }
        Owners {
            first,
            pieces: pairs.into_iter().map(|(_, piece)| piece).collect(),
        }
    }

    fn for_each_overlapped(&mut self, piece: &Convex, mut act: impl FnMut(&mut [Cell], usize)) {
        let piece = moved(piece, 1.0 / self.resolution, |p| self.to_cells(p));
        let Bounds { min: lo, max: hi } = piece.bounds();
        let clip = |x: f64, n: usize| x.clamp(0.0, n as f64) as usize;
        for row in clip(lo.y.floor(), self.rows)..clip(hi.y.ceil(), self.rows) {
            for column in clip(lo.x.floor(), self.columns)..clip(hi.x.ceil(), self.columns) {
                if overlaps_unit_square(&piece, Point::new(column as f64, row as f64), TOUCH) {
                    act(&mut self.cells, row * self.columns + column);
                }
            }
        }
    }
}

/// Columns and rows of the grid over an area of this size, border included.
///
/// # Errors
/// When a size is not positive or the grid would have more than [`MAX_CELLS`] cells.
pub fn grid_size(width: f64, height: f64, resolution: f64) -> Result<(usize, usize), WorldError> {
    for (name, value) in [
        ("the grid's resolution", resolution),
        ("the area's width", width),
        ("the area's height", height),
    ] {
        if !(value.is_finite() && value > 0.0) {
            return Err(WorldError::NotPositive { name, value });
        }
    }
    let border = 2.0 * (REACH / resolution).ceil();
    // A hair less than the quotient, so that rounding does not add a cell to a size that is a multiple of the resolution.
    let count = |size: f64| (size / resolution - 1e-6).ceil().max(1.0) + border;
    let (columns, rows) = (count(width), count(height));
    if columns * rows > MAX_CELLS as f64 {
        let cells = columns * rows;
        return Err(WorldError::TooManyCells {
            cells,
            width,
            height,
            resolution,
            bound: MAX_CELLS,
        });
    }
    Ok((columns as usize, rows as usize))
}

fn border_cells(resolution: f64) -> usize {
    (REACH / resolution).ceil() as usize
}

/// v turned by the angle of a unit vector.
fn turned(v: Point, axis: Point) -> Point {
    Point::new(axis.x * v.x - axis.y * v.y, axis.y * v.x + axis.x * v.y)
}
