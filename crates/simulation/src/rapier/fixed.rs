//! Obstacles as fixed colliders.

use super::settings::vector;
use super::tag;
use crate::SimulationError;
use crate::obstacles::FixedShape;
use rapier2d_f64::prelude::{ColliderBuilder, PhysicsWorld};

/// Inserts the pieces of the obstacles, each with its obstacle's index in the scene (`None`: the map's).
pub(crate) fn insert(
    world: &mut PhysicsWorld,
    pieces: Vec<(Option<usize>, FixedShape)>,
    friction: f64,
) -> Result<(), SimulationError> {
    for (index, shape) in pieces {
        let collider = match shape {
            FixedShape::Box { center, half, turn } => ColliderBuilder::cuboid(half.x, half.y)
                .translation(vector(center))
                .rotation(turn),
            FixedShape::Disc { center, radius } => {
                ColliderBuilder::ball(radius).translation(vector(center))
            }
            FixedShape::Convex(vertices) => {
                let broken = SimulationError::Polygon {
                    index: index.unwrap_or_default(),
                };
                ColliderBuilder::convex_polyline(vertices.into_iter().map(vector).collect())
                    .ok_or(broken)?
            }
        };
        world
            .colliders
            .insert(collider.friction(friction).user_data(tag::obstacle(index)));
    }
    Ok(())
}
