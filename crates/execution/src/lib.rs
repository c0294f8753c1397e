//! Driving a plan: controllers keep both robots on the pair's reference, in the simulated world or on reduced plants.
//!
//! Nothing here reads a file or a clock: the caller brings the clock ([`Host`]), and seeds come in as options. Results depend on
//! their inputs alone, not on the number of threads, but for [`pairtrawl_model::Trial::seconds`].

mod collector;
mod control_loop;
mod error;
mod monte_carlo;
mod observer;
mod options;
mod plant;
mod reduced_run;
mod sample;
mod sensing;
mod statistics;
mod trial;
mod trials;

pub use control_loop::{PairLoop, Truth};
pub use error::ExecutionError;
pub use monte_carlo::{GrowingDrag, MonteCarlo, MonteCarloOptions, MonteCarloRow, monte_carlo};
pub use observer::ExecutionObserver;
pub use options::{ExecutionOptions, NominalInertia, controller_parameters};
pub use plant::{Drag, PlantParameters, ReducedPlant};
pub use reduced_run::{ReducedOutcome, ReducedRun};
pub use sensing::{Normal, Sensing, Sensors, TORQUE_PERIOD, TRACKER_TICKS};
pub use statistics::{mixed_seed, quantile};
pub use trials::{Host, Task, drive_trials};
