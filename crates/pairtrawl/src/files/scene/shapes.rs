//! `[[obstacles]]` and `[[objects]]`.

use crate::files::toml_reader::{Range, Table, Value};
use crate::files::{FileError, Problem};
use pairtrawl_geometry::Point;
use pairtrawl_model::{Footprint, Object, Obstacle, Robot, RobotSize};

/// Bounds that keep the quadratic checks and the visiting order in seconds.
const MOST_OBSTACLES: usize = 10_000;
const MOST_OBJECTS: usize = 1_000;
const MOST_VERTICES: usize = 1_000;

/// Mass of an object when the scene gives none, kg, for robots of the paper's size: that of the paper's cubes.
const DEFAULT_MASS: f64 = 0.025;

pub(super) fn obstacles(root: &Table<'_>) -> Result<Vec<Obstacle>, FileError> {
    root.array("obstacles", MOST_OBSTACLES)?
        .iter()
        .map(|v| obstacle(&v.table()?))
        .collect()
}

pub(super) fn objects(root: &Table<'_>, robot: &Robot) -> Result<Vec<Object>, FileError> {
    root.array("objects", MOST_OBJECTS)?
        .iter()
        .map(|v| object(&v.table()?, robot))
        .collect()
}

fn obstacle(table: &Table<'_>) -> Result<Obstacle, FileError> {
    table.expect_keys(&["box", "polygon", "circle"])?;
    match (table.get("box"), table.get("polygon"), table.get("circle")) {
        (Some(value), None, None) => {
            let [x0, y0, x1, y1] = value.numbers(Range::Coordinate)?;
            if x0 >= x1 || y0 >= y1 {
                let reason = format!("[{x0}, {y0}, {x1}, {y1}] needs xmin < xmax and ymin < ymax");
                return Err(conflict(&value, reason));
            }
            Ok(Obstacle::Box { min: Point::new(x0, y0), max: Point::new(x1, y1) })
        }
        (None, Some(value), None) => {
            let vertices = (value.elements(3, MOST_VERTICES)?.iter()).map(Value::point).collect::<Result<Vec<_>, _>>()?;
            check_simple(&value, &vertices)?;
            Ok(Obstacle::Polygon(vertices))
        }
        (None, None, Some(value)) => {
            let [x, y, _] = value.numbers(Range::Coordinate)?;
            let radius = value.elements(3, 3)?[2].number(Range::Length)?;
            Ok(Obstacle::Circle { center: Point::new(x, y), radius })
        }
        (None, None, None) => Err(table.error(Problem::MissingKey {
            field: table.field("box"),
            remedy: "an obstacle is one of box, polygon or circle".to_owned(),
        })),
        _ => Err(table.error(Problem::Conflict {
            field: table.name().to_owned(),
            reason: "an obstacle is exactly one of box, polygon or circle: give each its own [[obstacles]]".to_owned(),
        })),
    }
}

fn object(table: &Table<'_>, robot: &Robot) -> Result<Object, FileError> {
    table.expect_keys(&["position", "size", "radius", "mass"])?;
    let position = table
        .require("position", "give the object's center, [x, y]")?
        .point()?;
    let footprint = match (table.get("size"), table.get("radius")) {
        (Some(size), None) => {
            let [width, depth] = size.numbers(Range::Length)?;
            Footprint::Box(width, depth)
        }
        (None, Some(radius)) => Footprint::Disc(radius.number(Range::Length)?),
        (Some(size), Some(_)) => {
            return Err(conflict(
                &size,
                "stands beside radius: an object has a size (box) or a radius (disc), not both"
                    .to_owned(),
            ));
        }
        (None, None) => {
            let remedy = "give size = [width, depth] or radius, m".to_owned();
            return Err(table.error(Problem::MissingKey {
                field: table.field("size"),
                remedy,
            }));
        }
    };
    let mut mass = RobotSize::of(robot).mass(DEFAULT_MASS);
    table.update("mass", Range::Positive, &mut mass)?;
    Ok(Object {
        position,
        footprint,
        mass,
        leave: false,
    })
}

fn conflict(value: &Value<'_>, reason: String) -> FileError {
    value.error(Problem::Conflict {
        field: value.name().to_owned(),
        reason,
    })
}

/// Refuses polygons whose edges cross or touch, and flat ones.
fn check_simple(value: &Value<'_>, vertices: &[Point]) -> Result<(), FileError> {
    let n = vertices.len();
    let edge = |i: usize| (vertices[i], vertices[(i + 1) % n]);
    for i in 0..n {
        let (a, b) = edge(i);
        if a == b {
            return Err(conflict(
                value,
                format!(
                    "vertices {i} and {} are the same point ({}, {})",
                    (i + 1) % n,
                    a.x,
                    a.y
                ),
            ));
        }
        for j in i + 1..n {
            let (c, d) = edge(j);
            // Neighbors share a vertex; they may not fold back onto each other.
            let crosses = if j == i + 1 {
                folds_back(a, b, d)
            } else if (j + 1) % n == i {
                folds_back(c, a, b)
            } else {
                meet(a, b, c, d)
            };
            if crosses {
                return Err(conflict(
                    value,
                    format!("the polygon crosses or touches itself: edges {i} and {j} meet"),
                ));
            }
        }
    }
    Ok(())
}

/// True when b to c runs back over a to b.
fn folds_back(a: Point, b: Point, c: Point) -> bool {
    (b - a).cross(c - b) == 0.0 && (b - a).dot(c - b) < 0.0
}

/// True when two segments have a point in common.
fn meet(a: Point, b: Point, c: Point, d: Point) -> bool {
    let side = |p: Point, q: Point, r: Point| (q - p).cross(r - p);
    let (s, t) = (side(a, b, c), side(a, b, d));
    let (u, v) = (side(c, d, a), side(c, d, b));
    if s * t < 0.0 && u * v < 0.0 {
        return true;
    }
    let between = |p: Point, q: Point, r: Point| {
        r.x >= p.x.min(q.x) && r.x <= p.x.max(q.x) && r.y >= p.y.min(q.y) && r.y <= p.y.max(q.y)
    };
    (s == 0.0 && between(a, b, c))
        || (t == 0.0 && between(a, b, d))
        || (u == 0.0 && between(c, d, a))
        || (v == 0.0 && between(c, d, b))
}
