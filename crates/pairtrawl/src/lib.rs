//! Plan, prove, rehearse and execute runs of two robots that tow a net.

mod attempt;
mod check;
mod error;
pub mod files;
mod length;
mod observer;
mod options;
mod plan;
mod rehearse;
mod run;
mod summary;
mod tighten;

pub use check::{Candidate, check};
pub use error::PlanError;
pub use length::{LengthRange, length_curve};
pub use observer::{Observer, Stage};
pub use options::{NetLength, OrderMethod, PlanOptions, RehearsalMode};
pub use pairtrawl_generate as generate;
pub use pairtrawl_geometry as geometry;
pub use pairtrawl_model as model;
pub use pairtrawl_report as report;
pub use pairtrawl_simulation as simulation;
pub use plan::{Planned, plan};
pub use rehearse::{Rehearsed, rehearse};
pub use summary::{claim_summaries, summarize};
