use super::PlanningArguments;
use clap::{Args, ValueHint};
use std::path::PathBuf;

/// `pairtrawl plan`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  pairtrawl plan hall/scene.toml                        write to ./out
  pairtrawl plan hall/scene.toml -o runs/1              write to runs/1
  pairtrawl plan hall/scene.toml --net-length 2.0       with a net of 2 m, whatever the scene says
  pairtrawl plan hall/scene.toml --net-length auto      let the planner choose the net
  pairtrawl plan hall/scene.toml --json | jq .cost.total

A plan is written only when every claim of its certificate holds. Progress goes to the terminal only.")]
pub struct PlanArguments {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub scene: PathBuf,

    /// Options of planning
    #[command(flatten)]
    pub planning: PlanningArguments,

    /// Where to write, created when missing
    #[arg(short, long, value_name = "DIR", default_value = "out", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
}
