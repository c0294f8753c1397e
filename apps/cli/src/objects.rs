//! Objects that the machine-readable output of several commands shares.

use crate::output::finite;
use pairtrawl::model::{ClaimId, ClaimSummary, Cost, LeftOut, LeftWhy, Rehearsal};
use schemars::JsonSchema;
use serde::Serialize;

/// The paper's J, term by term, weighted.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct CostObject {
    /// J, the sum of the other four.
    total: f64,
    /// J_s: second differences of x, y and heading of both robots.
    smoothness: f64,
    /// J_dist: driven distance and turning of both robots.
    distance: f64,
    /// J_obs: 0 on every valid plan.
    obstacle: f64,
    /// J_e: how far the net is opened or folded, summed over the waypoints.
    expansion: f64,
}

impl From<&Cost> for CostObject {
    fn from(cost: &Cost) -> Self {
        Self {
            total: cost.total(),
            smoothness: cost.smoothness,
            distance: cost.distance,
            obstacle: cost.obstacle,
            expansion: cost.expansion,
        }
    }
}

/// A claim of the certificate and the place where it is tightest.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ClaimObject {
    /// Which claim.
    #[schemars(extend("enum" = ClaimId::ALL.map(ClaimId::name)))]
    name: &'static str,
    /// True when it holds at every instant.
    holds: bool,
    /// How much room is left, negative when it fails; null when nothing bounds it.
    margin: Option<f64>,
    /// Unit of the margin; empty when it has none.
    unit: &'static str,
    /// The step or waypoint where it is tightest.
    step: Option<usize>,
    /// When it is tightest, s.
    time: Option<f64>,
    /// The place where it is tightest, m.
    #[serde(rename = "where")]
    place: Option<[f64; 2]>,
    /// What it is about there, for people.
    detail: String,
}

impl From<&ClaimSummary> for ClaimObject {
    fn from(summary: &ClaimSummary) -> Self {
        let claim = &summary.claim;
        Self {
            name: claim.id.name(),
            holds: claim.holds,
            margin: finite(claim.margin),
            unit: summary.unit,
            step: claim.step,
            time: summary.time,
            place: claim.place.map(<[f64; 2]>::from),
            detail: claim.detail.clone(),
        }
    }
}

/// An object that is left where it is.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct LeftOutObject {
    /// Its index in the scene.
    object: usize,
    /// On what grounds: a proof, or a search that found no plan with it.
    #[schemars(extend("enum" = LeftWhy::ALL.map(LeftWhy::name)))]
    why: &'static str,
    /// The reason in full, for people.
    text: String,
}

impl LeftOutObject {
    /// All that a plan leaves.
    pub fn all(left_out: &[LeftOut]) -> Vec<Self> {
        let objects = left_out.iter().map(|left| Self {
            object: left.object,
            why: left.why.name(),
            text: left.text.clone(),
        });
        objects.collect()
    }
}

/// What the simulated drive said. Never a proof.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(tag = "status", rename_all = "lowercase")]
pub enum RehearsalObject {
    /// Every object was gathered, and nothing else was touched.
    Passed,
    /// There was no rehearsal.
    Skipped,
    /// Something went wrong.
    Failed {
        /// What went wrong first, for people.
        event: String,
        /// When, s.
        time: f64,
        /// Where, m.
        #[serde(rename = "where")]
        place: [f64; 2],
    },
}

impl From<&Rehearsal> for RehearsalObject {
    fn from(rehearsal: &Rehearsal) -> Self {
        match rehearsal {
            Rehearsal::Passed => Self::Passed,
            Rehearsal::Skipped => Self::Skipped,
            Rehearsal::Failed { event, time, place } => Self::Failed {
                event: event.clone(),
                time: *time,
                place: (*place).into(),
            },
        }
    }
}
