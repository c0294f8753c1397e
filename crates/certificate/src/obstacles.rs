use crate::map_runs::{MapPart, MapRuns};
use crate::subject::COORDINATE_LIMIT;
use pairtrawl_geometry::{Bounds, Gap, Hull, Point, Polygon};
use pairtrawl_model::{Obstacle, Scene};
use std::fmt;

/// All obstacles of a scene, ready for distance queries.
pub(crate) struct Obstacles<'a> {
    shapes: Vec<(Shape, &'static str)>,
    map: Option<MapRuns<'a>>,
}

enum Shape {
    Polygon(Polygon),
    Disc { center: Point, radius: f64 },
}

/// What a distance was measured to.
pub(crate) enum Part {
    Shape { index: usize, kind: &'static str },
    Map(MapPart),
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shape { index, kind } => write!(f, "obstacle {index} ({kind})"),
            Self::Map(MapPart::Cell { column, row }) => {
                write!(f, "map cell (column {column}, row {row})")
            }
            Self::Map(MapPart::Outside) => f.write_str("the outside of the map"),
        }
    }
}

impl Shape {
    fn new(obstacle: &Obstacle) -> Result<Self, String> {
        let usable = |p: Point| p.x.abs() <= COORDINATE_LIMIT && p.y.abs() <= COORDINATE_LIMIT;
        match obstacle {
            Obstacle::Box { min, max } => {
                if !(usable(*min) && usable(*max) && min.x < max.x && min.y < max.y) {
                    return Err(format!(
                        "box [{}, {}, {}, {}] is not usable",
                        min.x, min.y, max.x, max.y
                    ));
                }
                Ok(Self::Polygon(Polygon::rectangle(*min, *max)))
            }
            Obstacle::Polygon(vertices) => {
                let polygon = Polygon::new(vertices.clone());
                polygon.check().map_err(|e| e.to_string())?;
                if !vertices.iter().all(|&v| usable(v)) {
                    return Err(format!(
                        "a vertex of the polygon is beyond {COORDINATE_LIMIT:e} m"
                    ));
                }
                Ok(Self::Polygon(polygon))
            }
            Obstacle::Circle { center, radius } => {
                if !(usable(*center) && *radius >= 0.0 && *radius <= COORDINATE_LIMIT) {
                    return Err(format!(
                        "circle [{}, {}, {radius}] is not usable",
                        center.x, center.y
                    ));
                }
                Ok(Self::Disc {
                    center: *center,
                    radius: *radius,
                })
            }
        }
    }

    fn bounds(&self) -> Bounds {
        match self {
            Self::Polygon(polygon) => polygon.bounds(),
            Self::Disc { center, radius } => Bounds::of_disc(*center, *radius),
        }
    }

    fn gap(&self, hull: &Hull) -> Gap {
        match self {
            Self::Polygon(polygon) => hull.gap_to_polygon(polygon),
            Self::Disc { center, radius } => hull.gap_to_disc(*center, *radius),
        }
    }
}

impl<'a> Obstacles<'a> {
    /// Checks the shapes and the map; the error names the first malformed one.
    pub(crate) fn new(scene: &'a Scene) -> Result<Self, String> {
        let shape = |(i, obstacle)| match Shape::new(obstacle) {
            Ok(shape) => Ok((shape, kind(obstacle))),
            Err(e) => Err(format!("obstacle {i}: {e}")),
        };
        Ok(Self {
            shapes: scene
                .obstacles
                .iter()
                .enumerate()
                .map(shape)
                .collect::<Result<_, _>>()?,
            map: scene.map.as_ref().map(MapRuns::new).transpose()?,
        })
    }

    /// The least signed distance of a hull to an obstacle when it is below `bound`; the first obstacle wins a tie.
    pub(crate) fn gap(&self, hull: &Hull, bound: f64) -> Option<(Gap, Part)> {
        let mut bound = bound;
        let mut found = None;
        for (index, (shape, kind)) in self.shapes.iter().enumerate() {
            if shape.bounds().distance(&hull.bounds()) >= bound.max(f64::MIN_POSITIVE) {
                continue;
            }
            let gap = shape.gap(hull);
            if gap.distance < bound {
                bound = gap.distance;
                found = Some((gap, Part::Shape { index, kind }));
            }
        }
        let in_map = self.map.as_ref().and_then(|map| map.gap(hull, bound));
        in_map.map(|(gap, part)| (gap, Part::Map(part))).or(found)
    }
}

/// The word for an obstacle's shape in the scene file.
fn kind(obstacle: &Obstacle) -> &'static str {
    match obstacle {
        Obstacle::Box { .. } => "box",
        Obstacle::Polygon(_) => "polygon",
        Obstacle::Circle { .. } => "circle",
    }
}
