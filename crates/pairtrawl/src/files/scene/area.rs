//! `[area]`: a rectangle or a ROS map.

use crate::files::toml_reader::{FARTHEST, Range, Table, Value};
use crate::files::{FileError, Problem};
use pairtrawl_geometry::Point;
use pairtrawl_model::{Area, OccupancyMap, Robot, RobotSize, Scales, Warning};
use pairtrawl_world::ros_map::{MapMetadata, Unknown, decode};
use pairtrawl_world::{WorldError, grid_size};
use std::path::Path;

/// Cell size of the occupancy grid when the scene gives none, m, for robots of the paper's size.
const DEFAULT_RESOLUTION: f64 = 0.05;
/// Bytes of a map's YAML file.
const MAP_YAML_BYTES: u64 = 64 << 10;
/// Bytes of a map's image.
const MAP_IMAGE_BYTES: u64 = 256 << 20;

/// Reads a file whose size in bytes is bounded by the second argument.
pub(in crate::files) type ReadFile<'a> = &'a dyn Fn(&Path, u64) -> Result<Vec<u8>, FileError>;

/// What `[area]` says.
pub(super) struct ReadArea {
    pub area: Area,
    pub map: Option<OccupancyMap>,
    /// The map's YAML and its image.
    pub hashed: Vec<Vec<u8>>,
    pub warnings: Vec<Warning>,
}

pub(super) fn read(
    root: &Table<'_>,
    robot: &Robot,
    scene: &Path,
    read_file: ReadFile<'_>,
) -> Result<ReadArea, FileError> {
    let table = root
        .require("area", "give [area] with min and max, or with map")?
        .table()?;
    table.expect_keys(&["min", "max", "resolution", "map", "unknown"])?;
    match table.get("map") {
        Some(map) => from_map(&table, &map, robot, scene, read_file),
        None => rectangle(&table, robot),
    }
}

fn rectangle(table: &Table<'_>, robot: &Robot) -> Result<ReadArea, FileError> {
    let corner = |key| {
        table.require(
            key,
            "give the rectangle's corners min and max, [x, y], or a map",
        )
    };
    let (min, max) = (corner("min")?.point()?, corner("max")?.point()?);
    if let Some(unknown) = table.get("unknown") {
        let reason = "only a map has unknown cells: remove it, or give map".to_owned();
        return Err(unknown.error(Problem::Conflict {
            field: unknown.name().to_owned(),
            reason,
        }));
    }
    if min.x >= max.x || min.y >= max.y {
        let reason = format!(
            "[{}, {}] does not lie above and right of min [{}, {}]",
            max.x, max.y, min.x, min.y
        );
        return Err(corner("max")?.error(Problem::Conflict {
            field: table.field("max"),
            reason,
        }));
    }
    let mut resolution = RobotSize::of(robot).length(DEFAULT_RESOLUTION);
    table.update("resolution", Range::Positive, &mut resolution)?;
    let area = Area {
        min,
        max,
        resolution,
    };
    let size = max - min;
    check_grid(robot, size.x, size.y, resolution).map_err(|e| {
        table
            .get("resolution")
            .map_or_else(|| table.error(e.clone()), |v| v.error(e.clone()))
    })?;
    Ok(ReadArea {
        area,
        map: None,
        hashed: Vec::new(),
        warnings: Vec::new(),
    })
}

/// The grid that planning needs must not be too large; sizes in m.
fn check_grid(robot: &Robot, width: f64, height: f64, resolution: f64) -> Result<(), WorldError> {
    let Scales { length, .. } = Scales::of_robot(robot);
    grid_size(width / length, height / length, resolution / length)
        .map(|_| ())
        .map_err(|error| error.in_meters(length))
}

fn from_map(
    table: &Table<'_>,
    map: &Value<'_>,
    robot: &Robot,
    scene: &Path,
    read_file: ReadFile<'_>,
) -> Result<ReadArea, FileError> {
    for key in ["min", "max", "resolution"] {
        if let Some(value) = table.get(key) {
            let reason = format!(
                "stands beside map, which gives the area and its resolution: remove {key} or map"
            );
            return Err(value.error(Problem::Conflict {
                field: value.name().to_owned(),
                reason,
            }));
        }
    }
    let unknown = match table.get("unknown") {
        None => Unknown::Occupied,
        Some(value) => match value.text()? {
            "free" => Unknown::Free,
            "occupied" => Unknown::Occupied,
            _ => return Err(value.refuse("\"free\" or \"occupied\"")),
        },
    };
    let loaded = map_file(&beside(scene, map.text()?), unknown, robot, read_file)?;
    Ok(ReadArea {
        area: loaded.area,
        map: Some(loaded.map),
        hashed: vec![loaded.yaml, loaded.image],
        warnings: loaded.warnings,
    })
}

/// A ROS map as read from its files.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadedMap {
    /// The axis-parallel rectangle around it, and its resolution.
    pub area: Area,
    /// Its cells.
    pub map: OccupancyMap,
    /// What its YAML file says.
    pub metadata: MapMetadata,
    /// The YAML file.
    pub yaml: Vec<u8>,
    /// The image file that it names.
    pub image: Vec<u8>,
    /// What a person should know about it.
    pub warnings: Vec<Warning>,
}

/// Reads a map for robots of this size.
pub(in crate::files) fn map_file(
    yaml_path: &Path,
    unknown: Unknown,
    robot: &Robot,
    read_file: ReadFile<'_>,
) -> Result<LoadedMap, FileError> {
    let yaml = read_file(yaml_path, MAP_YAML_BYTES)?;
    let metadata = MapMetadata::parse(&yaml).map_err(|e| FileError::new(yaml_path, e))?;
    let image_path = beside(yaml_path, &metadata.image);
    let image = read_file(&image_path, MAP_IMAGE_BYTES)?;
    let decoded = decode(&metadata, &image, unknown).map_err(|e| FileError::new(&image_path, e))?;
    let map = decoded.map;
    let area = bounding_area(&map);
    for corner in [area.min, area.max] {
        if !(corner.x.abs() <= FARTHEST && corner.y.abs() <= FARTHEST) {
            let value = format!("such that the map reaches ({:e}, {:e})", corner.x, corner.y);
            let bound = "such that coordinates stay between -1e6 and 1e6 (m)".to_owned();
            return Err(FileError::new(
                yaml_path,
                Problem::Value {
                    field: "origin or resolution".to_owned(),
                    value,
                    bound,
                },
            ));
        }
    }
    let (width, height) = (
        map.columns as f64 * map.resolution,
        map.rows as f64 * map.resolution,
    );
    check_grid(robot, width, height, map.resolution).map_err(|e| FileError::new(yaml_path, e))?;
    let warnings = decoded
        .warnings
        .into_iter()
        .map(|warning| Warning::InFile {
            file: yaml_path.display().to_string(),
            warning: Box::new(warning),
        })
        .collect();
    Ok(LoadedMap {
        area,
        map,
        metadata,
        yaml,
        image,
        warnings,
    })
}

/// A path that is relative to the folder of another file.
fn beside(file: &Path, name: &str) -> std::path::PathBuf {
    file.parent().unwrap_or_else(|| Path::new("")).join(name)
}

/// The axis-parallel rectangle around a map, which may be turned.
fn bounding_area(map: &OccupancyMap) -> Area {
    let (w, h) = (map.columns as f64, map.rows as f64);
    let corners =
        [(0.0, 0.0), (w, 0.0), (w, h), (0.0, h)].map(|(x, y)| map.from_cells(Point::new(x, y)));
    let least = |f: fn(Point) -> f64| corners.iter().copied().map(f).fold(f64::INFINITY, f64::min);
    let most = |f: fn(Point) -> f64| {
        corners
            .iter()
            .copied()
            .map(f)
            .fold(f64::NEG_INFINITY, f64::max)
    };
    Area {
        min: Point::new(least(|p| p.x), least(|p| p.y)),
        max: Point::new(most(|p| p.x), most(|p| p.y)),
        resolution: map.resolution,
    }
}
