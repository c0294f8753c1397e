use clap::{Args, ValueHint};
use std::path::PathBuf;

/// `pairtrawl check`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  pairtrawl check hall/scene.toml out/plan.json
  pairtrawl check hall/scene.toml out/infeasible.json

Prints every claim with its margin, step and place; exit 6 when one fails. Plans from elsewhere are welcome: format,
net_length, left, right and step_time are enough. Of proofs that there is no plan each one is verified; exit 6 when one does
not hold.")]
pub struct CheckArguments {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub scene: PathBuf,

    /// The plan, a JSON file, or proofs that there is none
    #[arg(value_name = "PLAN", value_hint = ValueHint::FilePath)]
    pub plan: PathBuf,
}
