use crate::arguments::{Arguments, CompletionsArguments};
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output::{Done, Report};
use clap::CommandFactory;
use schemars::JsonSchema;
use serde::Serialize;

/// A completion script.
#[derive(Serialize, JsonSchema)]
pub struct CompletionsReport {
    /// The shell that it is for.
    shell: String,
    /// The script.
    script: String,
}

/// `pairtrawl completions`: the script for a shell.
pub fn completions(arguments: &CompletionsArguments) -> Result<Done, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(
        arguments.shell,
        &mut Arguments::command(),
        "pairtrawl",
        &mut script,
    );
    let script = String::from_utf8_lossy(&script).into_owned();
    let text = script.clone();
    let about = CompletionsReport {
        shell: arguments.shell.to_string(),
        script,
    };
    Report::new("completions", Exit::Done, about).done(Exit::Done, text, &[], &[])
}
