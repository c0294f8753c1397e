#[cfg(feature = "rapier")]
use super::engine::EngineArgument;
use clap::{Args, ValueHint};
use std::path::PathBuf;

/// `pairtrawl rehearse`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl rehearse hall/scene.toml out/plan.json -o out/rehearsal

Passes when the net touches no obstacle, no robot touches an object from outside or its partner, tension stays below
the scene's bound and every object lies in the net at the end; exit 7 when not. What is rehearsed is not proven.")]
pub struct RehearseArguments {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub scene: PathBuf,

    /// The plan, a JSON file
    #[arg(value_name = "PLAN", value_hint = ValueHint::FilePath)]
    pub plan: PathBuf,

    /// Where to write `report.html` with the run in motion; left out: nothing is written
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub output: Option<PathBuf>,

    /// Larger time steps: faster, good enough for runs without snags
    #[arg(long)]
    pub quick: bool,

    /// What computes the motion
    #[cfg(feature = "rapier")]
    #[arg(long, value_enum, default_value_t, value_name = "ENGINE")]
    pub engine: EngineArgument,
}
