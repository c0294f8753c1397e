//! What a failure is about, for machines.

use pairtrawl::certificate::infeasibility::{Proof, ProofKind};
use pairtrawl::geometry::Point;
use pairtrawl::{NotFound, PlanError, Tried};
use schemars::JsonSchema;
use serde::Serialize;

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
    /// All proofs, one that is not about an object first, then the objects that cannot be swept.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub proofs: Vec<ProofObject>,
    /// Every start that was tried, and what was missing there.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tried: Vec<TriedObject>,
    /// Objects without which there is a certified plan.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub could_leave: Vec<usize>,
    /// The files that were written about the failure.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<String>,
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

/// A proof that there is no plan, or none that gathers an object.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ProofObject {
    /// The argument.
    kind: &'static str,
    /// The object that it is about; left out when it is not about one.
    #[serde(skip_serializing_if = "Option::is_none")]
    object: Option<usize>,
    /// The proof for people, with the least change that would help.
    text: String,
}

/// A start that led to no certified plan.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct TriedObject {
    /// The start.
    start: String,
    /// What was missing.
    message: String,
}

impl From<&Proof> for ProofObject {
    fn from(proof: &Proof) -> Self {
        Self {
            kind: proof.kind.name(),
            object: proof.object(),
            text: proof.message.clone(),
        }
    }
}

impl Details {
    /// What an error of planning is about.
    pub fn of(error: &PlanError) -> Self {
        match error {
            PlanError::NoPlan(not_found) => Self::of_search(not_found),
            PlanError::Infeasible(infeasible) => Self::of_proofs(&infeasible.proofs),
            PlanError::TimeLimit { limit, stage } => Self {
                limit: Some(*limit),
                stage: Some(stage.name().to_owned()),
                ..Self::default()
            },
            PlanError::BadInput(_) | PlanError::Interrupted => Self::default(),
        }
    }

    fn of_search(not_found: &NotFound) -> Self {
        let claim = not_found.missing.claim();
        let tried = |tried: &Tried| TriedObject {
            start: tried.start.clone(),
            message: tried.missing.to_string(),
        };
        Self {
            claim: claim.map(|claim| claim.id.name()),
            step: claim.and_then(|claim| claim.step),
            margin: claim.map(|claim| claim.margin),
            tried: not_found.tried.iter().map(tried).collect(),
            could_leave: not_found.could_leave.clone(),
            ..Self::at(not_found.missing.place())
        }
    }

    /// The thing and the amount of the first proof, and all of them.
    fn of_proofs(proofs: &[Proof]) -> Self {
        Self {
            proofs: proofs.iter().map(ProofObject::from).collect(),
            ..(proofs.first()).map_or_else(Self::default, |first| Self::of_proof(&first.kind))
        }
    }

    /// About a place, m.
    pub fn at(place: Option<Point>) -> Self {
        let place = place.map(<[f64; 2]>::from);
        Self {
            place,
            same_place: place,
            ..Self::default()
        }
    }

    fn of_proof(kind: &ProofKind) -> Self {
        let details = match *kind {
            ProofKind::NetTooShort { needed, .. } => Self::needing(needed),
            ProofKind::NetTooLong { most, .. } => Self::needing(most),
            ProofKind::TooFewWaypoints { needed, .. } => Self::needing(needed as f64),
            ProofKind::WayCut { place, width, .. } => Self {
                gap: Some(width),
                ..Self::at(Some(place))
            },
            ProofKind::ObjectTooWide { object, needed, .. } => Self {
                object: Some(object),
                ..Self::needing(needed)
            },
            ProofKind::ObjectEnclosed { object, .. } => Self {
                object: Some(object),
                ..Self::default()
            },
            ProofKind::ObjectAtEdge { object, gap, .. }
            | ProofKind::ObjectPinned { object, gap, .. } => Self {
                object: Some(object),
                gap: Some(gap),
                ..Self::default()
            },
        };
        Self {
            proof: Some(kind.name()),
            ..details
        }
    }

    fn needing(amount: f64) -> Self {
        Self {
            needed: Some(amount),
            ..Self::default()
        }
    }
}
