//! A trial as a rosbag2 folder.

use crate::files::FileError;
use pairtrawl_model::{PairTrajectory, Scene, Trial};
use pairtrawl_report::mcap::{RecordedMap, Recording, RecordingError, RecordingFiles, record};
use pairtrawl_world::{Cell, World, WorldError};

/// Why a recording cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteRecordingError {
    /// The scene's grid cannot be built.
    #[error(transparent)]
    World(#[from] WorldError),
    /// A message cannot be encoded.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// A file cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
}

/// Renders `run.mcap` and `metadata.yaml` of a trial; `times` says when each waypoint of the plan is passed, s.
///
/// # Errors
/// When the scene's grid cannot be built or a message not encoded.
pub fn recording(
    scene: &Scene,
    net_length: f64,
    plan: &PairTrajectory,
    times: &[f64],
    trial: &Trial,
) -> Result<RecordingFiles, WriteRecordingError> {
    let grid = World::new(scene, Some(net_length))?.grid;
    let map = RecordedMap {
        origin: grid.origin,
        resolution: grid.resolution,
        columns: grid.columns,
        rows: grid.rows,
        cells: grid
            .cells
            .iter()
            .map(|c| if *c == Cell::Obstacle { 100 } else { 0 })
            .collect(),
    };
    let net_thickness = scene.physics.net_thickness;
    Ok(record(&Recording {
        plan,
        times,
        trial,
        objects: &scene.objects,
        net_thickness,
        map,
    })?)
}

#[cfg(feature = "fs")]
/// Writes `run.mcap` and `metadata.yaml` of a trial into a folder that exists: the folder is then a rosbag2.
///
/// # Errors
/// As [`recording`], and when the system refuses.
pub fn write_recording(
    folder: &std::path::Path,
    scene: &Scene,
    net_length: f64,
    plan: &PairTrajectory,
    times: &[f64],
    trial: &Trial,
) -> Result<(), WriteRecordingError> {
    use crate::files::write_atomically;
    use pairtrawl_report::mcap::RECORDING_NAME;
    let files = recording(scene, net_length, plan, times, trial)?;
    write_atomically(&folder.join(RECORDING_NAME), &files.mcap)?;
    Ok(write_atomically(
        &folder.join("metadata.yaml"),
        files.metadata.as_bytes(),
    )?)
}
