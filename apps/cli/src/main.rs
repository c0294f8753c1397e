//! The program `pairtrawl`: arguments, progress, exit codes, files where the user wants them.

mod arguments;
mod bench;
mod commands;
mod details;
mod earlier;
mod exit;
mod failed;
mod failure;
mod interrupt;
mod objects;
mod output;
mod plan_text;
mod progress;
mod reproduce;
mod results;
mod trials;

use arguments::{Arguments, Command};
use clap::Parser;
use clap::error::ErrorKind;
use exit::Exit;
use failure::Failure;

fn main() {
    let arguments = Arguments::try_parse().unwrap_or_else(|error| refuse(&error));
    let command = arguments.command.name();
    output::report_panics(command, arguments.json);
    interrupt::install();
    let ended = match &arguments.command {
        Command::Plan(plan) => commands::plan(plan),
        Command::Check(check) => commands::check(check),
        Command::Demo(demo) => commands::demo(demo),
        Command::Show(show) => commands::show(show),
        Command::Rehearse(rehearse) => commands::rehearse(rehearse),
        Command::Run(run) => commands::run(run),
        Command::MonteCarlo(monte_carlo) => commands::monte_carlo(monte_carlo),
        Command::Export(export) => commands::export(export),
        Command::Length(length) => commands::length(length),
        Command::Reproduce(reproduce) => commands::reproduce(reproduce),
        Command::Generate(generate) => commands::generate(generate),
        Command::BenchPlan(bench) => commands::bench_plan(bench),
        Command::New(new) => commands::new(new),
        Command::Completions(completions) => commands::completions(completions),
        Command::Schemas(schemas) => commands::schemas(schemas),
    };
    let ended = ended.map_err(|failure| failure.in_command(command));
    // A reader that went away (`| head`) is no fault; anything else that cannot be printed is.
    let exit = match (output::print(&ended, arguments.json), ended) {
        (Err(error), _) if error.kind() != std::io::ErrorKind::BrokenPipe => Exit::Files,
        (_, Ok(done)) => done.exit,
        (_, Err(failure)) => failure.exit,
    };
    std::process::exit(exit.code());
}

/// Ends the program on a command line that asks for help or is not understood; with `--json` the latter is an object too.
fn refuse(error: &clap::Error) -> ! {
    let asks = matches!(
        error.kind(),
        ErrorKind::DisplayHelp
            | ErrorKind::DisplayVersion
            | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
    );
    if asks || !std::env::args_os().any(|argument| argument == "--json") {
        error.exit();
    }
    let message = error.to_string();
    let message = message.trim().trim_start_matches("error: ");
    let _ = output::print(&Err(Failure::new(Exit::Usage, message)), true);
    std::process::exit(Exit::Usage.code());
}
