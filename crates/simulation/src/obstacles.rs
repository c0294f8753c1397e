//! Fixed obstacles: boxes, discs, polygons in convex pieces, and the blocked cells of a map merged into rectangles.

use crate::SimulationError;
use pairtrawl_dynamics::Solid;
use pairtrawl_geometry::{Convex, Point, Polygon, Pose};
use pairtrawl_model::{Footprint, Obstacle, OccupancyMap, Scene};

/// Blocked cells farther than this from every free cell cannot be touched, in cells.
const SKIN: i64 = 2;
/// Width of the walls around a map, m.
const WALL: f64 = 1.0;

/// A fixed convex shape.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum FixedShape {
    Box {
        center: Point,
        half: Point,
        turn: f64,
    },
    Disc {
        center: Point,
        radius: f64,
    },
    /// Vertices counter-clockwise.
    Convex(Vec<Point>),
}

impl FixedShape {
    /// A footprint whose center and axes are those of a pose.
    pub(crate) fn of(footprint: Footprint, pose: Pose) -> Self {
        let center = pose.position();
        match footprint {
            Footprint::Box(w, d) => Self::Box {
                center,
                half: Point::new(0.5 * w, 0.5 * d),
                turn: pose.heading,
            },
            Footprint::Disc(radius) => Self::Disc { center, radius },
        }
    }

    /// The same for the engine of this project.
    pub(crate) fn solid(&self) -> Solid {
        Solid::new(match self {
            Self::Box { center, half, turn } => {
                let (x, y) = (
                    Point::unit(*turn) * half.x,
                    Point::unit(*turn).perp() * half.y,
                );
                Convex::Polygon(vec![
                    *center - x - y,
                    *center + x - y,
                    *center + x + y,
                    *center - x + y,
                ])
            }
            Self::Disc { center, radius } => Convex::Circle {
                center: *center,
                radius: *radius,
            },
            Self::Convex(vertices) => Convex::Polygon(vertices.clone()),
        })
    }
}

/// Every obstacle of the scene in convex shapes, each with its index in the scene (`None`: the map's).
pub(crate) fn shapes(scene: &Scene) -> Result<Vec<(Option<usize>, FixedShape)>, SimulationError> {
    let mut shapes = Vec::new();
    for (index, obstacle) in scene.obstacles.iter().enumerate() {
        match obstacle {
            Obstacle::Box { min, max } => {
                let half = (*max - *min) * 0.5;
                shapes.push((
                    Some(index),
                    FixedShape::Box {
                        center: min.lerp(*max, 0.5),
                        half,
                        turn: 0.0,
                    },
                ));
            }
            Obstacle::Circle { center, radius } => {
                shapes.push((
                    Some(index),
                    FixedShape::Disc {
                        center: *center,
                        radius: *radius,
                    },
                ));
            }
            Obstacle::Polygon(vertices) => {
                for piece in convex_pieces(vertices).ok_or(SimulationError::Polygon { index })? {
                    shapes.push((Some(index), FixedShape::Convex(piece)));
                }
            }
        }
    }
    if let Some(map) = &scene.map {
        for rectangle in map_rectangles(map) {
            let half = rectangle.size() * (0.5 * map.resolution);
            let center = map.from_cells(rectangle.min.lerp(rectangle.max, 0.5));
            shapes.push((
                None,
                FixedShape::Box {
                    center,
                    half,
                    turn: map.origin.heading,
                },
            ));
        }
    }
    Ok(shapes)
}

/// Convex pieces of a simple polygon, counter-clockwise.
fn convex_pieces(vertices: &[Point]) -> Option<Vec<Vec<Point>>> {
    let mut outline = vertices.to_vec();
    outline.dedup();
    let mut polygon = Polygon::new(outline);
    if polygon.signed_area() < 0.0 {
        polygon = Polygon::new(polygon.vertices().iter().rev().copied().collect());
    }
    if polygon.check().is_err() {
        return None;
    }
    Some(if polygon.is_convex() {
        vec![polygon.vertices().to_vec()]
    } else {
        let triangles = polygon.triangles();
        triangles.into_iter().map(|t| t.to_vec()).collect()
    })
}

/// A rectangle of cells, in cell units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CellRectangle {
    pub(crate) min: Point,
    pub(crate) max: Point,
}

impl CellRectangle {
    fn new(column: f64, row: f64, columns: f64, rows: f64) -> Self {
        Self {
            min: Point::new(column, row),
            max: Point::new(column + columns, row + rows),
        }
    }

    fn size(&self) -> Point {
        self.max - self.min
    }
}

/// Rectangles that cover every blocked cell near a free one and nothing free, and walls around the map.
pub(crate) fn map_rectangles(map: &OccupancyMap) -> Vec<CellRectangle> {
    let (columns, rows) = (map.columns as i64, map.rows as i64);
    let free = |c: i64, r: i64| !map.is_blocked(c, r);
    let mut wanted: Vec<bool> = (0..rows)
        .flat_map(|r| (0..columns).map(move |c| (c, r)))
        .map(|(c, r)| {
            map.is_blocked(c, r)
                && (-SKIN..=SKIN).any(|dr| (-SKIN..=SKIN).any(|dc| free(c + dc, r + dr)))
        })
        .collect();
    let mut rectangles = Vec::new();
    for row in 0..map.rows {
        let mut column = 0;
        while column < map.columns {
            if !wanted[row * map.columns + column] {
                column += 1;
                continue;
            }
            let width = (column..map.columns)
                .take_while(|&c| wanted[row * map.columns + c])
                .count();
            let span = column..column + width;
            let height = (row..map.rows)
                .take_while(|&r| span.clone().all(|c| wanted[r * map.columns + c]))
                .count();
            for r in row..row + height {
                wanted[r * map.columns + span.start..r * map.columns + span.end].fill(false);
            }
            rectangles.push(CellRectangle::new(
                column as f64,
                row as f64,
                width as f64,
                height as f64,
            ));
            column += width;
        }
    }
    let wall = WALL / map.resolution;
    let (width, height) = (columns as f64, rows as f64);
    rectangles.extend([
        CellRectangle::new(-wall, -wall, width + 2.0 * wall, wall),
        CellRectangle::new(-wall, height, width + 2.0 * wall, wall),
        CellRectangle::new(-wall, 0.0, wall, height),
        CellRectangle::new(width, 0.0, wall, height),
    ]);
    rectangles
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rectangles_cover_the_blocked_cells_once_and_nothing_free() {
        let picture = ["#####...", "#####..#", "##......", "......##", "...####."];
        let blocked: Vec<bool> = picture
            .iter()
            .flat_map(|row| row.chars().map(|c| c == '#'))
            .collect();
        let map = OccupancyMap {
            origin: Pose::new(1.0, 2.0, 0.3),
            resolution: 0.1,
            columns: 8,
            rows: 5,
            blocked: blocked.clone(),
        };
        let rectangles = map_rectangles(&map);
        for (i, &is_blocked) in blocked.iter().enumerate() {
            let center = Point::new((i % 8) as f64 + 0.5, (i / 8) as f64 + 0.5);
            let covers = |r: &CellRectangle| {
                r.min.x < center.x && center.x < r.max.x && r.min.y < center.y && center.y < r.max.y
            };
            assert_eq!(
                rectangles.iter().filter(|r| covers(r)).count(),
                usize::from(is_blocked),
                "cell {i}"
            );
        }
        assert_eq!(rectangles.len(), 4 + 5);
    }

    #[test]
    fn a_non_convex_polygon_keeps_its_area_in_either_orientation() {
        let corner = [
            [0.0, 0.0],
            [3.0, 0.0],
            [3.0, 1.0],
            [1.0, 1.0],
            [1.0, 2.0],
            [0.0, 2.0],
        ]
        .map(Point::from);
        let mut turned = corner;
        turned.reverse();
        for vertices in [corner, turned] {
            let pieces = convex_pieces(&vertices).expect("a simple polygon");
            assert!(pieces.len() >= 2);
            let area: f64 = pieces
                .iter()
                .map(|piece| Polygon::new(piece.clone()).signed_area())
                .sum();
            assert!((area - 4.0).abs() < 1e-12, "{area}");
        }
    }
}
