//! The ROS 2 messages of a recording, field by field as their definitions have them.

use serde::Serialize;
use serde::ser::{SerializeTuple, Serializer};

#[derive(Clone, Copy, Serialize)]
pub(super) struct Time {
    pub sec: i32,
    pub nanosec: u32,
}

impl Time {
    pub const ZERO: Self = Self { sec: 0, nanosec: 0 };

    /// From nanoseconds; seconds beyond the type's range stay at its end.
    pub fn from_nanoseconds(ns: u64) -> Self {
        Self {
            sec: i32::try_from(ns / 1_000_000_000).unwrap_or(i32::MAX),
            nanosec: (ns % 1_000_000_000) as u32,
        }
    }
}

#[derive(Clone, Serialize)]
pub(super) struct Header {
    pub stamp: Time,
    pub frame_id: String,
}

#[derive(Clone, Copy, Default, Serialize)]
pub(super) struct Vector3 {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}

#[derive(Clone, Copy, Serialize)]
pub(super) struct Quaternion {
    pub x: f64,
    pub y: f64,
    pub z: f64,
    pub w: f64,
}

impl Quaternion {
    /// A turn about the vertical, rad.
    pub fn yaw(angle: f64) -> Self {
        let (z, w) = libm::sincos(0.5 * angle);
        Self {
            x: 0.0,
            y: 0.0,
            z,
            w,
        }
    }
}

#[derive(Clone, Copy, Serialize)]
pub(super) struct Pose {
    pub position: Vector3,
    pub orientation: Quaternion,
}

impl Pose {
    pub fn planar(x: f64, y: f64, heading: f64) -> Self {
        Self {
            position: Vector3 { x, y, z: 0.0 },
            orientation: Quaternion::yaw(heading),
        }
    }
}

#[derive(Serialize)]
pub(super) struct PoseStamped {
    pub header: Header,
    pub pose: Pose,
}

#[derive(Serialize)]
pub(super) struct Path {
    pub header: Header,
    pub poses: Vec<PoseStamped>,
}

/// A 6 by 6 covariance: 36 numbers without a length before them.
pub(super) struct Covariance;

impl Serialize for Covariance {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(36)?;
        for _ in 0..36 {
            tuple.serialize_element(&0.0_f64)?;
        }
        tuple.end()
    }
}

#[derive(Serialize)]
pub(super) struct PoseWithCovariance {
    pub pose: Pose,
    pub covariance: Covariance,
}

#[derive(Serialize)]
pub(super) struct Twist {
    pub linear: Vector3,
    pub angular: Vector3,
}

#[derive(Serialize)]
pub(super) struct TwistWithCovariance {
    pub twist: Twist,
    pub covariance: Covariance,
}

#[derive(Serialize)]
pub(super) struct Odometry {
    pub header: Header,
    pub child_frame_id: String,
    pub pose: PoseWithCovariance,
    pub twist: TwistWithCovariance,
}

#[derive(Serialize)]
pub(super) struct MultiArrayDimension {
    pub label: String,
    pub size: u32,
    pub stride: u32,
}

#[derive(Serialize)]
pub(super) struct MultiArrayLayout {
    pub dim: Vec<MultiArrayDimension>,
    pub data_offset: u32,
}

#[derive(Serialize)]
pub(super) struct Float64MultiArray {
    pub layout: MultiArrayLayout,
    pub data: Vec<f64>,
}

#[derive(Serialize)]
pub(super) struct Transform {
    pub translation: Vector3,
    pub rotation: Quaternion,
}

#[derive(Serialize)]
pub(super) struct TransformStamped {
    pub header: Header,
    pub child_frame_id: String,
    pub transform: Transform,
}

#[derive(Serialize)]
pub(super) struct TfMessage {
    pub transforms: Vec<TransformStamped>,
}

#[derive(Serialize)]
pub(super) struct MapMetaData {
    pub map_load_time: Time,
    pub resolution: f32,
    pub width: u32,
    pub height: u32,
    pub origin: Pose,
}

#[derive(Serialize)]
pub(super) struct OccupancyGrid {
    pub header: Header,
    pub info: MapMetaData,
    pub data: Vec<i8>,
}

#[derive(Clone, Copy, Serialize)]
pub(super) struct ColorRgba {
    pub r: f32,
    pub g: f32,
    pub b: f32,
    pub a: f32,
}

#[derive(Serialize)]
pub(super) struct CompressedImage {
    pub header: Header,
    pub format: String,
    pub data: Vec<u8>,
}

#[derive(Serialize)]
pub(super) struct UvCoordinate {
    pub u: f32,
    pub v: f32,
}

#[derive(Serialize)]
pub(super) struct MeshFile {
    pub filename: String,
    pub data: Vec<u8>,
}

#[derive(Serialize)]
pub(super) struct Marker {
    pub header: Header,
    pub ns: String,
    pub id: i32,
    pub kind: i32,
    pub action: i32,
    pub pose: Pose,
    pub scale: Vector3,
    pub color: ColorRgba,
    pub lifetime: Time,
    pub frame_locked: bool,
    pub points: Vec<Vector3>,
    pub colors: Vec<ColorRgba>,
    pub texture_resource: String,
    pub texture: CompressedImage,
    pub uv_coordinates: Vec<UvCoordinate>,
    pub text: String,
    pub mesh_resource: String,
    pub mesh_file: MeshFile,
    pub mesh_use_embedded_materials: bool,
}

#[derive(Serialize)]
pub(super) struct MarkerArray {
    pub markers: Vec<Marker>,
}
