use clap::{Args, ValueHint};
use std::path::PathBuf;

/// `pairtrawl new`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl new my-hall && pairtrawl plan my-hall/scene.toml -o my-hall/out")]
pub struct NewArguments {
    /// The folder to write `scene.toml` to; an existing scene is never overwritten
    #[arg(value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub directory: PathBuf,
}
