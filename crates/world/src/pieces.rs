use crate::WorldError;
use crate::map_rectangles::{blocked_rectangles, outside_rectangles};
use crate::polygon::convex_parts;
use pairtrawl_geometry::{Convex, Point};
use pairtrawl_model::{Obstacle, Scene};

/// A convex cover of all obstacles: those given as shapes in the scene's order, then the blocked cells of the map, then its outside.
pub(crate) fn convex_cover(scene: &Scene) -> Result<Vec<Convex>, WorldError> {
    let mut pieces = Vec::new();
    for (index, obstacle) in scene.obstacles.iter().enumerate() {
        match obstacle {
            Obstacle::Box { min, max } => {
                pieces.push(Convex::Polygon(vec![
                    *min,
                    Point::new(max.x, min.y),
                    *max,
                    Point::new(min.x, max.y),
                ]));
            }
            Obstacle::Circle { center, radius } => pieces.push(Convex::Circle {
                center: *center,
                radius: *radius,
            }),
            Obstacle::Polygon(outline) => {
                let parts = convex_parts(outline);
                if parts.is_empty() {
                    return Err(WorldError::FlatPolygon { index });
                }
                pieces.extend(parts.into_iter().map(Convex::Polygon));
            }
        }
    }
    if let Some(map) = &scene.map {
        pieces.extend(
            blocked_rectangles(map)
                .iter()
                .map(|r| Convex::Polygon(r.corners(map))),
        );
        pieces.extend(outside_rectangles(map).into_iter().map(Convex::Polygon));
    }
    Ok(pieces)
}
