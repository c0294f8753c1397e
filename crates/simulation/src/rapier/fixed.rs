//! Obstacles as fixed colliders.

use super::settings::vector;
use super::tag;
use crate::SimulationError;
use crate::obstacles::{FixedShape, shapes};
use pairtrawl_model::Scene;
use rapier2d_f64::prelude::{ColliderBuilder, PhysicsWorld};

/// Inserts every obstacle of the scene.
pub(crate) fn insert(world: &mut PhysicsWorld, scene: &Scene) -> Result<(), SimulationError> {
    for (index, shape) in shapes(scene)? {
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
        world.colliders.insert(
            collider
                .friction(scene.physics.contact_friction)
                .user_data(tag::obstacle(index)),
        );
    }
    Ok(())
}
