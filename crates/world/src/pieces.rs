use crate::error::WorldError;
use crate::map_rectangles::{blocked_rectangles, outside_rectangles};
use crate::polygon::convex_parts;
use pairtrawl_geometry::{Convex, Point};
use pairtrawl_model::{Footprint, Object, Obstacle, Scene};

/// A convex cover of all obstacles: those given as shapes in the scene's order, then the blocked cells of the map that have
/// a free neighbor, then the outside of the map.
///
/// # Errors
/// When a polygon is flat.
pub fn convex_cover(scene: &Scene) -> Result<Vec<Convex>, WorldError> {
    let mut pieces = Vec::new();
    for (index, obstacle) in scene.obstacles.iter().enumerate() {
        pieces.extend(obstacle_pieces(obstacle).ok_or(WorldError::FlatPolygon { index })?);
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

/// An obstacle as convex pieces, vertices counter-clockwise; `None` for a flat polygon.
pub fn obstacle_pieces(obstacle: &Obstacle) -> Option<Vec<Convex>> {
    match obstacle {
        Obstacle::Box { min, max } => Some(vec![Convex::Polygon(vec![
            *min,
            Point::new(max.x, min.y),
            *max,
            Point::new(min.x, max.y),
        ])]),
        Obstacle::Circle { center, radius } => Some(vec![Convex::Circle {
            center: *center,
            radius: *radius,
        }]),
        Obstacle::Polygon(outline) => {
            let parts = convex_parts(outline);
            (!parts.is_empty()).then(|| parts.into_iter().map(Convex::Polygon).collect())
        }
    }
}

/// The footprint of an object, map frame.
pub fn footprint_outline(object: &Object) -> Convex {
    let c = object.position;
    match object.footprint {
        Footprint::Box(w, d) => {
            let h = Point::new(0.5 * w, 0.5 * d);
            Convex::Polygon(vec![
                c - h,
                Point::new(c.x + h.x, c.y - h.y),
                c + h,
                Point::new(c.x - h.x, c.y + h.y),
            ])
        }
        Footprint::Disc(radius) => Convex::Circle { center: c, radius },
    }
}
