//! One trial of an execution as a ROS 2 recording: MCAP with profile `ros2`, messages in CDR, and the `metadata.yaml` that makes
//! the folder with both a rosbag2. Time starts at 0; frames are `map`, `left/odom`, `left/base_link` and the same for the right
//! robot (REP-105), base links on the axle center.

mod bag;
mod contents;
mod messages;
mod metadata;
mod recording;
mod topics;

pub use recording::{RECORDING_NAME, RecordedMap, Recording, RecordingError, RecordingFiles};

use bag::Bag;
use contents::{grid, markers, nanoseconds, path};

/// Renders a recording.
///
/// # Errors
/// When a message or the container cannot be encoded.
pub fn record(recording: &Recording) -> Result<RecordingFiles, RecordingError> {
    let mut bag = Bag::new()?;
    for (side, poses) in [&recording.plan.left, &recording.plan.right]
        .into_iter()
        .enumerate()
    {
        bag.send(topics::PLAN[side], 0, &path(poses, recording.times))?;
    }
    bag.send(topics::MAP, 0, &grid(&recording.map))?;
    // Messages go out in order of time: samples and frames are merged.
    let mut frames = recording.trial.frames.iter().peekable();
    for sample in &recording.trial.samples {
        while let Some(frame) = frames.next_if(|f| f.time <= sample.time) {
            bag.send(
                topics::WORLD,
                nanoseconds(frame.time),
                &markers(recording, frame),
            )?;
        }
        bag.send_sample(sample)?;
    }
    for frame in frames {
        bag.send(
            topics::WORLD,
            nanoseconds(frame.time),
            &markers(recording, frame),
        )?;
    }
    bag.finish()
}
