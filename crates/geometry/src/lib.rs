//! Plane geometry of poses, polygons and swept quadrilaterals.
//!
//! SI units and radians; the frame is the map frame of REP-103 (x right, y up, headings counter-clockwise from +x).

mod convex;
mod point;
mod pose;

pub use convex::Convex;
pub use point::Point;
pub use pose::{Pose, wrap_angle};
