//! One file for each command. A command returns what it has to say; `main` prints it.

mod bench_plan;
mod check;
mod completions;
mod demo;
mod export;
mod generate;
mod given_plan;
mod length;
mod monte_carlo;
mod new;
mod plan;
mod planning;
mod rehearse;
mod reproduce;
mod run;
mod schemas;
mod show;

pub use bench_plan::bench_plan;
pub use check::check;
pub use completions::completions;
pub use demo::demo;
pub use export::export;
pub use generate::generate;
pub use length::length;
pub use monte_carlo::monte_carlo;
pub use new::new;
pub use plan::plan;
pub use rehearse::rehearse;
pub use reproduce::reproduce;
pub use run::run;
pub use schemas::schemas;
pub use show::show;

use crate::failure::Failure;
use crate::output::Done;
use pairtrawl::files::{LoadedScene, read_scene};
use std::path::Path;

/// Reads a scene and works with it; what fails from then on is about this scene.
fn with_scene(
    path: &Path,
    work: &dyn Fn(&LoadedScene) -> Result<Done, Failure>,
) -> Result<Done, Failure> {
    let loaded = read_scene(path)?;
    work(&loaded).map_err(|failure| failure.about(&loaded.scene.name))
}
