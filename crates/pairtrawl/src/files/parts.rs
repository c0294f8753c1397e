//! Objects that several file formats share.

#[cfg(feature = "schema")]
use pairtrawl_model::ClaimId;
use pairtrawl_model::{Claim, Cost, SceneReference};
use serde::{Deserialize, Serialize};

/// A scene, by name and by hash.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Reference {
    /// Its name.
    #[serde(default)]
    pub name: String,
    /// SHA-256 of the scene file, then the map's YAML, then the map's image, as hexadecimal digits.
    pub sha256: String,
    /// SHA-256 of what these files say, whatever their comments and layout.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub content_sha256: Option<String>,
}

/// The paper's J, term by term, weighted.
#[derive(Clone, Copy, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct FileCost {
    /// J, the sum of the other four.
    pub total: f64,
    /// J_s: second differences of x, y and heading of both robots.
    pub smoothness: f64,
    /// J_dist: driven distance and turning of both robots.
    pub distance: f64,
    /// J_obs: 0 on every valid plan.
    pub obstacle: f64,
    /// J_e: how far the net is opened or folded, summed over the waypoints.
    pub expansion: f64,
}

/// A claim and the place where it is tightest.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileClaim {
    /// Which claim.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ClaimId::ALL.map(ClaimId::name))))]
    pub name: &'static str,
    /// True when it holds at every instant.
    pub holds: bool,
    /// How much room is left, in the claim's own unit, negative when it fails; null when nothing bounds it.
    pub margin: Option<f64>,
    /// The step or waypoint where it is tightest.
    pub step: Option<usize>,
    /// The place where it is tightest, m.
    #[serde(rename = "where")]
    pub place: Option<[f64; 2]>,
    /// What it is about there, for people.
    #[serde(skip_serializing_if = "String::is_empty")]
    #[cfg_attr(feature = "schema", schemars(default))]
    pub detail: String,
}

/// JSON has no infinity and no NaN.
pub fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

impl From<&SceneReference> for Reference {
    fn from(scene: &SceneReference) -> Self {
        Self {
            name: scene.name.clone(),
            sha256: scene.sha256.clone(),
            content_sha256: scene.content_sha256.clone(),
        }
    }
}

impl From<Reference> for SceneReference {
    fn from(scene: Reference) -> Self {
        Self {
            name: scene.name,
            sha256: scene.sha256,
            content_sha256: scene.content_sha256,
        }
    }
}

impl From<Cost> for FileCost {
    fn from(cost: Cost) -> Self {
        Self {
            total: cost.total(),
            smoothness: cost.smoothness,
            distance: cost.distance,
            obstacle: cost.obstacle,
            expansion: cost.expansion,
        }
    }
}

impl From<&Claim> for FileClaim {
    fn from(claim: &Claim) -> Self {
        Self {
            name: claim.id.name(),
            holds: claim.holds,
            margin: finite(claim.margin),
            step: claim.step,
            place: claim.place.map(Into::into),
            detail: claim.detail.clone(),
        }
    }
}
