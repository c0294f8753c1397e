//! Plane geometry of poses, polygons and swept quadrilaterals.
//!
//! SI units and radians; the frame is the map frame of REP-103 (x right, y up, headings counter-clockwise from +x).
//! Orientation tests are exact; distances carry the usual rounding of a few units in the last place. Signed distances
//! are [`Gap`]s: positive apart, zero touching, negative overlapping.

mod bounds;
mod convex;
mod gap;
mod hull;
mod point;
mod polygon;
mod pose;
mod predicates;
mod segment;
mod swept_line;

pub use bounds::Bounds;
pub use convex::Convex;
pub use gap::Gap;
pub use hull::Hull;
pub use point::Point;
pub use polygon::{Polygon, PolygonError};
pub use pose::{Pose, wrap_angle};
pub use predicates::{orient2d, segments_intersect};
pub use segment::Segment;
pub use swept_line::{Coverage, SweptLine};
