//! What a recording says, as messages.

use super::messages::{
    ColorRgba, CompressedImage, Covariance, Float64MultiArray, Header, MapMetaData, Marker,
    MarkerArray, MeshFile, MultiArrayDimension, MultiArrayLayout, OccupancyGrid, Odometry, Path,
    Pose, PoseStamped, PoseWithCovariance, Quaternion, Time, Transform, TransformStamped, Twist,
    TwistWithCovariance, Vector3,
};
use super::recording::{RecordedMap, Recording};
use pairtrawl_geometry::Pose as PlanarPose;
use pairtrawl_model::{Footprint, RehearsalFrame};

pub(super) fn nanoseconds(time: f64) -> u64 {
    (time * 1e9).round().max(0.0) as u64
}

fn header(stamp: Time, frame_id: &str) -> Header {
    Header {
        stamp,
        frame_id: frame_id.to_owned(),
    }
}

pub(super) fn path(poses: &[PlanarPose], times: &[f64]) -> Path {
    let stamped = |(p, time): (&PlanarPose, &f64)| PoseStamped {
        header: header(Time::from_nanoseconds(nanoseconds(*time)), "map"),
        pose: Pose::planar(p.x, p.y, p.heading),
    };
    Path {
        header: header(Time::ZERO, "map"),
        poses: poses.iter().zip(times).map(stamped).collect(),
    }
}

pub(super) fn odometry(
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

pub(super) fn torques(torque: [f64; 2]) -> Float64MultiArray {
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

pub(super) fn transform(
    stamp: Time,
    parent: &str,
    child: &str,
    pose: PlanarPose,
) -> TransformStamped {
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

pub(super) fn grid(map: &RecordedMap) -> OccupancyGrid {
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

pub(super) fn markers(recording: &Recording, frame: &RehearsalFrame) -> MarkerArray {
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
