//! A plan as one time-continuous reference for the pair: the curve that is proven and driven.
//!
//! Between waypoints each robot rolls without slip on a smooth curve through its waypoints (the plan's own poses, met to
//! rounding); one time law moves both, so that both are at waypoint i at the same instant. Speeds are 0 at the start and at the
//! end, continuous between, and slowed where the smooth curve would break the robot's limits.

mod clock;
mod error;
mod limits;
mod reference;
mod sample;
mod step;

pub use error::ReferenceError;
pub use limits::ReferenceLimits;
pub use reference::Reference;
pub use sample::Sample;
