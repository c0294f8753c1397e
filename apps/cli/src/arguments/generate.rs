use crate::arguments::values::{parse_not_negative, parse_size};
use clap::{Args, ValueEnum, ValueHint};
use std::path::PathBuf;

/// `pairtrawl generate`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  pairtrawl generate --kind witness --difficulty 7 --seed 42 -n 300 -o scenes/mine
  pairtrawl generate --kind litter --map house/map.yaml --objects 12 --near 0.62 -o scenes/house
  pairtrawl generate --kind hall --size 15x10 --objects 40 --obstacles 3 -o scenes/hall

witness and serpentine: writes scene.toml and witness.json, a plan that passes every claim: it shows that the scene can
be done. litter and hall: writes scene.toml, and a copy of the map; nobody built these scenes to be solvable.")]
pub struct GenerateArguments {
    /// Solvable by construction: free bends, a hall of lanes. As litter lies: on a map, in an open hall
    #[arg(long, value_enum, default_value_t = Kind::Witness)]
    pub kind: Kind,

    /// From 1, roomy, to 10, within millimeters of what can be done; witness and serpentine only [default: 5]
    #[arg(long, value_name = "D", value_parser = clap::value_parser!(u8).range(1..=10))]
    pub difficulty: Option<u8>,

    /// The same seed gives the same scene
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub seed: u64,

    /// Waypoints of the witness, about 4 cm of driving each [default: 200]
    #[arg(short = 'n', long, value_name = "N", value_parser = clap::value_parser!(u32).range(60..=50_000))]
    pub waypoints: Option<u32>,

    /// The ROS map on whose floor the litter lies, a map_server YAML file; litter only
    #[arg(long, value_name = "MAP", value_hint = ValueHint::FilePath)]
    pub map: Option<PathBuf>,

    /// Width and depth of the hall, m; hall only [default: 15x10]
    #[arg(long, value_name = "WxD", value_parser = parse_size)]
    pub size: Option<[f64; 2]>,

    /// How many boxes stand in the hall; hall only [default: 3]
    #[arg(long, value_name = "K", value_parser = clap::value_parser!(u32).range(0..=1000))]
    pub obstacles: Option<u32>,

    /// How many objects lie on the floor; litter and hall only [default: 12]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub objects: Option<u32>,

    /// What every object's center keeps from walls at least, m; litter and hall only [default: 0.62]
    #[arg(long, value_name = "M", value_parser = parse_not_negative)]
    pub near: Option<f64>,

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
    /// Litter on the floor of a map
    Litter,
    /// Litter in an open hall with a few boxes
    Hall,
}
