//! What a scene file says, as serializable types: its JSON schema, and the canonical form whose hash stays the same when
//! only comments, order or layout of the file change.

use crate::files::sha256_hex;
use pairtrawl_geometry::Point;
use pairtrawl_model::{
    Footprint, Obstacle, OccupancyMap, PairPose, PhysicsParameters, PlannerParameters, Robot, Scene,
};
use serde::Serialize;

/// The first field of every scene.
pub(super) const FORMAT: &str = "pairtrawl-scene/1";

/// Hexadecimal SHA-256 of the scene's canonical form: its file as compact JSON in the order of the types below, every
/// default written out, then each cell of its map as one byte, 1 where it is blocked.
pub(super) fn sha256(scene: &Scene) -> String {
    let blocked: Vec<u8> = (scene.map.iter())
        .flat_map(|map| map.blocked.iter().map(|blocked| u8::from(*blocked)))
        .collect();
    // Only maps with keys other than strings cannot be JSON, and there are no maps here.
    let content = serde_json::to_vec(&SceneFile::from(scene)).unwrap_or_default();
    sha256_hex(&[&content, &blocked])
}

/// A scene file: everything that a run is planned from. It is written as TOML; this is its shape. Unknown keys are errors.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SceneFile {
    /// The format and its version.
    #[cfg_attr(feature = "schema", schemars(extend("const" = FORMAT)))]
    format: &'static str,
    /// A name for people.
    #[cfg_attr(feature = "schema", schemars(default = "unnamed"))]
    name: String,
    /// Where the robots may drive.
    area: AreaFile,
    /// What the robots and the net must not touch.
    #[cfg_attr(feature = "schema", schemars(default))]
    obstacles: Vec<ObstacleFile>,
    /// What is to be gathered.
    #[cfg_attr(feature = "schema", schemars(default))]
    objects: Vec<ObjectFile>,
    /// Where the pair starts.
    start: PairFile,
    /// Where the pair ends.
    end: PairFile,
    /// The robot; both are alike. The default is the TurtleBot3 Waffle Pi.
    #[cfg_attr(feature = "schema", schemars(default))]
    robot: RobotFile,
    /// The net.
    #[cfg_attr(feature = "schema", schemars(default))]
    net: NetFile,
    /// The planner's parameters; the paper's values by default.
    #[cfg_attr(feature = "schema", schemars(default))]
    planner: PlannerParameters,
    /// Masses and frictions for rehearsal and execution.
    #[cfg_attr(feature = "schema", schemars(default))]
    physics: PhysicsParameters,
}

#[cfg(feature = "schema")]
fn unnamed() -> &'static str {
    "unnamed"
}

/// A rectangle (`min` and `max`), which bounds robot centers and objects, or a ROS map (`map`), outside of which everything
/// is an obstacle.
#[derive(Serialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(extend("oneOf" = [{ "required": ["min", "max"] }, { "required": ["map"] }]))
)]
#[serde(deny_unknown_fields)]
struct AreaFile {
    /// Lower left corner of the rectangle, m.
    min: Option<[f64; 2]>,
    /// Upper right corner of the rectangle, m.
    max: Option<[f64; 2]>,
    /// Cell size of the occupancy grid, m: 0.05 when left out, the map's own with a map.
    resolution: Option<f64>,
    /// The map's YAML file, relative to the scene.
    map: Option<String>,
    /// What unknown cells of the map are: obstacles when left out.
    #[cfg_attr(feature = "schema", schemars(extend("enum" = ["occupied", "free"])))]
    unknown: Option<String>,
    /// The decoded map: part of the canonical form, never of a file.
    #[cfg_attr(feature = "schema", schemars(skip))]
    decoded: Option<MapGrid>,
}

#[derive(Serialize)]
struct MapGrid {
    origin: [f64; 3],
    resolution: f64,
    columns: usize,
    rows: usize,
}

/// A fixed obstacle.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
enum ObstacleFile {
    /// An axis-parallel box: x and y of its lower left corner, then of its upper right one, m.
    Box([f64; 4]),
    /// A simple polygon, convex or not: its vertices in either orientation, at least three, m.
    Polygon(Vec<[f64; 2]>),
    /// A disc: x and y of its center and its radius, m.
    Circle([f64; 3]),
}

/// An object with either `size` or `radius`.
#[derive(Serialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(extend("oneOf" = [{ "required": ["size"] }, { "required": ["radius"] }]))
)]
#[serde(deny_unknown_fields)]
struct ObjectFile {
    /// Its center, m.
    position: [f64; 2],
    /// Width and depth of a box, m.
    size: Option<[f64; 2]>,
    /// Radius of a disc, m.
    radius: Option<f64>,
    /// Its mass, kg: 0.025 when left out.
    mass: Option<f64>,
}

/// Poses of both robots: `heading` for both, or `left_heading` and `right_heading`.
#[derive(Serialize)]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(extend("oneOf" = [{ "required": ["heading"] }, { "required": ["left_heading", "right_heading"] }]))
)]
#[serde(deny_unknown_fields)]
struct PairFile {
    /// Axle center of the left robot, as seen by someone who walks with the pair, m.
    left: [f64; 2],
    /// Axle center of the right robot, m.
    right: [f64; 2],
    /// Heading of both robots, counter-clockwise from +x, rad.
    heading: Option<f64>,
    /// Heading of the left robot, rad.
    left_heading: Option<f64>,
    /// Heading of the right robot, rad.
    right_heading: Option<f64>,
}

/// The robot; both are alike. The default is the TurtleBot3 Waffle Pi within one circle around the axle center.
#[derive(Default, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct RobotFile {
    /// A machine that is known by name: sets every key of `robot` and `physics` that is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("enum" = pairtrawl_model::Preset::ALL.map(pairtrawl_model::Preset::name))))]
    preset: Option<String>,
    #[serde(flatten)]
    robot: Robot,
}

/// The net.
#[derive(Default, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct NetFile {
    /// Its length d_max, m; left out: the planner chooses it.
    length: Option<f64>,
    /// How it lies at the start, from the left hitch to the right one, m; left out: a symmetric U behind the robots.
    #[cfg_attr(feature = "schema", schemars(length(min = 2)))]
    start: Option<Vec<[f64; 2]>>,
}

impl From<&Scene> for SceneFile {
    fn from(scene: &Scene) -> Self {
        Self {
            format: FORMAT,
            name: scene.name.clone(),
            area: AreaFile {
                min: Some(scene.area.min.into()),
                max: Some(scene.area.max.into()),
                resolution: Some(scene.area.resolution),
                map: None,
                unknown: None,
                decoded: scene.map.as_ref().map(MapGrid::from),
            },
            obstacles: scene.obstacles.iter().map(ObstacleFile::from).collect(),
            objects: scene.objects.iter().map(ObjectFile::from).collect(),
            start: PairFile::from(scene.start),
            end: PairFile::from(scene.end),
            robot: RobotFile {
                preset: None,
                robot: scene.robot,
            },
            net: NetFile {
                length: scene.net.length,
                start: scene.net.start.as_deref().map(points),
            },
            planner: scene.planner,
            physics: scene.physics,
        }
    }
}

fn points(points: &[Point]) -> Vec<[f64; 2]> {
    points.iter().map(|&point| point.into()).collect()
}

impl From<&OccupancyMap> for MapGrid {
    fn from(map: &OccupancyMap) -> Self {
        Self {
            origin: map.origin.into(),
            resolution: map.resolution,
            columns: map.columns,
            rows: map.rows,
        }
    }
}

impl From<&Obstacle> for ObstacleFile {
    fn from(obstacle: &Obstacle) -> Self {
        match obstacle {
            Obstacle::Box { min, max } => Self::Box([min.x, min.y, max.x, max.y]),
            Obstacle::Polygon(vertices) => Self::Polygon(points(vertices)),
            Obstacle::Circle { center, radius } => Self::Circle([center.x, center.y, *radius]),
        }
    }
}

impl From<&pairtrawl_model::Object> for ObjectFile {
    fn from(object: &pairtrawl_model::Object) -> Self {
        let (size, radius) = match object.footprint {
            Footprint::Box(width, depth) => (Some([width, depth]), None),
            Footprint::Disc(radius) => (None, Some(radius)),
        };
        Self {
            position: object.position.into(),
            size,
            radius,
            mass: Some(object.mass),
        }
    }
}

impl From<PairPose> for PairFile {
    fn from(pair: PairPose) -> Self {
        Self {
            left: pair.left.position().into(),
            right: pair.right.position().into(),
            heading: None,
            left_heading: Some(pair.left.heading),
            right_heading: Some(pair.right.heading),
        }
    }
}
