//! One trial of an execution as a ROS 2 recording: MCAP with profile `ros2`, messages in CDR, and the `metadata.yaml` that makes
//! the folder with both a rosbag2. Time starts at 0; frames are `map`, `left/odom`, `left/base_link` and the same for the right
//! robot (REP-105), base links on the axle center.

mod messages;
mod metadata;
mod topics;

use byteorder::LittleEndian;
use mcap::records::MessageHeader;
use mcap::{WriteOptions, Writer};
use messages::{
    ColorRgba, CompressedImage, Covariance, Float64MultiArray, Header, MapMetaData, Marker,
    MarkerArray, MeshFile, MultiArrayDimension, MultiArrayLayout, OccupancyGrid, Odometry, Path,
    Pose, PoseStamped, PoseWithCovariance, Quaternion, TfMessage, Time, Transform,
    TransformStamped, Twist, TwistWithCovariance, Vector3,
};
use pairtrawl_geometry::Pose as PlanarPose;
use pairtrawl_model::{ControlSample, Footprint, Object, PairTrajectory, RehearsalFrame, Trial};
use serde::Serialize;
use std::collections::BTreeMap;
use std::io::Cursor;
use thiserror::Error;
use topics::Topic;

/// The name of the recording in its folder, as `metadata.yaml` has it.
pub const RECORDING_NAME: &str = "run.mcap";

/// What goes into a recording.
#[derive(Clone, Debug)]
pub struct Recording<'a> {
    /// The plan.
    pub plan: &'a PairTrajectory,
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
    pub origin: PlanarPose,
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
        bag.send(
            topics::PLAN[side],
            0,
            &path(poses, recording.plan.step_time),
        )?;
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

fn nanoseconds(time: f64) -> u64 {
    (time * 1e9).round().max(0.0) as u64
}

/// The container under construction.
struct Bag {
    writer: Writer<Cursor<Vec<u8>>>,
    channels: BTreeMap<&'static str, u16>,
    counts: BTreeMap<&'static str, u32>,
    last: u64,
}

impl Bag {
    fn new() -> Result<Self, RecordingError> {
        let options = WriteOptions::new()
            .compression(None)
            .profile("ros2")
            .library("pairtrawl");
        let mut writer = options.create(Cursor::new(Vec::new()))?;
        let mut channels = BTreeMap::new();
        for topic in topics::ALL {
            let schema =
                writer.add_schema(topic.message, "ros2msg", topic.definition.as_bytes())?;
            let metadata =
                BTreeMap::from([("offered_qos_profiles".to_owned(), topic.qos().to_owned())]);
            channels.insert(
                topic.name,
                writer.add_channel(schema, topic.name, "cdr", &metadata)?,
            );
        }
        Ok(Self {
            writer,
            channels,
            counts: BTreeMap::new(),
            last: 0,
        })
    }

    fn send(
        &mut self,
        topic: Topic,
        time: u64,
        message: &impl Serialize,
    ) -> Result<(), RecordingError> {
        let fault = |reason: String| RecordingError::Message {
            topic: topic.name,
            reason,
        };
        let body =
            cdr_encoding::to_vec::<_, LittleEndian>(message).map_err(|e| fault(e.to_string()))?;
        // The encapsulation header: plain CDR, little endian.
        let mut data = vec![0, 1, 0, 0];
        data.extend(body);
        let channel_id = *self
            .channels
            .get(topic.name)
            .ok_or_else(|| fault("it has no channel".to_owned()))?;
        let sequence = self.counts.entry(topic.name).or_default();
        *sequence += 1;
        let header = MessageHeader {
            channel_id,
            sequence: *sequence,
            log_time: time,
            publish_time: time,
        };
        self.writer.write_to_known_channel(&header, &data)?;
        self.last = self.last.max(time);
        Ok(())
    }

    fn send_sample(&mut self, sample: &ControlSample) -> Result<(), RecordingError> {
        let time = nanoseconds(sample.time);
        let stamp = Time::from_nanoseconds(time);
        let poses = [sample.robots.left, sample.robots.right];
        let mut transforms = Vec::with_capacity(4);
        for (side, name) in ["left", "right"].into_iter().enumerate() {
            let (odom, base) = (format!("{name}/odom"), format!("{name}/base_link"));
            let twist = (sample.forward[side], sample.turn_rate[side]);
            self.send(
                topics::ODOM[side],
                time,
                &odometry(stamp, &odom, &base, poses[side], twist),
            )?;
            self.send(topics::TORQUE[side], time, &torques(sample.torque[side]))?;
            transforms.push(transform(stamp, "map", &odom, PlanarPose::default()));
            transforms.push(transform(stamp, &odom, &base, poses[side]));
        }
        self.send(topics::FRAMES, time, &TfMessage { transforms })
    }

    fn finish(mut self) -> Result<RecordingFiles, RecordingError> {
        self.writer.finish()?;
        let metadata = metadata::yaml(&self.counts, self.last);
        Ok(RecordingFiles {
            mcap: self.writer.into_inner().into_inner(),
            metadata,
        })
    }
}

fn header(stamp: Time, frame_id: &str) -> Header {
    Header {
        stamp,
        frame_id: frame_id.to_owned(),
    }
}

fn path(poses: &[PlanarPose], step_time: f64) -> Path {
    let stamped = |(i, p): (usize, &PlanarPose)| PoseStamped {
        header: header(
            Time::from_nanoseconds(nanoseconds(i as f64 * step_time)),
            "map",
        ),
        pose: Pose::planar(p.x, p.y, p.heading),
    };
    Path {
        header: header(Time::ZERO, "map"),
        poses: poses.iter().enumerate().map(stamped).collect(),
    }
}

fn odometry(
    stamp: Time,
    odom: &str,
    base: &str,
    pose: PlanarPose,
    (forward, turn): (f64, f64),
) -> Odometry {
    Odometry {
        header: header(stamp, odom),
        child_frame_id: base.to_owned(),
        pose: PoseWithCovariance {
            pose: Pose::planar(pose.x, pose.y, pose.heading),
            covariance: Covariance,
        },
        twist: TwistWithCovariance {
            twist: Twist {
                linear: Vector3 {
                    x: forward,
                    ..Vector3::default()
                },
                angular: Vector3 {
                    z: turn,
                    ..Vector3::default()
                },
            },
            covariance: Covariance,
        },
    }
}

fn torques(torque: [f64; 2]) -> Float64MultiArray {
    let wheels = MultiArrayDimension {
        label: "wheel: left, right".to_owned(),
        size: 2,
        stride: 2,
    };
    Float64MultiArray {
        layout: MultiArrayLayout {
            dim: vec![wheels],
            data_offset: 0,
        },
        data: torque.to_vec(),
    }
}

fn transform(stamp: Time, parent: &str, child: &str, pose: PlanarPose) -> TransformStamped {
    TransformStamped {
        header: header(stamp, parent),
        child_frame_id: child.to_owned(),
        transform: Transform {
            translation: Vector3 {
                x: pose.x,
                y: pose.y,
                z: 0.0,
            },
            rotation: Quaternion::yaw(pose.heading),
        },
    }
}

fn grid(map: &RecordedMap) -> OccupancyGrid {
    OccupancyGrid {
        header: header(Time::ZERO, "map"),
        info: MapMetaData {
            map_load_time: Time::ZERO,
            resolution: map.resolution as f32,
            width: u32::try_from(map.columns).unwrap_or(u32::MAX),
            height: u32::try_from(map.rows).unwrap_or(u32::MAX),
            origin: Pose::planar(map.origin.x, map.origin.y, map.origin.heading),
        },
        data: map.cells.clone(),
    }
}

/// `visualization_msgs/Marker`: CUBE, CYLINDER, LINE_STRIP.
const CUBE: i32 = 1;
const CYLINDER: i32 = 3;
const LINE_STRIP: i32 = 4;

const NET_COLOR: ColorRgba = ColorRgba {
    r: 0.1,
    g: 0.5,
    b: 0.2,
    a: 1.0,
};
const OBJECT_COLOR: ColorRgba = ColorRgba {
    r: 0.8,
    g: 0.15,
    b: 0.1,
    a: 1.0,
};

fn markers(recording: &Recording, frame: &RehearsalFrame) -> MarkerArray {
    let stamp = Time::from_nanoseconds(nanoseconds(frame.time));
    let mut net = marker(stamp, "net", 0, LINE_STRIP, Pose::planar(0.0, 0.0, 0.0));
    net.scale.x = recording.net_thickness;
    net.color = NET_COLOR;
    net.points = frame
        .net
        .iter()
        .map(|p| Vector3 {
            x: p.x,
            y: p.y,
            z: 0.0,
        })
        .collect();
    let objects =
        frame
            .objects
            .iter()
            .zip(recording.objects)
            .enumerate()
            .map(|(i, (pose, object))| {
                let (kind, x, y) = match object.footprint {
                    Footprint::Box(w, d) => (CUBE, w, d),
                    Footprint::Disc(r) => (CYLINDER, 2.0 * r, 2.0 * r),
                };
                let id = i32::try_from(i).unwrap_or(i32::MAX);
                let mut marker = marker(
                    stamp,
                    "objects",
                    id,
                    kind,
                    Pose::planar(pose.x, pose.y, pose.heading),
                );
                marker.pose.position.z = 0.5 * x;
                marker.scale = Vector3 { x, y, z: x };
                marker.color = OBJECT_COLOR;
                marker
            });
    MarkerArray {
        markers: std::iter::once(net).chain(objects).collect(),
    }
}

fn marker(stamp: Time, ns: &str, id: i32, kind: i32, pose: Pose) -> Marker {
    Marker {
        header: header(stamp, "map"),
        ns: ns.to_owned(),
        id,
        kind,
        action: 0,
        pose,
        scale: Vector3::default(),
        color: NET_COLOR,
        lifetime: Time::ZERO,
        frame_locked: false,
        points: Vec::new(),
        colors: Vec::new(),
        texture_resource: String::new(),
        texture: CompressedImage {
            header: header(Time::ZERO, ""),
            format: String::new(),
            data: Vec::new(),
        },
        uv_coordinates: Vec::new(),
        text: String::new(),
        mesh_resource: String::new(),
        mesh_file: MeshFile {
            filename: String::new(),
            data: Vec::new(),
        },
        mesh_use_embedded_materials: false,
    }
}
