//! Constraints `c >= 0` (and one equality) in local coordinates, one a file.

mod abreast;
mod forward;
mod half_plane;
mod net_reach;
mod no_sideways_slip;
mod point_distance;
mod rung_distance;
mod separation;
mod step;
mod turn;

pub use abreast::Abreast;
pub use forward::Forward;
pub use half_plane::HalfPlane;
pub use net_reach::NetReach;
pub use no_sideways_slip::NoSidewaysSlip;
pub use point_distance::PointDistance;
pub use rung_distance::RungDistance;
pub use separation::{SeparationAbove, SeparationBelow};
pub use step::StepLength;
pub use turn::Turn;
