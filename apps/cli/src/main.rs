//! The program `pairtrawl`: arguments, progress, exit codes, files where the user wants them.

mod arguments;
mod commands;
mod exit;
mod interrupt;
mod output;
mod progress;
mod summary_text;
mod trials;

use arguments::{Arguments, Command};
use clap::Parser;
use exit::Exit;

fn main() {
    let arguments = Arguments::parse();
    output::report_panics(arguments.json);
    interrupt::install();
    let ended = match &arguments.command {
        Command::Plan(plan) => commands::plan(plan),
        Command::Check(check) => commands::check(check),
        Command::Demo(demo) => commands::demo(demo),
        Command::Rehearse(rehearse) => commands::rehearse(rehearse),
        Command::Run(run) => commands::run(run),
        Command::MonteCarlo(monte_carlo) => commands::monte_carlo(monte_carlo),
        Command::Export(export) => commands::export(export),
        Command::Length(length) => commands::length(length),
        Command::Generate(generate) => commands::generate(generate),
        Command::New(new) => commands::new(new),
        Command::Completions(completions) => commands::completions(completions),
    };
    // A reader that went away (`| head`) is no fault; anything else that cannot be printed is.
    let exit = match (output::print(&ended, arguments.json), ended) {
        (Err(error), _) if error.kind() != std::io::ErrorKind::BrokenPipe => Exit::Files,
        (_, Ok(done)) => done.exit,
        (_, Err(failure)) => failure.exit,
    };
    std::process::exit(exit.code());
}
