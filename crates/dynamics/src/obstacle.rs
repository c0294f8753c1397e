//! What is fixed.

use crate::manifold;
use crate::outline::{Extent, MovingShape, Outline, edge_normals};
use pairtrawl_geometry::Point;

/// Something fixed and convex.
#[derive(Clone, Debug, PartialEq)]
pub enum Obstacle {
    /// Vertices counter-clockwise, m.
    Polygon(Vec<Point>),
    /// A disc.
    Disc {
        /// m.
        center: Point,
        /// m.
        radius: f64,
    },
}

impl Obstacle {
    /// True when a link of the net between two places overlaps it.
    pub fn meets_link(&self, ends: [Point; 2], thickness: f64) -> bool {
        let fixed = Fixed::new(self.clone());
        let link = MovingShape::segment(ends[0], ends[1], 0.5 * thickness);
        let near = Extent::of(link.outline(), 0.0).meets(&Extent::of(fixed.outline(), 0.0));
        near && manifold::between(link.outline(), fixed.outline(), 0.0).count > 0
    }
}

/// A fixed shape, ready for contact.
#[derive(Clone, Debug)]
pub(crate) struct Fixed {
    points: Vec<Point>,
    normals: Vec<Point>,
    radius: f64,
}

impl Fixed {
    pub(crate) fn new(obstacle: Obstacle) -> Self {
        match obstacle {
            Obstacle::Polygon(points) => Self {
                normals: edge_normals(&points),
                points,
                radius: 0.0,
            },
            Obstacle::Disc { center, radius } => Self {
                points: vec![center],
                normals: vec![Point::ZERO],
                radius,
            },
        }
    }

    pub(crate) fn outline(&self) -> Outline<'_> {
        Outline {
            points: &self.points,
            normals: &self.normals,
            radius: self.radius,
        }
    }
}
