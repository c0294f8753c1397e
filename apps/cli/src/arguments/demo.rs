use super::PlanningArguments;
use clap::{Args, ValueHint};
use std::path::PathBuf;

/// `pairtrawl demo`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl demo -o demo        then open demo/report.html")]
pub struct DemoArguments {
    /// Where to write, created when missing
    #[arg(short, long, value_name = "DIR", default_value = "out/demo", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,

    /// Options of planning
    #[command(flatten)]
    pub planning: PlanningArguments,
}
