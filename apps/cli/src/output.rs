//! What a command says: text for people or one JSON object for machines, on standard output; failures on standard error.

use crate::exit::Exit;
use crate::failure::Failure;
use pairtrawl::model::Warning;
use schemars::JsonSchema;
use serde::Serialize;
use std::io::{self, Write};
use std::path::PathBuf;

/// What a command that did its job has to say.
#[derive(Debug)]
pub struct Done {
    /// `Done`, or a verdict such as `Invalid`.
    pub exit: Exit,
    /// For people.
    pub text: String,
    /// For machines: one JSON object on one line.
    pub json: String,
}

/// What a command prints with `--json`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Report<T> {
    /// True when the command did its job and its verdict is good: the exit code is 0.
    pub ok: bool,
    /// The exit code of the program.
    pub exit_code: i32,
    /// The command.
    pub command: &'static str,
    /// Name of the scene, when the command is about one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scene: Option<String>,
    /// What the command is about.
    #[serde(flatten)]
    pub about: T,
    /// Warnings for people.
    pub warnings: Vec<String>,
    /// The files that were written.
    pub files: Vec<String>,
}

/// Nothing beyond the files that were written.
#[derive(Debug, Serialize, JsonSchema)]
pub struct FilesAlone {}

impl<T: Serialize> Report<T> {
    /// A report without scene, warnings and files.
    pub fn new(command: &'static str, exit: Exit, about: T) -> Self {
        Self {
            ok: exit == Exit::Done,
            exit_code: exit.code(),
            command,
            scene: None,
            about,
            warnings: Vec::new(),
            files: Vec::new(),
        }
    }

    /// The same about a scene, by its name.
    pub fn scene(self, name: &str) -> Self {
        Self {
            scene: Some(name.to_owned()),
            ..self
        }
    }

    /// Ends the command: `text` for people, with warnings and files below it.
    pub fn done(
        mut self,
        exit: Exit,
        mut text: String,
        warnings: &[Warning],
        files: &[PathBuf],
    ) -> Result<Done, Failure> {
        for warning in warnings {
            text.push_str(&format!("warning: {warning}\n"));
        }
        let names: Vec<String> = files
            .iter()
            .map(|file| file.display().to_string())
            .collect();
        if !names.is_empty() {
            text.push_str(&format!("wrote {}\n", names.join(", ")));
        }
        self.warnings = warnings.iter().map(ToString::to_string).collect();
        self.files = names;
        let json = to_json(&self)?;
        Ok(Done { exit, text, json })
    }
}

/// One line of JSON.
pub fn to_json(object: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string(object).map_err(|error| {
        Failure::new(
            Exit::Internal,
            format!("cannot be written as JSON: {error}"),
        )
    })
}

/// JSON has no infinity and no NaN: null.
pub fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// Prints the end of a command; an error only when it cannot be printed.
pub fn print(ended: &Result<Done, Failure>, json: bool) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    match ended {
        Ok(done) if json => writeln!(stdout, "{}", done.json)?,
        Ok(done) => write!(stdout, "{}", done.text)?,
        Err(failure) => {
            if json {
                writeln!(stdout, "{}", failure.to_json())?;
            }
            // Nowhere to say that standard error is gone.
            let _ = writeln!(io::stderr(), "{failure}");
        }
    }
    stdout.flush()
}

/// Turns a panic, in any thread, into one message and exit code 1.
pub fn report_panics(command: &'static str, json: bool) {
    std::panic::set_hook(Box::new(move |panic| {
        let what = panic
            .payload_as_str()
            .map_or_else(|| "a panic without a message".to_owned(), str::to_owned);
        let place = panic
            .location()
            .map_or_else(String::new, |place| format!(" at {place}"));
        let failure = Failure::new(Exit::Internal, format!("internal fault{place}: {what}"))
            .with_help(
                "this is a defect of pairtrawl, not of your input; please report it with the scene",
            )
            .in_command(command);
        crate::earlier::set_aside();
        let _ = print(&Err(failure), json);
        std::process::exit(Exit::Internal.code());
    }));
}
