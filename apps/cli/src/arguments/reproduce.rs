use clap::{Args, ValueHint};
use std::path::PathBuf;

/// `pairtrawl reproduce`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  pairtrawl reproduce -o out/reproduction
  pairtrawl reproduce --quick
  pairtrawl reproduce --authors-data tethered-data

Writes reproduction.html, one page without any external resource, and reproduction.json with the verdicts and the numbers that
they follow from. Ctrl-C keeps what is finished in the subfolder `unfinished`: the same command goes on from there. The scenes
are part of the program. With the authors' published trajectories (experiment_traj.csv, simulation_traj.csv,
experiment_tracked_right.csv) their plans are judged and driven as well.")]
pub struct ReproduceArguments {
    /// Fewer lengths, seeds and variants: under two minutes
    #[arg(long)]
    pub quick: bool,

    /// The folder with the trajectories that the paper's authors published
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub authors_data: Option<PathBuf>,

    /// Make these parts only, by the names of their sections on the page
    #[arg(long, value_name = "PART", value_delimiter = ',')]
    pub only: Vec<String>,

    /// Where to write, created when missing
    #[arg(short, long, value_name = "DIR", default_value = "out/reproduction", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
}
