#[cfg(feature = "schema")]
use super::FORMAT;
use crate::files::parts::{FileClaim, FileCost, Reference};
#[cfg(feature = "schema")]
use pairtrawl_model::ControllerKind;
use serde::Serialize;

/// Drives of one plan by controllers in the simulated world. SI units, radians, map frame. A quantile of nothing is null.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct File {
    /// The format and its version.
    #[cfg_attr(feature = "schema", schemars(extend("const" = FORMAT)))]
    pub format: &'static str,
    /// The scene.
    pub scene: Reference,
    /// The control law.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ControllerKind::ALL.map(ControllerKind::name))))]
    pub controller: &'static str,
    /// Length of the net, m.
    pub net_length: f64,
    /// The smooth curve that the controllers follow.
    pub reference: FileReference,
    /// What was asked for: with these options the same drives come out again.
    pub options: FileOptions,
    /// Objects that the plan leaves where they are, ascending: no drive is to gather them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(feature = "schema", schemars(default))]
    pub left: Vec<usize>,
    /// How many drives were asked for.
    pub trials_wanted: usize,
    /// True when it was stopped before all of them were finished.
    pub interrupted: bool,
    /// What came of all finished drives together.
    pub summary: ExecutionFigures,
    /// The finished drives.
    pub trials: Vec<FileTrial>,
    /// Warnings for people.
    pub warnings: Vec<String>,
}

/// The smooth curve that the controllers follow.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileReference {
    /// Time from start to end, s.
    pub duration: f64,
    /// True when every claim of the certificate holds on it.
    pub valid: bool,
    /// These claims.
    pub claims: Vec<FileClaim>,
}

/// What was asked for. Pairs are the bounds between which a value is drawn evenly in each trial.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileOptions {
    /// Seed of everything that is random.
    pub seed: u64,
    /// Mass of the robots over the scene's.
    pub robot_mass: [f64; 2],
    /// Inertia of the robots over the scene's.
    pub robot_inertia: [f64; 2],
    /// Mass of each object, kg; null: the scene's.
    pub object_mass: Option<[f64; 2]>,
    /// Mass of all objects together, kg; null: as they are.
    pub payload: Option<f64>,
    /// Friction of net and objects on the floor over the scene's.
    pub friction: [f64; 2],
    /// Age of poses when they reach the controllers, s.
    pub pose_delay: [f64; 2],
    /// Age of measured velocities when they reach the controllers, s.
    pub velocity_delay: [f64; 2],
    /// Measured over true speed.
    pub odometry_scale: [f64; 2],
    /// Standard deviation of measured positions, m.
    pub position_noise: f64,
    /// Standard deviation of measured headings, rad.
    pub heading_noise: f64,
    /// Time step of the physics, s.
    pub time_step: f64,
    /// Velocity feedback K over the default.
    pub feedback: f64,
    /// Rates of adaptation, or the integral gain, over the defaults.
    pub rates: f64,
    /// Whether Delta_X, Delta_m and Delta_b of the adaptive law adapt.
    pub adapts: [bool; 3],
    /// Greatest torque that controllers command to a wheel, N m; null: the scene's.
    pub torque_limit: Option<f64>,
    /// Inertia in the controllers' model: that of the paper's table or that of the scene's robot.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["table", "robot"])))]
    pub nominal_inertia: &'static str,
    /// The pair is stopped when a robot is this far from its reference, m.
    pub stop_error: f64,
}

/// What came of all finished drives together. Errors are those of the worse robot of each drive.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ExecutionFigures {
    /// Finished drives.
    pub(super) trials: usize,
    /// Of these, how many gathered every object.
    pub(super) gathered_everything: usize,
    /// Their share; null without drives.
    pub(super) gathered_rate: Option<f64>,
    /// Drives in which nothing went wrong.
    pub(super) without_events: usize,
    /// Root mean square of the position error over the whole drive, m.
    pub(super) rms: Quantiles,
    /// Greatest position error over the whole drive, m.
    pub(super) max: Quantiles,
    /// Root mean square of the position error after the first second, m.
    pub(super) settled_rms: Quantiles,
    /// Greatest position error after the first second, m.
    pub(super) settled_max: Quantiles,
    /// The paper's J on the driven paths.
    pub(super) cost: Quantiles,
}

/// The median, the 90 % quantile and the greatest of the drives' values; null without drives.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Quantiles {
    /// 50 % of the drives have no more.
    pub(super) median: Option<f64>,
    /// 90 % of the drives have no more.
    pub(super) p90: Option<f64>,
    /// The greatest.
    pub(super) greatest: Option<f64>,
}

/// One drive.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileTrial {
    /// 0 for the first.
    pub index: usize,
    /// Seed of everything random in it.
    pub seed: u64,
    /// The control law.
    pub controller: &'static str,
    /// What was drawn for it.
    pub conditions: FileConditions,
    /// For each object of the scene: true when it lies in the net at the end.
    pub gathered: Vec<bool>,
    /// What should not have happened and did, in order of time.
    pub events: Vec<FileEvent>,
    /// Position errors against the reference.
    pub tracking: Sides<FileTracking>,
    /// The paper's J on the driven path.
    pub cost: FileCost,
    /// Force of net and contacts on each robot.
    pub drag: Sides<FileDrag>,
    /// Greatest torque of a wheel, N m.
    pub max_torque: Sides<f64>,
    /// How it ended.
    #[serde(rename = "final")]
    pub end: FileEnd,
    /// Simulated time, s.
    pub duration: f64,
    /// Time it took to compute, s. The only number that differs between runs.
    pub seconds: f64,
}

/// A value for each robot.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Sides<T> {
    /// The left robot's.
    pub left: T,
    /// The right robot's.
    pub right: T,
}

/// What was drawn for a drive.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileConditions {
    /// Mass of the robots over the scene's.
    pub robot_mass_factor: f64,
    /// Inertia of the robots over the scene's.
    pub robot_inertia_factor: f64,
    /// Mass of each object, kg.
    pub object_masses: Vec<f64>,
    /// Friction of net and objects on the floor over the scene's.
    pub friction_factor: f64,
    /// Age of poses when they reach the controllers, s.
    pub pose_delay: f64,
    /// Age of measured velocities when they reach the controllers, s.
    pub velocity_delay: f64,
    /// Measured over true speed of the left and the right robot.
    pub odometry_scale: [f64; 2],
}

/// Something that should not have happened.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileEvent {
    /// When, s.
    pub time: f64,
    /// Where, m.
    #[serde(rename = "where")]
    pub place: [f64; 2],
    /// What, for people.
    pub event: String,
}

/// Position error of a robot against the reference.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileTracking {
    /// Root mean square over the whole drive, m.
    pub rms: f64,
    /// Greatest over the whole drive, m.
    pub max: f64,
    /// Root mean square after the first second, m.
    pub settled_rms: f64,
    /// Greatest after the first second, m.
    pub settled_max: f64,
}

/// Force of net and contacts on a robot, averaged over 20 ms.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileDrag {
    /// Mean, N.
    pub mean: f64,
    /// Greatest, N.
    pub max: f64,
}

/// How a drive ended.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileEnd {
    /// Pose of the left robot.
    pub left: Option<[f64; 3]>,
    /// Pose of the right robot.
    pub right: Option<[f64; 3]>,
    /// The net, from the left hitch to the right one, m.
    pub net: Vec<[f64; 2]>,
    /// Position and angle of each object.
    pub objects: Vec<[f64; 3]>,
}
