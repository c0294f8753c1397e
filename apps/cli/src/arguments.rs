//! The command line, as clap reads it.

use clap::{Args, Parser, Subcommand, ValueEnum, ValueHint};
use std::path::PathBuf;

/// Two robots tow a net between them and gather what lies on the floor: plan the run, prove it, rehearse it.
#[derive(Debug, Parser)]
#[command(
    name = "pairtrawl",
    version,
    propagate_version = true,
    subcommand_required = true,
    arg_required_else_help = true,
    after_help = "Examples:
  pairtrawl demo                        plan the paper's simulation; no file needed
  pairtrawl new my-hall                 a commented scene to start from
  pairtrawl plan my-hall/scene.toml     plan it: plan.json, plan.csv, TUM files, plan.svg, report.html
  pairtrawl check my-hall/scene.toml out/plan.json

Exit codes: 0 done, 1 internal fault, 2 bad command line, 3 bad input file, 4 proven infeasible, 5 no certified plan
found, 6 a checked plan is invalid, 7 an execution did not gather everything, 8 cannot read or write, 130 interrupted."
)]
pub struct Arguments {
    /// Print one machine-readable JSON object on standard output instead of text
    #[arg(long, global = true)]
    pub json: bool,

    /// What to do
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Plan a scene and write the plan with its certificate
    Plan(PlanArguments),
    /// Prove a plan again from its scene and its two trajectories alone
    Check(CheckArguments),
    /// Plan the paper's simulation, embedded in the program
    Demo(DemoArguments),
    /// Drive a plan in physics: net, objects, contacts
    Rehearse(RehearseArguments),
    /// Cost of the best plan over the length of the net
    Length(LengthArguments),
    /// Make a scene that is solvable by construction, with its solution
    Generate(GenerateArguments),
    /// Write a commented scene to start from
    New(NewArguments),
    /// Print a completion script for a shell
    Completions(CompletionsArguments),
}

/// `pairtrawl plan`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  pairtrawl plan hall/scene.toml                        write to ./out
  pairtrawl plan hall/scene.toml -o runs/1              write to runs/1
  pairtrawl plan hall/scene.toml --net-length 2.0       with a net of 2 m, whatever the scene says
  pairtrawl plan hall/scene.toml --net-length auto      let the planner choose the net
  pairtrawl plan hall/scene.toml --json | jq .plan.cost

A plan is written only when every claim of its certificate holds. Progress goes to the terminal only.")]
pub struct PlanArguments {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub scene: PathBuf,

    /// How to plan
    #[command(flatten)]
    pub planning: PlanningArguments,

    /// Where to write, created when missing
    #[arg(short, long, value_name = "DIR", default_value = "out", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
}

/// How to plan: the options that `plan` and `demo` share.
#[derive(Clone, Debug, Args)]
pub struct PlanningArguments {
    /// Length of the net in metres instead of the scene's, or `auto`: the planner chooses it
    #[arg(long, value_name = "L|auto", value_parser = parse_net_length)]
    pub net_length: Option<pairtrawl::NetLength>,

    /// Number of waypoints N instead of one that follows from the path length
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(3..=1_000_000))]
    pub waypoints: Option<u32>,

    /// Visiting order: the scene's own, or the shortest
    #[arg(long, value_enum, default_value_t = Order::Shortest)]
    pub order: Order,

    /// Seed of whatever is random; planning with hybrid A* is not
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub seed: u64,

    /// Give up after so many seconds (exit 5, no plan is written)
    #[arg(long, value_name = "S", value_parser = parse_seconds)]
    pub time_limit: Option<f64>,

    /// Do not rehearse the plan in physics
    #[arg(long, conflicts_with = "require_rehearsal")]
    pub no_rehearsal: bool,

    /// Refuse a plan whose rehearsal fails (exit 5)
    #[arg(long)]
    pub require_rehearsal: bool,
}

/// `pairtrawl check`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl check hall/scene.toml out/plan.json

Prints every claim with its margin, step and place; exit 6 when one fails. Plans from elsewhere are welcome: format,
net_length, left, right and step_time are enough.")]
pub struct CheckArguments {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub scene: PathBuf,

    /// The plan, a JSON file
    #[arg(value_name = "PLAN", value_hint = ValueHint::FilePath)]
    pub plan: PathBuf,
}

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
}

/// `pairtrawl length`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl length hall/scene.toml --from 1.0 --to 3.0 --points 21 -o out/length

Number of waypoints, visiting order and sides are the same for every length. Writes length.json, length.csv, length.svg.")]
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
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(3..=1_000_000))]
    pub waypoints: Option<u32>,

    /// Visiting order: the scene's own, or the shortest
    #[arg(long, value_enum)]
    pub order: Option<Order>,

    /// Where to write, created when missing
    #[arg(short, long, value_name = "DIR", default_value = "out", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,
}

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

/// `pairtrawl demo`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl demo -o demo        then open demo/report.html")]
pub struct DemoArguments {
    /// Where to write, created when missing
    #[arg(short, long, value_name = "DIR", default_value = "out/demo", value_hint = ValueHint::DirPath)]
    pub output: PathBuf,

    /// How to plan
    #[command(flatten)]
    pub planning: PlanningArguments,
}

/// `pairtrawl new`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl new my-hall && pairtrawl plan my-hall/scene.toml -o my-hall/out")]
pub struct NewArguments {
    /// The folder to write `scene.toml` to; an existing scene is never overwritten
    #[arg(value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub directory: PathBuf,
}

/// `pairtrawl completions`.
#[derive(Debug, Args)]
#[command(after_help = "Example:
  pairtrawl completions bash > ~/.local/share/bash-completion/completions/pairtrawl")]
pub struct CompletionsArguments {
    /// The shell
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
}

/// Kinds of generated scenes.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Kind {
    /// Free bends through scattered obstacles
    Witness,
    /// Parallel lanes between walls
    Serpentine,
}

/// Visiting orders.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Order {
    /// As the objects stand in the scene
    Given,
    /// The shortest open path
    Shortest,
}

impl PlanningArguments {
    /// The same, as the library takes it.
    pub fn options(&self) -> pairtrawl::PlanOptions {
        use pairtrawl::RehearsalMode;
        pairtrawl::PlanOptions {
            net_length: self.net_length,
            waypoints: self.waypoints.map(|n| n as usize),
            order: self.order.into(),
            seed: self.seed,
            time_limit: self.time_limit.map(std::time::Duration::from_secs_f64),
            rehearsal: match (self.no_rehearsal, self.require_rehearsal) {
                (true, _) => RehearsalMode::Skip,
                (false, true) => RehearsalMode::Require,
                (false, false) => RehearsalMode::Report,
            },
            ..pairtrawl::PlanOptions::default()
        }
    }
}

impl From<Order> for pairtrawl::OrderMethod {
    fn from(order: Order) -> Self {
        match order {
            Order::Given => Self::Given,
            Order::Shortest => Self::Shortest,
        }
    }
}

/// Greatest net length that the command line takes, m.
const LONGEST_NET: f64 = 1000.0;

fn parse_net_length(text: &str) -> Result<pairtrawl::NetLength, String> {
    if text == "auto" {
        return Ok(pairtrawl::NetLength::Auto);
    }
    parse_length(text)
        .map(pairtrawl::NetLength::Fixed)
        .map_err(|error| format!("{error}, or `auto`"))
}

fn parse_length(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(length) if length > 0.0 && length <= LONGEST_NET => Ok(length),
        _ => Err(format!("give a length above 0 and up to {LONGEST_NET} m")),
    }
}

fn parse_seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if seconds > 0.0 && seconds <= 1e6 => Ok(seconds),
        _ => Err("give a number of seconds above 0 and up to 1000000".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn net_lengths_are_positive_finite_numbers_or_auto() {
        assert_eq!(parse_net_length("auto"), Ok(pairtrawl::NetLength::Auto));
        assert_eq!(
            parse_net_length("2.5"),
            Ok(pairtrawl::NetLength::Fixed(2.5))
        );
        for bad in ["", "0", "-1", "nan", "inf", "1e9", "2m", "Auto "] {
            assert!(parse_net_length(bad).is_err(), "{bad:?} was taken");
        }
    }

    #[test]
    fn time_limits_are_positive_and_finite() {
        assert_eq!(parse_seconds("0.5"), Ok(0.5));
        for bad in ["", "0", "-1", "nan", "inf", "1e7"] {
            assert!(parse_seconds(bad).is_err(), "{bad:?} was taken");
        }
    }
}
