use crate::Point;

/// A signed distance between two closed sets and the place where it is attained.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// Positive: the sets are this far apart, m. Zero: they touch. Negative: they overlap this deep.
    pub distance: f64,
    /// Where: a point of the first set nearest to the second, or a deepest common point.
    pub place: Point,
}

impl Gap {
    /// The smaller of two gaps; the first on a tie.
    pub fn min(self, other: Self) -> Self {
        if other.distance < self.distance {
            other
        } else {
            self
        }
    }
}
