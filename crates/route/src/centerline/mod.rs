//! The pair's centerline: from the start through all circles to the end.

pub(crate) mod attachment;
pub(crate) mod corridor;
pub(crate) mod dubins;
pub mod hybrid_a_star;
pub(crate) mod itinerary;
pub(crate) mod lattice;
pub mod rrt_star;
pub(crate) mod smooth;
#[cfg(test)]
mod tests;
