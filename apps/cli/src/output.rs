//! What a command says: text for people or one JSON object for machines, on standard output; failures on standard error.

use crate::exit::{Exit, Failure};
use serde_json::{Value, json};
use std::io::{self, Write};

/// What a command that did its job has to say.
pub struct Done {
    /// `Done`, or a verdict such as `Invalid`.
    pub exit: Exit,
    /// For people.
    pub text: String,
    /// For machines, an object; `ok` and `exit_code` are added.
    pub object: Value,
}

/// Prints the end of a command; an error only when it cannot be printed.
pub fn print(ended: &Result<Done, Failure>, json: bool) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    match ended {
        Ok(done) if json => {
            let mut object =
                json!({ "ok": done.exit == Exit::Done, "exit_code": done.exit.code() });
            if let (Value::Object(all), Value::Object(own)) = (&mut object, &done.object) {
                all.extend(own.clone());
            }
            writeln!(stdout, "{object}")?;
        }
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
pub fn report_panics(json: bool) {
    std::panic::set_hook(Box::new(move |panic| {
        let what = panic
            .payload_as_str()
            .map_or_else(|| "a panic without a message".to_owned(), str::to_owned);
        let place = panic
            .location()
            .map_or_else(String::new, |place| format!(" at {place}"));
        let failure = Failure::new(Exit::Internal, format!("internal fault{place}: {what}"))
            .with_remedy(
                "this is a defect of pairtrawl, not of your input; please report it with the scene",
            );
        let _ = print(&Err(failure), json);
        std::process::exit(Exit::Internal.code());
    }));
}

/// Warnings, one a line, as they are printed under a summary.
pub fn warnings(text: &mut String, warnings: &[impl std::fmt::Display]) {
    for warning in warnings {
        text.push_str(&format!("warning: {warning}\n"));
    }
}
