//! Plan, prove, rehearse and execute runs of two robots that tow a net.
//!
//! ```no_run
//! use pairtrawl::{PlanOptions, files, plan, summarize};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let loaded = files::read_scene("scenes/paper-experiment/scene.toml".as_ref())?;
//! let planned = plan(&loaded.scene, &loaded.reference, &PlanOptions::default(), &mut ())?;
//! println!("net {} m, J {}", planned.plan.net_length, planned.plan.cost.total());
//! for claim in &planned.plan.certificate.claims {
//!     println!("{} holds with a margin of {}", claim.id, claim.margin);
//! }
//! files::write_plan("plan.json".as_ref(), &planned.plan)?;
//! let summary = summarize(&loaded.scene, &planned.plan, &planned.stages, None);
//! files::write_atomically("report.html".as_ref(), pairtrawl::report::report_html(&summary).as_bytes())?;
//! # Ok(())
//! # }
//! ```
//!
//! The same on a scene of a few lines, which runs when the documentation is tested:
//!
//! ```
//! use pairtrawl::{PlanError, PlanOptions, files, plan};
//!
//! let text = r#"
//!     format = "pairtrawl-scene/1"
//!     area = { min = [0.0, 0.0], max = [4.0, 3.0], resolution = 0.05 }
//!     objects = [{ position = [2.0, 1.5], radius = 0.03 }]
//!     start = { left = [0.5, 1.85], right = [0.5, 1.15], heading = 0.0 }
//!     end = { left = [3.5, 1.85], right = [3.5, 1.15], heading = 0.0 }
//! "#;
//! let loaded = files::parse_scene(text, "a small hall")?;
//! let options = PlanOptions::default();
//! let planned = plan(&loaded.scene, &loaded.reference, &options, &mut ())?;
//! assert!(planned.plan.certificate.is_valid());
//!
//! // A net shorter than the pair is wide: not a failure of the planner, a proof.
//! let options = PlanOptions { net_length: Some(pairtrawl::NetLength::Fixed(0.5)), ..options };
//! let refused = plan(&loaded.scene, &loaded.reference, &options, &mut ());
//! assert!(matches!(refused, Err(PlanError::Infeasible { .. })));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is here
//!
//! - [`plan()`] goes from a [`model::Scene`] to a plan whose every claim is proven; [`PlanOptions`] says how, an
//!   [`Observer`] watches and may stop it. [`PlanError`] keeps apart bad input, a proof that there is no plan, and a
//!   search that found none.
//! - [`check()`] proves any pair of trajectories against a scene.
//! - [`rehearse()`] drives any plan in physics; [`execute`] drives it by controllers.
//! - [`length_curve`] is the cost of the best plan over the length of the net.
//! - [`files`] reads and writes scenes, plans and trajectories; [`summarize`] computes everything that [`report`] shows.
//!
//! SI units and radians; map frame of REP-103. `left` and `right` are as seen by someone who walks behind the pair. The same
//! input gives the same plan, bit for bit, whatever the number of threads.

mod attempt;
mod check;
mod check_proofs;
mod clock;
mod common_start;
mod detour;
mod error;
pub mod execute;
mod explore;
pub mod files;
mod infeasible;
mod judge;
mod leave_more;
mod length;
mod no_plan;
mod not_found;
mod observer;
mod options;
mod passage;
mod plan;
mod planner;
mod prepare;
mod preview;
mod rehearse;
mod run;
mod sampling;
mod separation_study;
mod start;
mod starts;
mod summary;
mod tighten;

pub use check::{Candidate, check};
pub use check_proofs::{CheckedProofs, check_proofs};
pub use error::{BadInput, PlanError};
pub use infeasible::Infeasible;
pub use judge::judge;
pub use length::{LengthRange, length_curve};
pub use no_plan::NoPlan;
pub use not_found::{NotFound, Tried};
pub use observer::{Observer, Stage};
pub use options::{CenterlineMethod, Method, NetLength, OrderMethod, PlanOptions, RehearsalMode};
pub use pairtrawl_certificate as certificate;
pub use pairtrawl_generate as generate;
pub use pairtrawl_geometry as geometry;
pub use pairtrawl_model as model;
pub use pairtrawl_reference as reference;
pub use pairtrawl_report as report;
pub use pairtrawl_simulation as simulation;
pub use pairtrawl_trajopt as trajopt;
pub use pairtrawl_world as world;
pub use plan::{Planned, plan};
pub use planner::Planner;
pub use preview::{Preview, preview};
pub use rehearse::{Rehearsed, rehearse, rehearse_trajectory};
pub use separation_study::{SeparationStudy, separation_study};
pub use summary::{
    claim_summaries, summarize, summarize_execution, summarize_failure, summarize_scene,
};
