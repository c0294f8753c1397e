use super::PlanningArguments;
use clap::{Args, ValueHint};
use std::path::PathBuf;

/// `pairtrawl bench-plan`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl bench-plan scenes --jobs 2 --no-rehearsal --time-limit 60

Plans every scene below the folder, each by a process of its own, makes the certificate of every plan again from its
files, and prints success, what is left, iterations, time and memory for each group of scenes; a group is a scene's name
without the number at its end. Writes bench.json, bench.html, and for each scene what `pairtrawl plan` writes. Ctrl-C
keeps what is done. Exit code 0 when all scenes were planned, whatever became of them; 6 when a certificate does not hold.")]
pub struct BenchPlanArguments {
    /// The folder; every .toml file below it is a scene
    #[arg(value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub folder: PathBuf,

    /// Scenes that are planned at once, the cores shared among them; left out: one for each core
    #[arg(short, long, value_name = "J", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,

    /// Where to write, created when missing
    #[arg(short, long, value_name = "DIR", default_value = "out/bench", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,

    /// How each scene is planned
    #[command(flatten)]
    pub planning: PlanningArguments,
}
