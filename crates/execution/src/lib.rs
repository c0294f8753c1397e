//! Driving a plan: the pair follows its reference, in the simulated world, on reduced plants, or on the floor.
//!
//! - [`PairController`] keeps two robots on a reference: measurements in, commands out. It knows no simulation.
//! - [`rehearse`] drives a reference closely in physics and says whether the plan is at fault for anything.
//! - [`drive_trials`] lets controllers with sensors drive it in physics, several times; [`monte_carlo`]
//!   many times, there or on reduced plants.
//!
//! Nothing here reads a file or a clock: the caller brings the clock ([`Host`]), and seeds come in as options. Results depend on
//! their inputs alone, not on the number of threads, but for [`pairtrawl_model::Trial::seconds`].

mod collector;
mod control_loop;
mod error;
mod full_run;
mod law_options;
mod monte_carlo;
mod monte_carlo_options;
mod observer;
mod options;
mod outcome;
mod pair_controller;
mod plant;
mod reduced_run;
mod rehearsal;
mod sample;
mod sensing;
mod statistics;
mod task;
mod trial;
mod trials;
mod wheel_speed;

pub use control_loop::{PairLoop, Truth};
pub use error::ExecutionError;
pub use law_options::{AdaptedParts, LawOptions};
pub use monte_carlo::{GrowingDrag, MonteCarlo, MonteCarloRow, monte_carlo};
pub use monte_carlo_options::{MonteCarloOptions, Plants};
pub use observer::ExecutionObserver;
pub use options::{ExecutionOptions, NominalInertia, controller_parameters};
pub use pair_controller::{Command, Measurement, PairController, PairStop, PoseFix};
pub use plant::{Drag, PlantParameters, ReducedPlant};
pub use reduced_run::{ReducedOutcome, ReducedRun};
pub use rehearsal::{rehearse, rehearse_in, rehearse_while};
pub use sample::evenly_sampled;
pub use sensing::{Normal, Sensing, Sensors, TORQUE_PERIOD, TRACKER_TICKS};
pub use statistics::{mixed_seed, quantile};
pub use task::{Host, Task};
pub use trials::drive_trials;
