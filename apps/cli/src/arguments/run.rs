#[cfg(feature = "rapier")]
use super::engine::EngineArgument;
use super::values::{parse_not_negative, parse_positive, parse_range};
use clap::{Args, ValueEnum, ValueHint};
use std::path::PathBuf;

/// `pairtrawl run`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  pairtrawl run hall/scene.toml out/plan.json                     five trials with the adaptive law
  pairtrawl run hall/scene.toml --controller model-based          plan first, then drive by the printed law
  pairtrawl run hall/scene.toml out/plan.json --object-mass 0.015:0.05 --trials 20 --seed 7

A range LOW:HIGH is drawn from evenly in each trial; one number stands for itself. Writes execution.json, report.html,
and run.mcap with metadata.yaml of the first trial: the folder is a rosbag2. Exit 7 when something was not gathered, 6 when
the plan cannot be proven (nothing is driven then, unless with --unproven). Ctrl-C keeps the finished trials.")]
pub struct RunArguments {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub scene: PathBuf,

    /// The plan, a JSON file; left out: the scene is planned first
    #[arg(value_name = "PLAN", value_hint = ValueHint::FilePath)]
    pub plan: Option<PathBuf>,

    /// The law that drives
    #[arg(long, value_enum, default_value_t = Controller::Mrac)]
    pub controller: Controller,

    /// How many drives
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub trials: u32,

    /// The same seed gives the same drives
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,

    /// Mass of each object, kg, instead of the scene's
    #[arg(long, value_name = "LOW:HIGH", value_parser = parse_range)]
    pub object_mass: Option<[f64; 2]>,

    /// Mass of all objects together, kg: scales their masses
    #[arg(long, value_name = "KG", value_parser = parse_positive)]
    pub payload: Option<f64>,

    /// Mass of the robots over the scene's
    #[arg(long, value_name = "LOW:HIGH", value_parser = parse_range)]
    pub robot_mass: Option<[f64; 2]>,

    /// Inertia of the robots over the scene's
    #[arg(long, value_name = "LOW:HIGH", value_parser = parse_range)]
    pub robot_inertia: Option<[f64; 2]>,

    /// Friction of net and objects on the floor over the scene's
    #[arg(long, value_name = "LOW:HIGH", value_parser = parse_range)]
    pub friction: Option<[f64; 2]>,

    /// Standard deviation of measured positions, m
    #[arg(long, value_name = "M", value_parser = parse_not_negative)]
    pub position_noise: Option<f64>,

    /// Standard deviation of measured headings, rad
    #[arg(long, value_name = "RAD", value_parser = parse_not_negative)]
    pub heading_noise: Option<f64>,

    /// Age of poses when they reach the controllers, s
    #[arg(long, value_name = "LOW:HIGH", value_parser = parse_range)]
    pub delay: Option<[f64; 2]>,

    /// Age of measured velocities when they reach the controllers, s
    #[arg(long, value_name = "LOW:HIGH", value_parser = parse_range)]
    pub velocity_delay: Option<[f64; 2]>,

    /// Velocity feedback K of the adaptive and the integral law, times the default
    #[arg(long, value_name = "FACTOR", value_parser = parse_positive)]
    pub feedback: Option<f64>,

    /// Rates of adaptation, or the integral gain, times the defaults
    #[arg(long, value_name = "FACTOR", value_parser = parse_not_negative)]
    pub rates: Option<f64>,

    /// What the adaptive law adapts: Delta_X, Delta_m, Delta_b; without any it is its velocity feedback alone
    #[arg(long, value_enum, value_name = "PARTS", value_delimiter = ',')]
    pub adapt: Option<Vec<Adapted>>,

    /// Inertia of the robot in the controllers' model
    #[arg(long, value_enum, value_name = "J", default_value_t = Inertia::Table)]
    pub nominal_inertia: Inertia,

    /// Greatest torque that controllers command to a wheel, N m, instead of the scene's
    #[arg(long, value_name = "NM", value_parser = parse_positive)]
    pub torque_limit: Option<f64>,

    /// Stop the pair when a robot is this far from its path, m, instead of 0.25
    #[arg(long, value_name = "M", value_parser = parse_positive)]
    pub stop_error: Option<f64>,

    /// Drive a plan even when it cannot be proven
    #[arg(long)]
    pub unproven: bool,

    /// Larger time steps for robots of less than 2 cm across; others take steps of 2 ms, a tick of the controllers, either way
    #[arg(long)]
    pub quick: bool,

    /// What computes the motion
    #[cfg(feature = "rapier")]
    #[arg(long, value_enum, default_value_t, value_name = "ENGINE")]
    pub engine: EngineArgument,

    /// Where to write, created when missing
    #[arg(short, long, value_name = "DIR", default_value = "out/run", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
}

/// Control laws.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Controller {
    /// The adaptive law, eqs. 25 to 30
    Mrac,
    /// Eq. 22 as printed
    ModelBased,
    /// Eq. 22 with integral velocity feedback
    Integral,
}

impl From<Controller> for pairtrawl::model::ControllerKind {
    fn from(controller: Controller) -> Self {
        match controller {
            Controller::Mrac => Self::Mrac,
            Controller::ModelBased => Self::ModelBased,
            Controller::Integral => Self::Integral,
        }
    }
}

/// What the adaptive law adapts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Adapted {
    /// Delta_X
    State,
    /// Delta_m
    Input,
    /// Delta_b
    Bias,
    /// Nothing
    None,
}

/// Inertia of the robot in the controllers' model.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Inertia {
    /// That of the paper's table, 0.146 kg m^2
    Table,
    /// The scene's
    Robot,
}

impl From<Inertia> for pairtrawl::execute::NominalInertia {
    fn from(inertia: Inertia) -> Self {
        match inertia {
            Inertia::Table => Self::PaperTable,
            Inertia::Robot => Self::Robot,
        }
    }
}
