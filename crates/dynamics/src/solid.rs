//! What is fixed.

use crate::manifold;
use crate::outline::{MovingShape, Outline, edge_normals};
use pairtrawl_geometry::{Convex, Point};

/// Something fixed and convex, ready for contact.
#[derive(Clone, Debug)]
pub struct Solid {
    points: Vec<Point>,
    normals: Vec<Point>,
    radius: f64,
}

impl Solid {
    /// Of a region. Vertices on a straight line do no harm.
    pub fn new(region: Convex) -> Self {
        match region {
            Convex::Polygon(points) => Self {
                normals: edge_normals(&points),
                points,
                radius: 0.0,
            },
            Convex::Circle { center, radius } => Self {
                points: vec![center],
                normals: vec![Point::ZERO],
                radius,
            },
        }
    }

    /// True when a link of the net between two places overlaps it; `thickness` is the net's, m.
    pub fn meets_link(&self, ends: [Point; 2], thickness: f64) -> bool {
        let link = MovingShape::segment(ends[0], ends[1], 0.5 * thickness);
        let near = link
            .outline()
            .bounds(0.0)
            .meets(&self.outline().bounds(0.0));
        near && manifold::between(link.outline(), self.outline(), 0.0).count > 0
    }

    pub(crate) fn outline(&self) -> Outline<'_> {
        Outline {
            points: &self.points,
            normals: &self.normals,
            radius: self.radius,
        }
    }
}
