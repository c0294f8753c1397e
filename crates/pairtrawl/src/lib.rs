//! Plan, prove, rehearse and execute runs of two robots that tow a net.

mod error;
pub mod files;
mod observer;
mod options;
mod summary;

pub use error::PlanError;
pub use observer::{Observer, Stage};
pub use options::{CenterlineMethod, Method, NetLength, OrderMethod, PlanOptions, RehearsalMode};
pub use pairtrawl_geometry as geometry;
pub use pairtrawl_model as model;
pub use summary::{claim_summaries, summarize};
