use clap::{Args, ValueEnum, ValueHint};
use std::path::PathBuf;

/// What the laws drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PlantsArgument {
    /// Robots, net and objects in physics
    Full,
    /// Each robot alone, under a drag that grows
    Reduced,
}

impl PlantsArgument {
    /// The name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Reduced => "reduced",
        }
    }
}

/// `pairtrawl monte-carlo`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl monte-carlo hall/scene.toml out/plan.json --runs 1000

All laws drive the same runs: robots, net and objects in physics (robot mass x 0.5 to 3, objects that take 0 to 8 N to slide,
inertia +-50 %, pose noise 1 cm and 1 degree, delay 0 to 60 ms), or, with --physics reduced and some hundred times as fast,
each robot alone under a drag of 0 to 4 N. A run succeeds when neither robot leaves its path by more than 10 cm.")]
pub struct MonteCarloArguments {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub scene: PathBuf,

    /// The plan, a JSON file; left out: the scene is planned first
    #[arg(value_name = "PLAN", value_hint = ValueHint::FilePath)]
    pub plan: Option<PathBuf>,

    /// Runs for each law
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub runs: u32,

    /// The same seed gives the same runs
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,

    /// What the laws drive
    #[arg(long, value_name = "PHYSICS", value_enum, default_value_t = PlantsArgument::Full)]
    pub physics: PlantsArgument,

    /// Delay measured velocities as well as poses
    #[arg(long)]
    pub delayed_velocity: bool,

    /// Where to write `monte-carlo.json`; left out: nothing is written
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub output: Option<PathBuf>,
}
