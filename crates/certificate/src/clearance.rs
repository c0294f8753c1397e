use crate::obstacles::Obstacles;
use pairtrawl_geometry::Hull;
use pairtrawl_model::Scene;

/// Exact distances to a scene's obstacles, by the geometry that decides the claims: for showing how much room a plan
/// leaves where it is not tightest.
pub struct Clearance<'a>(Obstacles<'a>);

impl<'a> Clearance<'a> {
    /// Reads the obstacles; `None` when one of them or the map is malformed, which the certificate reports.
    pub fn new(scene: &'a Scene) -> Option<Self> {
        Obstacles::new(scene).ok().map(Self)
    }

    /// The signed distance of a convex region to the nearest obstacle, m: negative when they overlap; `None` when
    /// there is no obstacle.
    pub fn distance(&self, region: &Hull) -> Option<f64> {
        self.0
            .gap(region, f64::INFINITY)
            .map(|(gap, _)| gap.distance)
    }
}
