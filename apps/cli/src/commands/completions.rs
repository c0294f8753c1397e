use crate::arguments::{Arguments, CompletionsArguments};
use crate::exit::{Exit, Failure};
use crate::output::Done;
use clap::CommandFactory;
use serde_json::json;

/// `pairtrawl completions`: the script for a shell.
pub fn completions(arguments: &CompletionsArguments) -> Result<Done, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(
        arguments.shell,
        &mut Arguments::command(),
        "pairtrawl",
        &mut script,
    );
    let text = String::from_utf8_lossy(&script).into_owned();
    let object =
        json!({ "command": "completions", "shell": arguments.shell.to_string(), "script": text });
    Ok(Done {
        exit: Exit::Done,
        text,
        object,
    })
}
