//! What goes into a recording, and what comes of it.

use pairtrawl_geometry::Pose;
use pairtrawl_model::{Object, PairTrajectory, Trial};
use thiserror::Error;

/// The name of the recording in its folder, as `metadata.yaml` has it.
pub const RECORDING_NAME: &str = "run.mcap";

/// What goes into a recording.
#[derive(Clone, Debug)]
pub struct Recording<'a> {
    /// The plan.
    pub plan: &'a PairTrajectory,
    /// When each of its waypoints is passed, s.
    pub times: &'a [f64],
    /// The drive.
    pub trial: &'a Trial,
    /// The objects, for their sizes.
    pub objects: &'a [Object],
    /// Thickness of the net, m.
    pub net_thickness: f64,
    /// The occupancy grid.
    pub map: RecordedMap,
}

/// An occupancy grid for a recording.
#[derive(Clone, Debug)]
pub struct RecordedMap {
    /// Pose of the outer corner of the first cell.
    pub origin: Pose,
    /// Edge length of a cell, m.
    pub resolution: f64,
    /// Cells along x.
    pub columns: usize,
    /// Cells along y.
    pub rows: usize,
    /// Row by row from the lowest: 0 free, 100 obstacle.
    pub cells: Vec<i8>,
}

/// A finished recording.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordingFiles {
    /// Contents of `run.mcap`.
    pub mcap: Vec<u8>,
    /// Contents of `metadata.yaml`.
    pub metadata: String,
}

/// Why there is no recording.
#[derive(Debug, Error)]
pub enum RecordingError {
    /// The container refused.
    #[error("the recording cannot be written: {0}")]
    Container(#[from] mcap::McapError),
    /// A message could not be put into CDR.
    #[error("a message of {topic} cannot be encoded: {reason}")]
    Message {
        /// The topic.
        topic: &'static str,
        /// What the encoder says.
        reason: String,
    },
}
