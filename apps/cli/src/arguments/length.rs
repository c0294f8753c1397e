use super::Order;
use super::values::parse_length;
use clap::{Args, ValueHint};
use std::path::PathBuf;

/// `pairtrawl length`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl length hall/scene.toml --from 1.0 --to 3.0 --points 21 -o out/length

Number of waypoints, visiting order and sides are the same for every length. Writes length.json, length.csv, length.svg;
with --compare also separation.csv and separation.svg.")]
pub struct LengthArguments {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub scene: PathBuf,

    /// Least length in meters instead of the least that the ends allow
    #[arg(long, value_name = "L", value_parser = parse_length)]
    pub from: Option<f64>,

    /// Greatest length in meters
    #[arg(long, value_name = "L", value_parser = parse_length)]
    pub to: Option<f64>,

    /// How many lengths, evenly spaced
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=1000))]
    pub points: Option<u32>,

    /// Number of waypoints N instead of one that follows from the path length
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(3..=100_000))]
    pub waypoints: Option<u32>,

    /// Visiting order: the scene's own, or the shortest
    #[arg(long, value_enum)]
    pub order: Option<Order>,

    /// Also solve with the paper's two other rules for the separation (studies, no plans): none at all, and rigid
    #[arg(long)]
    pub compare: bool,

    /// Where to write, created when missing
    #[arg(short, long, value_name = "DIR", default_value = "out", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
}
