use clap::{Args, ValueEnum, ValueHint};
use std::path::PathBuf;

/// `pairtrawl generate`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl generate --kind witness --difficulty 7 --seed 42 -n 300 -o scenes/mine

Writes scene.toml and witness.json, a plan that passes every claim: it shows that the scene can be done.")]
pub struct GenerateArguments {
    /// Free bends through scattered obstacles, or a hall of lanes
    #[arg(long, value_enum, default_value_t = Kind::Witness)]
    pub kind: Kind,

    /// From 1, roomy, to 10, within millimeters of what can be done
    #[arg(long, value_name = "D", default_value_t = 5, value_parser = clap::value_parser!(u8).range(1..=10))]
    pub difficulty: u8,

    /// The same seed gives the same scene
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub seed: u64,

    /// Waypoints of the witness, about 4 cm of driving each
    #[arg(short = 'n', long, value_name = "N", default_value_t = 200, value_parser = clap::value_parser!(u32).range(60..=50_000))]
    pub waypoints: u32,

    /// Where to write, created when missing
    #[arg(short, long, value_name = "DIR", default_value = "out/scene", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
}

/// Kinds of generated scenes.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Kind {
    /// Free bends through scattered obstacles
    Witness,
    /// Parallel lanes between walls
    Serpentine,
}
