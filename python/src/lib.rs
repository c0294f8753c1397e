//! The extension module `pairtrawl._native`: the library `pairtrawl` for Python. The package around it, `python/pairtrawl`, gives
//! functions their keywords and results their classes.

mod arrays;
mod batch;
mod document;
mod driving;
mod errors;
mod failure;
mod generate;
mod length;
mod options;
mod pickle;
mod plan;
mod plan_files;
mod plan_state;
mod planning;
mod pools;
mod python_class;
mod record_state;
mod results;
mod run_files;
mod run_options;
mod samples;
mod scene;
mod scene_state;
mod typed;
mod work;

use pyo3::prelude::*;

/// What is written in Rust. Use `pairtrawl`, which documents it.
#[pymodule]
mod _native {
    #[pymodule_export]
    use crate::driving::{rehearse, run};
    #[pymodule_export]
    use crate::failure::Failure;
    #[pymodule_export]
    use crate::generate::{generate_hall, generate_litter, generate_solvable};
    #[pymodule_export]
    use crate::length::length_curve;
    #[pymodule_export]
    use crate::plan::{_restore_plan, Plan};
    #[pymodule_export]
    use crate::planning::{_panic, check, plan, plan_batch, replan};
    #[pymodule_export]
    use crate::scene::{_restore_scene, Scene};
}
