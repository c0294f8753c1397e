//! Constraints `c >= 0` at a waypoint, in local coordinates, one a file. Those of a step are in `step.rs`.

mod abreast;
mod half_plane;
mod net_reach;
mod point_distance;
mod quad_distance;
mod separation;

pub use abreast::Abreast;
pub use half_plane::HalfPlane;
pub use net_reach::NetReach;
pub use point_distance::{CenterDistance, PointDistance};
pub use quad_distance::QuadDistance;
pub use separation::{SeparationAbove, SeparationBelow};
