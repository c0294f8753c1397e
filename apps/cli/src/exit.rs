//! How the program ends: its exit codes, and what it says when it could not do its job.

use serde_json::{Value, json};
use std::fmt;

/// The exit codes, the same for every command. `Done` is 0, and clap ends with 2 on a bad command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Exit {
    /// Done.
    Done = 0,
    /// A fault of the program.
    Internal = 1,
    /// A bad command line.
    Usage = 2,
    /// A bad input file.
    BadInput = 3,
    /// Proven infeasible.
    Infeasible = 4,
    /// No certified plan within the budget.
    NoPlan = 5,
    /// A checked plan is invalid.
    Invalid = 6,
    /// An execution did not gather everything.
    NotGathered = 7,
    /// A file cannot be read or written for reasons outside it.
    Files = 8,
    /// Interrupted.
    Interrupted = 130,
}

impl Exit {
    /// The number that the shell sees.
    pub fn code(self) -> i32 {
        i32::from(self as u8)
    }

    /// Its name in machine-readable output.
    pub fn name(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Internal => "internal",
            Self::Usage => "usage",
            Self::BadInput => "bad_input",
            Self::Infeasible => "infeasible",
            Self::NoPlan => "no_plan",
            Self::Invalid => "invalid",
            Self::NotGathered => "not_gathered",
            Self::Files => "files",
            Self::Interrupted => "interrupted",
        }
    }
}

/// Why a command could not do its job.
#[derive(Clone, Debug)]
pub struct Failure {
    /// The exit code.
    pub exit: Exit,
    /// One clear message: file, field, value, bound.
    pub message: String,
    /// What to do about it.
    pub remedy: Option<String>,
    /// More for machines.
    pub details: Value,
}

impl Failure {
    /// A failure with a message alone.
    pub fn new(exit: Exit, message: impl Into<String>) -> Self {
        Self {
            exit,
            message: message.into(),
            remedy: None,
            details: Value::Null,
        }
    }

    /// The same with a remedy.
    pub fn with_remedy(self, remedy: impl Into<String>) -> Self {
        Self {
            remedy: Some(remedy.into()),
            ..self
        }
    }

    /// As an object for machines.
    pub fn to_json(&self) -> Value {
        let mut error = json!({ "kind": self.exit.name(), "message": self.message });
        if let Some(remedy) = &self.remedy {
            error["remedy"] = json!(remedy);
        }
        if !self.details.is_null() {
            error["details"] = self.details.clone();
        }
        json!({ "ok": false, "exit_code": self.exit.code(), "error": error })
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "error: {}", self.message)?;
        if let Some(remedy) = &self.remedy {
            write!(f, "\n  help: {remedy}")?;
        }
        Ok(())
    }
}
