use clap::{Args, ValueHint};
use std::path::PathBuf;

/// `pairtrawl schemas`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  cargo run -- schemas docs/formats")]
pub struct SchemasArguments {
    /// Where to write, created when missing
    #[arg(value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub directory: PathBuf,
}
