use crate::{Bounds, Point};

/// A convex region: a piece of an obstacle.
#[derive(Clone, Debug, PartialEq)]
pub enum Convex {
    /// Vertices counter-clockwise, at least three, no three collinear.
    Polygon(Vec<Point>),
    /// A disc.
    Circle {
        /// Its center.
        center: Point,
        /// Its radius, m.
        radius: f64,
    },
}

impl Convex {
    /// The bounding box.
    pub fn bounds(&self) -> Bounds {
        match self {
            Self::Polygon(vertices) => Bounds::of(vertices),
            Self::Circle { center, radius } => Bounds::of_disc(*center, *radius),
        }
    }
}
