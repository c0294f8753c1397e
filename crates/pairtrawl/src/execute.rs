//! Executing a plan: controllers drive both robots in the simulated world, several trials in parallel.

mod control_loop;
mod error;
mod monte_carlo;
mod observer;
mod options;
mod plant;
mod reduced_run;
mod sensing;
mod statistics;

pub use control_loop::{PairLoop, Truth};
pub use error::ExecutionError;
pub use monte_carlo::{GrowingDrag, MonteCarlo, MonteCarloOptions, MonteCarloRow, monte_carlo};
pub use observer::ExecutionObserver;
pub use options::{ExecutionOptions, NominalInertia, controller_parameters};
pub use plant::{Drag, PlantParameters, ReducedPlant};
pub use reduced_run::{ReducedOutcome, ReducedRun};
pub use sensing::{Normal, Sensing, Sensors, TORQUE_PERIOD, TRACKER_TICKS};
pub use statistics::{mixed_seed, quantile};
