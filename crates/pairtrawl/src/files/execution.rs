//! `execution.json`, format `pairtrawl-execution/1`. The types of the file are apart from those of the model.

pub(super) mod file;
mod write;

pub use file::ExecutionFigures;
pub use write::execution_json;

/// The first field of every execution.
const FORMAT: &str = "pairtrawl-execution/1";
