use clap::{ArgGroup, Args, ValueHint};
use std::path::PathBuf;

/// `pairtrawl export`.
#[derive(Debug, Args)]
#[command(
    group = ArgGroup::new("formats").args(["mjcf", "sdf"]).required(true).multiple(true),
    after_help = "Example:
  pairtrawl export hall/scene.toml out/plan.json --mjcf hall.xml --sdf hall.sdf

Scene, robots, net and objects for MuJoCo (with the keyframe `start`) and for Gazebo."
)]
pub struct ExportArguments {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub scene: PathBuf,

    /// The plan, a JSON file
    #[arg(value_name = "PLAN", value_hint = ValueHint::FilePath)]
    pub plan: PathBuf,

    /// Write a MuJoCo model
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub mjcf: Option<PathBuf>,

    /// Write a Gazebo world
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub sdf: Option<PathBuf>,
}
