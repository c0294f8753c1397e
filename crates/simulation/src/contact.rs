use crate::Part;
use pairtrawl_geometry::Point;

/// Two parts that touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The part that comes first in the order of [`Part`].
    pub first: Part,
    /// The other.
    pub second: Part,
    /// Where they touch deepest, m.
    pub place: Point,
    /// How deep they overlap there, m.
    pub depth: f64,
    /// How hard they push along the normal, N s: more than zero when they do (rapier: the sum of the last solver iteration's impulses).
    pub impulse: f64,
}
