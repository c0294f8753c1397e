//! Robots, net and objects in planar physics.
//!
//! A plan is proven for the straight line between the robots; the real net hangs behind them as a slack U, cuts corners and
//! carries objects that slide and turn. This is the world in which plans are driven: two robots on wheels, a chain of rigid links, objects
//! of any footprint, every contact with Coulomb friction, every support point with dry friction on the floor, no gravity in the plane.
//!
//! [`Simulation`] is the world, moved on by a caller that brings a [`RobotDrive`] for each robot; [`Watch`] looks at it and keeps the
//! record of what happened.
//! The result depends on nothing but its inputs: same bits on every run, machine and number of threads.

mod contact;
mod conversion;
mod drive;
mod engine;
mod error;
pub mod export;
mod implicit;
mod net_start;
mod obstacles;
mod options;
mod parameters;
mod part;
mod physics;
#[cfg(feature = "rapier")]
mod rapier;
mod region;
mod simulation;
mod state;
#[cfg(test)]
mod test_scene;
mod watch;

pub use contact::Contact;
pub use drive::RobotDrive;
pub use engine::Engine;
#[cfg(feature = "rapier")]
pub use engine::RapierSolver;
pub use error::SimulationError;
pub use options::Options;
pub use pairtrawl_dynamics::{Stage, Work};
pub use parameters::{Base, Parameters};
pub use part::Part;
pub use region::{distance_outside, encloses};
pub use simulation::Simulation;
pub use state::{RobotLoad, RobotState};
pub use watch::Watch;
