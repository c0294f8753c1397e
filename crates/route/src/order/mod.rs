//! Visiting order: the open path through all circles with fixed ends that costs least.
//!
//! The cost of a path is its obstacle-aware length plus, at every stop, what turning costs a pair that cannot turn on
//! the spot: `r alpha^3 / pi^2` with the comfortable turning radius r for a turn by alpha, that is pi r for a reversal and
//! next to nothing for a bend.
//! The headings of start and end take part.

mod exact;
mod local_search;
mod path;
mod stops;
#[cfg(test)]
mod tests;

use crate::error::RouteError;
use crate::terrain::Terrain;
use pairtrawl_model::Scene;
use pairtrawl_world::World;
use stops::Stops;

/// Most circles for which the best order is found exactly.
pub const EXACT_LIMIT: usize = 12;

/// The best order in which to visit the world's circles: indices into `world.circles`.
///
/// Exact (dynamic programming of Held and Karp) up to [`EXACT_LIMIT`] circles; beyond, a seeded local search.
///
/// # Errors
/// [`RouteError::NoPath`] when a circle or the end cannot be reached from the start.
pub fn visiting_order(world: &World, scene: &Scene) -> Result<Vec<usize>, RouteError> {
    Ok(visiting_orders(world, scene, 1)?.swap_remove(0))
}

/// The best order first, then up to `count - 1` different ones in rising cost: near-ties worth a try.
///
/// The alternatives are those within two exchanges (reversal or displacement of a run of stops) of the best one.
///
/// # Errors
/// As [`visiting_order`].
pub fn visiting_orders(
    world: &World,
    scene: &Scene,
    count: usize,
) -> Result<Vec<Vec<usize>>, RouteError> {
    let centers = world.circles.iter().map(|c| c.center).collect();
    orders_on(&Terrain::new(world, scene), centers, scene, count)
}

pub(crate) fn orders_on(
    terrain: &Terrain,
    centers: Vec<pairtrawl_geometry::Point>,
    scene: &Scene,
    count: usize,
) -> Result<Vec<Vec<usize>>, RouteError> {
    let stops = Stops::new(terrain, centers, scene)?;
    let best = if stops.count() <= EXACT_LIMIT {
        exact::best(&stops)
    } else {
        local_search::best(&stops)
    };
    Ok(local_search::alternatives(&stops, best, count))
}
