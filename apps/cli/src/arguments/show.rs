use super::values::parse_net_length;
use clap::{Args, ValueHint};
use std::path::PathBuf;

/// `pairtrawl show`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  pairtrawl show hall/scene.toml                        write out/scene.svg
  pairtrawl show hall/scene.toml -o hall.svg            write hall.svg

The picture has everything that planning begins with: the map, numbered objects, their circles in the shortest order of
visits, start and end, and hollow what provably cannot be swept, with the least move that would help. Nothing is planned.")]
pub struct ShowArguments {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub scene: PathBuf,

    /// Length of the net in meters instead of the scene's, or `auto`: left open
    #[arg(long, value_name = "L|auto", value_parser = parse_net_length)]
    pub net_length: Option<pairtrawl::NetLength>,

    /// A folder, in which the picture is scene.svg, or a file that ends in .svg
    #[arg(short, long, value_name = "DIR|FILE", default_value = "out", value_hint = ValueHint::AnyPath)]
    pub output: PathBuf,
}
