//! Robots, net and objects in planar physics.
//!
//! A plan is proven for the straight line between the robots; the real net hangs behind them as a slack U, cuts corners and
//! carries objects that slide and turn. Here it is driven in simulation: two robots on wheels, a chain of rigid links, objects
//! of any footprint, every contact with Coulomb friction, every support point with dry friction on the floor, no gravity in the plane.
//!
//! [`rehearse`] drives a plan and reports what happened; [`Simulation`] is the world itself, for callers that bring other drives.
//! The result depends on nothing but its inputs: same bits on every run, machine and number of threads.

mod contacts;
mod conversion;
mod engine;
mod error;
pub mod export;
mod ground_friction;
mod net;
mod net_start;
mod objects;
mod obstacles;
mod options;
mod parameters;
mod region;
mod rehearsal;
mod robots;
mod servo;
mod simulation;
mod tag;
#[cfg(test)]
mod theory_tests;
mod watch;

pub use contacts::Contact;
pub use error::SimulationError;
pub use options::Options;
pub use parameters::{Base, Parameters};
pub use region::{distance_outside, encloses};
pub use rehearsal::{Driver, PlanFollower, rehearse, run};
pub use robots::{RobotLoad, RobotState};
pub use servo::RobotDrive;
pub use simulation::Simulation;
pub use tag::Part;
pub use watch::Watch;
