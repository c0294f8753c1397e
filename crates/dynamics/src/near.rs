use crate::contact::Other;
use pairtrawl_geometry::Point;

/// A place where two things may touch: who, normal, place and gap.
pub(crate) type Near = (usize, Other, Point, (Point, f64));

/// Whose shape one is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mover {
    /// A body: left robot, right robot, objects.
    Body(usize),
    /// A link of the net, from the left.
    Link(usize),
}
