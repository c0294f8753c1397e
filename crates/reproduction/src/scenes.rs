//! The scenes of the experiments, embedded: the same wherever the program runs.

use crate::lab::Stopped;
use pairtrawl::files::{LoadedScene, parse_scene};

/// The paper's simulation, reconstructed.
///
/// # Errors
/// Never, while the shipped file can be read.
pub fn simulation() -> Result<LoadedScene, Stopped> {
    parsed(
        "paper-simulation",
        include_str!("../../../scenes/paper-simulation/scene.toml"),
    )
}

/// The paper's experiment, reconstructed.
///
/// # Errors
/// Never, while the shipped file can be read.
pub fn experiment() -> Result<LoadedScene, Stopped> {
    parsed(
        "paper-experiment",
        include_str!("../../../scenes/paper-experiment/scene.toml"),
    )
}

/// The world that the paper's authors published.
///
/// # Errors
/// Never, while the shipped file can be read.
pub fn authors_simulation() -> Result<LoadedScene, Stopped> {
    parsed(
        "authors-simulation",
        include_str!("../../../scenes/authors-simulation/scene.toml"),
    )
}

/// A gap that the pair passes with its load; ours.
///
/// # Errors
/// Never, while the shipped file can be read.
pub fn narrow_gap() -> Result<LoadedScene, Stopped> {
    parsed(
        "narrow-gap",
        include_str!("../../../scenes/narrow-gap/scene.toml"),
    )
}

/// Wide clusters of objects; ours.
///
/// # Errors
/// Never, while the shipped file can be read.
pub fn wide_clusters() -> Result<LoadedScene, Stopped> {
    parsed(
        "wide-clusters",
        include_str!("../../../scenes/wide-clusters/scene.toml"),
    )
}

fn parsed(name: &str, text: &str) -> Result<LoadedScene, Stopped> {
    parse_scene(text, name).map_err(|error| Stopped::failed(name, error))
}
