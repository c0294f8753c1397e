//! Files in and out: scenes, plans, CSV and TUM trajectories.
//!
//! Reading: every byte is distrusted. Files are regular and bounded in size before they are read, errors name the file,
//! the line where there is one, the field, its value, the bound and the remedy.
//! Only feature `fs` touches a disk; texts and bytes are read and made without it.
//! Writing: to a temporary file in the same folder, synced, renamed, so that a reader sees the old file or the new one.

#[cfg(feature = "fs")]
mod atomic;
mod csv;
#[cfg(feature = "fs")]
mod disk;
mod error;
mod execution;
mod hash;
mod infeasible;
mod json;
mod parts;
mod plan;
mod scene;
#[cfg(feature = "schema")]
mod schema;
mod toml_reader;
mod tum;

#[cfg(feature = "fs")]
pub use atomic::{check_writable, write_atomically};
pub use csv::csv_text;
#[cfg(feature = "fs")]
pub use disk::{
    Checkable, read_bounded, read_checkable, read_map, read_plan, read_scene, write_csv,
    write_execution, write_plan, write_tum,
};
pub use error::{FileError, Problem};
pub use execution::{ExecutionFigures, execution_json};
pub use hash::sha256_hex;
#[cfg(feature = "fs")]
use infeasible::is_infeasible;
pub use infeasible::{InfeasibleFile, StatedProof, infeasible_json, parse_infeasible};
pub use plan::{PlanFile, parse_plan, plan_json};
pub use scene::{LoadedMap, LoadedScene, parse_scene, parse_scene_with};
#[cfg(feature = "schema")]
pub use schema::schemas;
pub use tum::tum_text;
