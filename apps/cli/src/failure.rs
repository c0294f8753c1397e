//! What the program says when it could not do its job, and which exit code each error of the library gets.

use crate::exit::Exit;
use pairtrawl::PlanError;
use pairtrawl::certificate::infeasibility::ProofKind;
use pairtrawl::files::FileError;
use pairtrawl::geometry::Point;
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

/// What a failure is about, for machines; what does not apply is left out.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct Details {
    /// The claim that fails in the best attempt.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub claim: Option<&'static str>,
    /// At which step.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step: Option<usize>,
    /// Where, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<[f64; 2]>,
    /// The same as `place`.
    #[serde(rename = "where", skip_serializing_if = "Option::is_none")]
    pub same_place: Option<[f64; 2]>,
    /// By how much, in the claim's unit; negative.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub margin: Option<f64>,
    /// The argument of a proof that there is no plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub proof: Option<&'static str>,
    /// What the proof says is needed: the least or, with `net_too_long`, the greatest net length in m, or a number of
    /// waypoints.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub needed: Option<f64>,
    /// The object that it is about: its index in the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub object: Option<usize>,
    /// The gap that is too narrow: its width, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// The time limit, s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<f64>,
    /// The stage that was at work.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stage: Option<String>,
    /// The file that it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// The line of it, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// Where the results of an earlier run were moved, so that nobody takes them for this one's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub set_aside: Option<String>,
}

impl Details {
    /// About a place, m.
    pub fn at(place: Option<Point>) -> Self {
        let place = place.map(<[f64; 2]>::from);
        Self {
            place,
            same_place: place,
            ..Self::default()
        }
    }

    /// The thing and the amount of a proof.
    fn of_proof(kind: &ProofKind) -> Self {
        let (proof, details) = match *kind {
            ProofKind::NetTooShort { needed } => ("net_too_short", Self::needing(needed)),
            ProofKind::NetTooLong { most } => ("net_too_long", Self::needing(most)),
            ProofKind::TooFewWaypoints { needed } => {
                ("too_few_waypoints", Self::needing(needed as f64))
            }
            ProofKind::WayCut { place, width } => (
                "way_cut",
                Self {
                    gap: Some(width),
                    ..Self::at(Some(place))
                },
            ),
            ProofKind::ObjectTooWide { object, needed } => (
                "object_too_wide",
                Self {
                    object: Some(object),
                    ..Self::needing(needed)
                },
            ),
            ProofKind::ObjectEnclosed { object } => (
                "object_enclosed",
                Self {
                    object: Some(object),
                    ..Self::default()
                },
            ),
            ProofKind::ObjectAtEdge { object, gap } => {
                ("object_at_edge", Self::beside(object, gap))
            }
            ProofKind::ObjectPinned { object, gap } => ("object_pinned", Self::beside(object, gap)),
            _ => ("other", Self::default()),
        };
        Self {
            proof: Some(proof),
            ..details
        }
    }

    fn needing(amount: f64) -> Self {
        Self {
            needed: Some(amount),
            ..Self::default()
        }
    }

    fn beside(object: usize, gap: f64) -> Self {
        Self {
            object: Some(object),
            gap: Some(gap),
            ..Self::default()
        }
    }
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
        let details = match &error {
            PlanError::NoPlan(missing) => Details {
                claim: missing.claim().map(|claim| claim.id.name()),
                step: missing.claim().and_then(|claim| claim.step),
                margin: missing.claim().map(|claim| claim.margin),
                ..Details::at(missing.place())
            },
            PlanError::Infeasible(infeasible) => (infeasible.proofs.first())
                .map_or_else(Details::default, |proof| Details::of_proof(&proof.kind)),
            PlanError::TimeLimit { limit, stage } => Details {
                limit: Some(*limit),
                stage: Some(stage.name().to_owned()),
                ..Details::default()
            },
            _ => Details::default(),
        };
        Self {
            help: error.remedy(),
            details: Box::new(details),
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
