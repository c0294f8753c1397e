//! Files in and out: scenes, plans, CSV and TUM trajectories.
//!
//! Reading: every byte is distrusted. Files are regular and bounded in size before they are read, errors name the file,
//! the line where there is one, the field, its value, the bound and the remedy.
//! Writing: to a temporary file in the same folder, synced, renamed, so that a reader sees the old file or the new one.

mod atomic;
mod csv;
mod error;
mod execution;
mod hash;
mod limits;
mod parts;
mod plan;
mod scene;
#[cfg(feature = "schema")]
mod schema;
mod toml_reader;
mod tum;

pub use atomic::{check_writable, write_atomically};
pub use csv::{csv_text, write_csv};
pub use error::{FileError, Problem};
pub use execution::{ExecutionFigures, execution_json, write_execution};
pub use hash::sha256_hex;
pub use limits::read_bounded;
pub use plan::{PlanFile, parse_plan, plan_json, read_plan, write_plan};
pub use scene::{LoadedScene, parse_scene, parse_scene_with, read_scene};
#[cfg(feature = "schema")]
pub use schema::schemas;
pub use tum::{tum_text, write_tum};
