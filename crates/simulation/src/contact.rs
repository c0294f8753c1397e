use crate::Part;
use pairtrawl_geometry::Point;

/// A place where two parts push each other. Two that lie face to face have two such places; with rapier every pair has one, and it
/// may touch without a push.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The part that comes first in the order of [`Part`].
    pub first: Part,
    /// The other.
    pub second: Part,
    /// Where, m; with rapier, where they touch deepest.
    pub place: Point,
    /// How deep they overlap there, m.
    pub depth: f64,
    /// How hard they pushed along the normal over the step, N s; with rapier, the sum of the last solver iteration's impulses, zero
    /// without a push.
    pub impulse: f64,
}
