//! Two robots, a chain and objects on a floor, in implicit steps.
//!
//! A net is a chain of rigid links, damped by dry friction, with few contacts. This engine is made for that: planar, without gravity in
//! the plane, in steps of 2 ms (with controllers) to 20 ms. Its parts and their equations:
//!
//! | part | module |
//! |---|---|
//! | links: exact rigid-link mass at the hinges, axial stiffness, hinge damping | `chain` |
//! | robots: two driven wheels within their traction, no sideways slip | `wheels` |
//! | friction on the floor: Coulomb's, per support point | `friction`, `floor` |
//! | contacts: stiff, Coulomb's cone, rounded convex shapes | `contact`, `manifold` |
//! | which pairs to look at, what sleeps | `neighbors`, `sleep` |
//! | the step: Newton's method with a sparse direct solver | `newton`, `balance`, `pattern`, `elimination`, `factor` |
//!
//! # The step
//!
//! Unknown are the velocities u at the end of a step (three per robot and awake object, two per hinge; the ends of the net are
//! points of the robots). With the mass matrix M, the velocities before u0 and the potentials of what acts, they minimize
//!
//! ```text
//! (u - u0)^T M (u - u0) / 2 + sum of the potentials (links, dampers, floor, wheels, contacts) at u:
//! ```
//!
//! implicit Euler, with directions and gaps of the beginning or, where that keeps lengths exact to second order, of the foreseen
//! middle of the step. Every potential is convex, so there is one solution; a step ends when no part is left with more than 1e-4 N (in units of
//! the machine). Then places follow: x += dt u. The matrix is sparse: parts that do not touch do not depend on each other. It is factored
//! in blocks of three velocities a part, in an order of minimum degree that lasts until something new comes near something. What is near but
//! does not close takes no part; should it turn out to close, the step is solved again with it. While nothing changes its state (slides, sticks, pushes)
//! a step costs one factorization.
//!
//! # Limits
//!
//! - What is held creeps by up to 0.1 mm/s; sliding contacts ride on a gap of dt mu |v| (0.4 mm at 0.2 m/s and 10 ms).
//! - Contacts give by 0.1 mm under 10 N, links stretch by 0.1 mm.
//! - A free slide ends half a step's way early or late (1 mm at 0.2 m/s and 10 ms).
//! - Nothing passes through anything: contacts are found before they close, farther than anything moves in the step, and steps in
//!   which something moves by more than 8 mm are divided, by 256 at most.
//!
//! The result depends on nothing but the inputs: same bits on every run, machine and number of threads.
//!
//! References: Moreau, Unilateral contact and dry friction in finite freedom dynamics, 1988; Castro, Permenter and Han, An unconstrained convex
//! formulation of compliant contact, IEEE T-RO 39, 2023; Todorov, Convex and analytically-invertible dynamics with contacts and constraints, ICRA 2014.

mod balance;
mod block;
mod body;
mod chain;
mod contact;
mod detection;
mod elimination;
mod factor;
mod floor;
mod friction;
mod manifold;
mod matrix;
mod near;
mod neighbors;
mod newton;
mod outline;
mod pattern;
mod reading;
mod row;
mod setup;
mod sleep;
mod solid;
#[cfg(test)]
mod tests;
mod touch;
mod wheels;
mod work;
mod world;

pub use chain::NetParameters;
pub use setup::{Footprint, ObjectParameters, RobotParameters, Setup};
pub use solid::Solid;
pub use touch::{Part, Touch};
pub use wheels::{Drive, WheelParameters};
pub use work::{Stage, Work};
pub use world::World;
