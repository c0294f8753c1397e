//! What the program says when it could not do its job, and which exit code each error of the library gets.

use crate::details::Details;
use crate::exit::Exit;
use pairtrawl::PlanError;
use pairtrawl::files::FileError;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// Why a command could not do its job.
#[derive(Clone, Debug)]
pub struct Failure {
    /// The exit code.
    pub exit: Exit,
    /// The command, where it is known.
    pub command: Option<&'static str>,
    /// The scene's name, once it was read.
    pub scene: Option<String>,
    /// One clear message: file, field, value, bound.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
    /// More for machines.
    pub details: Box<Details>,
}

/// What a command that failed prints with `--json`.
#[derive(Serialize, JsonSchema)]
pub struct FailureReport<'a> {
    /// Always false.
    #[schemars(extend("const" = false))]
    ok: bool,
    /// The exit code of the program.
    exit_code: i32,
    /// The command; left out when the command line was not understood.
    #[serde(skip_serializing_if = "Option::is_none")]
    command: Option<&'static str>,
    /// Name of the scene; left out when no scene was read.
    #[serde(skip_serializing_if = "Option::is_none")]
    scene: Option<&'a str>,
    /// One clear message: file, field, value, bound.
    message: &'a str,
    /// What to do about it.
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<&'a str>,
    /// What it is about.
    details: &'a Details,
    /// The same in the first version's words.
    error: ErrorObject<'a>,
}

/// A failure as programs read it before `message`, `help` and `details` stood outside.
#[derive(Serialize, JsonSchema)]
struct ErrorObject<'a> {
    /// Name of the exit code.
    kind: &'static str,
    /// As `message`.
    message: &'a str,
    /// As `help`.
    #[serde(skip_serializing_if = "Option::is_none")]
    remedy: Option<&'a str>,
    /// As `details`.
    details: &'a Details,
}

impl Failure {
    /// A failure with a message alone.
    pub fn new(exit: Exit, message: impl Into<String>) -> Self {
        Self {
            exit,
            command: None,
            scene: None,
            message: message.into(),
            help: None,
            details: Box::default(),
        }
    }

    /// The same with what to do about it.
    pub fn with_help(self, help: impl Into<String>) -> Self {
        Self {
            help: Some(help.into()),
            ..self
        }
    }

    /// The same in a command.
    pub fn in_command(self, command: &'static str) -> Self {
        Self {
            command: Some(command),
            ..self
        }
    }

    /// The same about a scene, by its name.
    pub fn about(self, scene: &str) -> Self {
        Self {
            scene: Some(scene.to_owned()),
            ..self
        }
    }

    /// One line of JSON.
    pub fn to_json(&self) -> String {
        let help = self.help.as_deref();
        let report = FailureReport {
            ok: false,
            exit_code: self.exit.code(),
            command: self.command,
            scene: self.scene.as_deref(),
            message: &self.message,
            help,
            details: &self.details,
            error: ErrorObject {
                kind: self.exit.name(),
                message: &self.message,
                remedy: help,
                details: &self.details,
            },
        };
        // Only maps with keys other than strings cannot be JSON, and there are no maps here.
        serde_json::to_string(&report).unwrap_or_default()
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "error: {}", self.message)?;
        if let Some(help) = &self.help {
            write!(f, "\n  help: {help}")?;
        }
        if !self.details.files.is_empty() {
            write!(f, "\n  wrote {}", self.details.files.join(", "))?;
        }
        if let Some(folder) = &self.details.set_aside {
            write!(
                f,
                "\n  note: the results of an earlier run were moved to {folder}"
            )?;
        }
        Ok(())
    }
}

impl From<PlanError> for Failure {
    fn from(error: PlanError) -> Self {
        let exit = match &error {
            PlanError::BadInput { .. } => Exit::BadInput,
            PlanError::Infeasible { .. } => Exit::Infeasible,
            PlanError::NoPlan { .. } | PlanError::TimeLimit { .. } => Exit::NoPlan,
            PlanError::Interrupted => Exit::Interrupted,
        };
        Self {
            help: error.remedy(),
            details: Box::new(Details::of(&error)),
            ..Self::new(exit, error.to_string())
        }
    }
}

impl From<FileError> for Failure {
    fn from(error: FileError) -> Self {
        let exit = if error.is_from_system() {
            Exit::Files
        } else {
            Exit::BadInput
        };
        let details = Details {
            file: Some(error.path.display().to_string()),
            line: error.line,
            ..Details::default()
        };
        Self {
            details: Box::new(details),
            ..Self::new(exit, error.to_string())
        }
    }
}
