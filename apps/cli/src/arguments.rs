//! The command line, as clap reads it.

mod bench_plan;
mod check;
mod completions;
mod demo;
#[cfg(feature = "rapier")]
mod engine;
mod export;
mod generate;
mod length;
mod monte_carlo;
mod new;
mod plan;
mod planning;
mod rehearse;
mod reproduce;
mod run;
mod schemas;
mod show;
mod values;

pub use bench_plan::BenchPlanArguments;
pub use check::CheckArguments;
pub use completions::CompletionsArguments;
pub use demo::DemoArguments;
pub use export::ExportArguments;
pub use generate::{GenerateArguments, Kind};
pub use length::LengthArguments;
pub use monte_carlo::{MonteCarloArguments, PlantsArgument};
pub use new::NewArguments;
pub use plan::PlanArguments;
pub use planning::{Order, PlanningArguments};
pub use rehearse::RehearseArguments;
pub use reproduce::ReproduceArguments;
pub use run::{Adapted, RunArguments};
pub use schemas::SchemasArguments;
pub use show::ShowArguments;
pub use values::name;

use clap::{Parser, Subcommand};

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
  pairtrawl show my-hall/scene.toml     a picture of it
  pairtrawl plan my-hall/scene.toml     plan it: plan.json, plan.csv, TUM files, plan.svg, report.html
  pairtrawl check my-hall/scene.toml out/plan.json

Exit codes: 0 done, 1 internal fault, 2 bad command line, 3 bad input file, 4 proven infeasible, 5 no certified plan
found, 6 a checked plan or proof is invalid or a plan to be driven cannot be proven, 7 an execution did not gather everything, 8 cannot read or write, 130 interrupted."
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
    /// Draw a scene before it is planned
    Show(ShowArguments),
    /// Plan the paper's simulation, embedded in the program
    Demo(DemoArguments),
    /// Drive a plan in physics: net, objects, contacts
    Rehearse(RehearseArguments),
    /// Drive a plan by controllers, in trials with noise, delay and unknown loads
    Run(Box<RunArguments>),
    /// Compare the control laws over many random plants
    MonteCarlo(MonteCarloArguments),
    /// Write a run for MuJoCo or Gazebo
    Export(ExportArguments),
    /// Cost of the best plan over the length of the net
    Length(LengthArguments),
    /// Make every experiment of the paper again and judge its claims
    Reproduce(ReproduceArguments),
    /// Make a scene: solvable by construction, with its solution, or litter as it lies on a map or in a hall
    Generate(GenerateArguments),
    /// Plan a folder of scenes and count: success, what is left, iterations, time, memory
    BenchPlan(BenchPlanArguments),
    /// Write a commented scene to start from
    New(NewArguments),
    /// Print a completion script for a shell
    Completions(CompletionsArguments),
    /// Write the JSON schemas of all files and of what commands print
    #[command(hide = true)]
    Schemas(SchemasArguments),
}

impl Command {
    /// Its name on the command line.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Plan(_) => "plan",
            Self::Check(_) => "check",
            Self::Show(_) => "show",
            Self::Demo(_) => "demo",
            Self::Rehearse(_) => "rehearse",
            Self::Run(_) => "run",
            Self::MonteCarlo(_) => "monte-carlo",
            Self::Export(_) => "export",
            Self::Length(_) => "length",
            Self::Reproduce(_) => "reproduce",
            Self::Generate(_) => "generate",
            Self::BenchPlan(_) => "bench-plan",
            Self::New(_) => "new",
            Self::Completions(_) => "completions",
            Self::Schemas(_) => "schemas",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Arguments;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }
}
