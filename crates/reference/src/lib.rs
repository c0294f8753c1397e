//! A plan as one time-continuous reference for the pair: the curve that is proven and driven.
//!
//! Between waypoints each robot rolls without slip on a smooth curve through its waypoints (the plan's own poses, met to
//! rounding); one time law moves both, so that both are at waypoint i at the same instant. Speeds are 0 at the start and at the
//! end and continuous between.
//!
//! The time law is set by physics alone: the faster robot drives at most at cruise speed and turns at most at
//! cruise * max_turn / max_step, wheels and turning keep the robot's own limits, and so do accelerations
//! ([`ReferenceLimits`]). More waypoints sample the same motion more finely; the run time stays. All limits are kept by
//! exact bounds of the curve's polynomials over each half step, not at samples.

mod clock;
mod error;
mod limits;
mod pace;
mod path;
mod polynomial;
mod reference;
mod sample;
mod step;

pub use error::ReferenceError;
pub use limits::ReferenceLimits;
pub use reference::Reference;
pub use sample::Sample;
pub use step::{RollingStep, StepBounds, StepState};
