use crate::files::parts::Reference;
use crate::files::plan::file::FileOverrides;
use serde::{Deserialize, Serialize};

/// The first field of every such file.
pub const FORMAT: &str = "pairtrawl-infeasible/1";

/// Proofs that a scene has no plan, or none that gathers everything. `pairtrawl check` verifies them without searching. SI
/// units, map frame.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct File {
    /// The format and its version.
    #[cfg_attr(feature = "schema", schemars(extend("const" = FORMAT)))]
    pub format: String,
    /// The scene that the proofs are about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scene: Option<Reference>,
    /// What the command line changed against the scene.
    #[serde(default)]
    pub overrides: FileOverrides,
    /// The number of waypoints that the command line asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub waypoints: Option<usize>,
    /// The proofs: one that is not about an object first, where there is one, then one for each object that cannot be swept.
    #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
    pub proofs: Vec<FileProof>,
}

/// A proof.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileProof {
    /// The argument and the numbers that it rests on; every one of them is derived again.
    #[serde(flatten)]
    pub argument: Argument,
    /// The objects that it is about: one that cannot be swept, or none, and then there is no plan whatever is left.
    pub objects: Vec<usize>,
    /// The proof for people, with the least change that would help.
    #[serde(default)]
    pub text: String,
    /// The least move of the object that was found after which the argument says nothing against it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub least_move: Option<FileMove>,
}

/// A move of an object.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileMove {
    /// Where it would lie, m.
    pub to: [f64; 2],
    /// How far that is from where it lies, m.
    pub distance: f64,
}

/// A grid: the area, cut into equal cells.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileGrid {
    /// Cells along x.
    pub columns: usize,
    /// Cells along y.
    pub rows: usize,
    /// Cells in which no point is a place for the robot's axle center.
    pub blocked: usize,
    /// Cells that chains of other cells join to the robot's start.
    pub reached: usize,
}

/// One of the two robots.
#[derive(Clone, Copy, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "lowercase")]
pub enum FileSide {
    /// The left one.
    Left,
    /// The right one.
    Right,
}

/// An argument, by `kind`, and the numbers that it rests on, `evidence`.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "kind", content = "evidence", rename_all = "snake_case")]
pub enum Argument {
    /// The net cannot span the pair at its start or end.
    NetTooShort {
        /// The net's length, m.
        net_length: f64,
        /// The least length that would do, m.
        needed: f64,
    },
    /// The robots at the start or end are closer together than a tenth of the net's length.
    NetTooLong {
        /// The net's length, m.
        net_length: f64,
        /// The distance between the axle centers where they are closest, m.
        separation: f64,
        /// The greatest length that would do, m.
        most: f64,
    },
    /// The waypoints that are given do not reach from a robot's start to its end.
    TooFewWaypoints {
        /// How many are given.
        waypoints: usize,
        /// Whose end is too far.
        robot: FileSide,
        /// How far it is from its start, m.
        distance: f64,
        /// The least number that might do.
        needed: usize,
    },
    /// No chain of cells in which a robot may stand joins its start and its end.
    WayCut {
        /// Which robot.
        robot: FileSide,
        /// The grid on which this is seen.
        grid: FileGrid,
        /// Where the widest way is narrowest, m.
        place: [f64; 2],
        /// Its width there, m; 0 where it is closed.
        width: f64,
    },
    /// The net cannot span the object with a robot on each side.
    ObjectTooWide {
        /// The net's length, m.
        net_length: f64,
        /// The least length that would do, m.
        needed: f64,
    },
    /// A robot gets to no place from which its half of the line between the robots reaches the object.
    ObjectEnclosed {
        /// Which robot.
        robot: FileSide,
        /// How long its half of the line is at most, m.
        reach: f64,
        /// The grid on which this is seen.
        grid: FileGrid,
    },
    /// No robot passes between the object and the edge of the area.
    ObjectAtEdge {
        /// The nearest point of the edge, m.
        foot: [f64; 2],
        /// Distance between the footprint circle and the edge, m.
        gap: f64,
        /// The least distance that a robot passes, m.
        needed: f64,
    },
    /// No robot passes between the object and an obstacle.
    ObjectPinned {
        /// The nearest point of the obstacle, m.
        foot: [f64; 2],
        /// Distance between the footprint circle and the obstacle, m.
        gap: f64,
        /// The least distance that a robot passes, m.
        needed: f64,
    },
}
