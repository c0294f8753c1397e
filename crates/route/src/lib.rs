//! Visiting order, centerline and baseline pair: the way from a scene to the optimizer's start.
//!
//! - [`visiting_order`]: in which order the circles are visited;
//! - [`hybrid_a_star::centerline`] or [`rrt_star::centerline`]: a path for the pair's midpoint through them;
//! - [`baseline()`]: the two robots on either side of it (eqs. 1 to 3 of the paper).
//!
//! Lengths are in units of the scene's length scale ([`pairtrawl_model::Scales`]): the constants in here are those of a
//! machine of the paper's size, whatever size the machine has. Radians, map frame. Same input, same bits.

mod banded;
mod baseline;
mod centerline;
mod error;
mod geodesic;
mod order;
mod polyline;
mod random;
mod terrain;

pub use baseline::{baseline, with_lead};
pub use centerline::{hybrid_a_star, rrt_star};
pub use error::RouteError;
pub use order::{EXACT_LIMIT, visiting_order, visiting_orders};
