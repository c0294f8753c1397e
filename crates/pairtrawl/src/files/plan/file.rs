#[cfg(feature = "schema")]
use super::FORMAT;
use crate::files::parts::{FileClaim, FileCost, Reference};
#[cfg(feature = "schema")]
use pairtrawl_model::SolverStatus;
use serde::{Deserialize, Serialize};

/// A planned run. A reader needs `format`, `net_length`, `left` and `right`; Pairtrawl writes everything, believes nothing
/// beyond the trajectories and derives the rest again. `left[i]` and `right[i]` belong to the same instant; between
/// waypoints positions and headings are linear in time. SI units, radians, map frame.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct File {
    /// The format and its version.
    #[cfg_attr(feature = "schema", schemars(extend("const" = FORMAT)))]
    pub format: String,
    /// Length of the net, d_max, m.
    pub net_length: f64,
    /// Poses [x, y, heading] of the left robot, m and rad.
    #[cfg_attr(feature = "schema", schemars(length(min = 2)))]
    pub left: Vec<[f64; 3]>,
    /// Poses of the right robot, as many.
    #[cfg_attr(feature = "schema", schemars(length(min = 2)))]
    pub right: Vec<[f64; 3]>,
    /// Time from one waypoint to the next, s; left out: the scene's default.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_time: Option<f64>,
    /// When the smooth curve that the robots drive passes each waypoint, s from the start. A plan that has it holds its claims
    /// on that curve as well as with poses linear between waypoints.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_law: Option<Vec<f64>>,
    /// The scene that the plan is for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scene: Option<Reference>,
    /// What the command line changed against the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub overrides: Option<FileOverrides>,
    /// Centerline of the pair, as poses; empty when there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centerline: Option<Vec<[f64; 3]>>,
    /// The pair of trajectories that the optimization started from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub baseline: Option<Baseline>,
    /// Circles around the objects; close ones share one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub circles: Option<Vec<FileCircle>>,
    /// Visiting order: indices into `circles`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<Vec<usize>>,
    /// Objects that are left where they are, ascending: the claim `every_object_covered` is about all others. There only
    /// when something is left.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<FileLeftOut>,
    /// The paper's J of the two trajectories.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost: Option<FileCost>,
    /// The proof, claim by claim.
    #[serde(skip_deserializing, skip_serializing_if = "Option::is_none")]
    pub certificate: Option<FileCertificate>,
    /// What the simulated drive said. Never a proof.
    #[serde(
        default,
        deserialize_with = "if_readable",
        skip_serializing_if = "Option::is_none"
    )]
    pub rehearsal: Option<FileRehearsal>,
    /// How the optimization ended.
    #[serde(
        default,
        deserialize_with = "if_readable",
        skip_serializing_if = "Option::is_none"
    )]
    pub solver: Option<FileSolver>,
    /// Warnings for people.
    #[serde(skip_deserializing, skip_serializing_if = "Option::is_none")]
    pub warnings: Option<Vec<String>>,
}

/// What the command line changed against the scene.
#[derive(Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileOverrides {
    /// Length of the net, m, or `auto`: the planner chose it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub net_length: Option<FileNetLength>,
    /// What is done with objects that cannot be gathered.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub leave: Option<FileLeave>,
}

/// What is done with objects that cannot be gathered.
#[derive(Clone, Copy, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "lowercase")]
pub enum FileLeave {
    /// Nothing is left.
    None,
    /// They are left where they are.
    Unreachable,
}

/// An object that is left where it is.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileLeftOut {
    /// Its index in the scene.
    pub object: usize,
    /// On what grounds.
    pub why: FileLeftWhy,
    /// The reason in full, for people.
    #[serde(default)]
    pub text: String,
}

/// On what grounds an object is left.
#[derive(Clone, Copy, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "snake_case")]
pub enum FileLeftWhy {
    /// There is a proof that no plan can sweep it.
    Proven,
    /// No certified plan was found that includes it.
    NotFound,
}

#[derive(Clone, Copy, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(inline))]
#[serde(untagged)]
pub enum FileNetLength {
    Fixed(f64),
    Auto(Auto),
}

#[derive(Clone, Copy, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "lowercase")]
pub enum Auto {
    Auto,
}

/// A pair of trajectories.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Baseline {
    /// Poses of the left robot.
    pub left: Vec<[f64; 3]>,
    /// Poses of the right robot.
    pub right: Vec<[f64; 3]>,
}

/// A circle around one object or several close ones.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileCircle {
    /// Its center, m.
    pub center: [f64; 2],
    /// Its radius, m.
    pub radius: f64,
    /// Indices of the scene's objects inside.
    #[serde(default)]
    pub objects: Vec<usize>,
}

/// The proof.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileCertificate {
    /// True when every claim holds.
    pub valid: bool,
    /// The claims, in the order of `docs/formats/README.md`.
    pub claims: Vec<FileClaim>,
}

/// What another program may state in its own way: none when it is not as here.
fn if_readable<'de, T, D>(deserializer: D) -> Result<Option<T>, D::Error>
where
    T: serde::de::DeserializeOwned,
    D: serde::Deserializer<'de>,
{
    let value = serde_json::Value::deserialize(deserializer)?;
    Ok(serde_json::from_value(value).ok())
}

/// What the simulated drive said.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "status", rename_all = "lowercase")]
pub enum FileRehearsal {
    /// Every object was gathered, and nothing else was touched.
    Passed,
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
    /// There was no rehearsal.
    Skipped,
}

/// How the optimization ended.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileSolver {
    /// Its status; `not_stated` when the plan comes from elsewhere.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = SolverStatus::ALL.map(SolverStatus::name))))]
    pub status: String,
    /// Iterations of the last optimization.
    pub iterations: usize,
    /// Scaled error of the optimality conditions; null when it is not known.
    pub kkt_error: Option<f64>,
    /// Time spent on it, s. The only number in a plan that differs between runs.
    pub seconds: f64,
}
