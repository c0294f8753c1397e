use crate::obstacles::Obstacles;
use pairtrawl_geometry::{Hull, Point};
use pairtrawl_model::Scene;

/// Exact distances to a scene's obstacles, by the geometry that decides the claims: for showing how much room a plan
/// leaves where it is not tightest, and for finding places.
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

    /// True when no obstacle is closer to a point than `keep`, m.
    pub fn is_free(&self, p: Point, keep: f64) -> bool {
        self.0.distance(p, keep).is_none()
    }
}
