//! `plan.json`, format `pairtrawl-plan/1`. The types of the file are apart from those of the model.

pub(super) mod file;
mod layout;
mod left_out;
mod overrides;
mod read;
mod write;

pub use read::{PlanFile, parse_plan};
pub use write::plan_json;

/// The first field of every plan.
const FORMAT: &str = "pairtrawl-plan/1";
