use crate::limits::COORDINATE_LIMIT;
use crate::map_runs::{MapPart, MapRuns};
use pairtrawl_geometry::{Bounds, Convex, Gap, Hull, Point, Polygon, Segment};
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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

    fn distance(&self, p: Point) -> f64 {
        match self {
            Self::Polygon(polygon) => polygon.signed_distance(p),
            Self::Disc { center, radius } => p.distance(*center) - radius,
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

    /// The signed distance of a point to the nearest obstacle when it is below `bound`; negative inside.
    pub(crate) fn distance(&self, p: Point, bound: f64) -> Option<(f64, Part)> {
        let mut bound = bound;
        let mut found = None;
        let at = Bounds::of(&[p]);
        for (index, (shape, kind)) in self.shapes.iter().enumerate() {
            if shape.bounds().distance(&at) >= bound.max(f64::MIN_POSITIVE) {
                continue;
            }
            let distance = shape.distance(p);
            if distance < bound {
                bound = distance;
                found = Some((distance, Part::Shape { index, kind }));
            }
        }
        let in_map = self.map.as_ref().and_then(|map| map.distance(p, bound));
        in_map
            .map(|(distance, part)| (distance, Part::Map(part)))
            .or(found)
    }

    /// The signed distances of a point to every obstacle shape, and to the nearest part of the map, below `bound`.
    pub(crate) fn distances(&self, p: Point, bound: f64) -> Vec<(f64, Part)> {
        let shapes = self.shapes.iter().enumerate();
        let shapes =
            shapes.map(|(index, (shape, kind))| (shape.distance(p), Part::Shape { index, kind }));
        let map = self
            .map
            .as_ref()
            .and_then(|map| map.distance(p, bound))
            .map(|(d, part)| (d, Part::Map(part)));
        shapes.chain(map).filter(|(d, _)| *d < bound).collect()
    }

    /// Convex regions inside the obstacles that meet a box; together they fill the obstacles there.
    pub(crate) fn convex_pieces(&self, near: &Bounds) -> Vec<Convex> {
        let mut out = Vec::new();
        for (shape, _) in &self.shapes {
            if shape.bounds().distance(near) > 0.0 {
                continue;
            }
            match shape {
                Shape::Disc { center, radius } => out.push(Convex::Circle {
                    center: *center,
                    radius: *radius,
                }),
                Shape::Polygon(polygon) if polygon.is_convex() => {
                    out.push(Convex::Polygon(polygon.vertices().to_vec()));
                }
                Shape::Polygon(polygon) => {
                    out.extend(
                        polygon
                            .triangles()
                            .iter()
                            .map(|t| Convex::Polygon(t.to_vec())),
                    );
                }
            }
        }
        if let Some(map) = &self.map {
            out.extend(
                map.rectangles(near)
                    .into_iter()
                    .map(|r| Convex::Polygon(r.vertices().to_vec())),
            );
        }
        out
    }

    /// The outline of a part as segments, and how far the part reaches beyond them, m.
    pub(crate) fn outline(&self, part: Part) -> (Vec<Segment>, f64) {
        let edges = |polygon: Polygon| (polygon.edges().collect(), 0.0);
        match part {
            Part::Shape { index, .. } => match &self.shapes[index].0 {
                Shape::Polygon(polygon) => (polygon.edges().collect(), 0.0),
                Shape::Disc { center, radius } => (vec![Segment::new(*center, *center)], *radius),
            },
            Part::Map(part) => match (&self.map, part) {
                (Some(map), MapPart::Cell { column, row }) => edges(map.cell(column, row)),
                (Some(map), MapPart::Outside) => edges(map.border()),
                (None, _) => (Vec::new(), 0.0),
            },
        }
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
