use crate::Point;

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
