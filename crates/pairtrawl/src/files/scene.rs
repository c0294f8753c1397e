//! `scene.toml`, format `pairtrawl-scene/1`.

mod area;
mod body;
mod checks;
pub(super) mod content;
mod parameters;
mod shapes;

use super::toml_reader::{Document, Table};
use super::{FileError, Problem, sha256_hex};
pub use area::LoadedMap;
use area::ReadFile;
#[cfg(feature = "fs")]
pub(super) use area::map_file;
use content::FORMAT;
use pairtrawl_model::{PairPose, Scene, SceneReference, Warning};
use std::path::Path;
use toml::de::DeTable;

/// A scene as read from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadedScene {
    /// The scene, checked.
    pub scene: Scene,
    /// Its name and the hash of its files.
    pub reference: SceneReference,
    /// What a person should know: thresholds, a slow cruise speed.
    pub warnings: Vec<Warning>,
}

/// Reads a scene that needs no other file, such as an embedded one; `name` stands for the file in messages.
///
/// # Errors
/// When it is no scene, names a map, or describes one that makes no sense.
pub fn parse_scene(text: &str, name: &str) -> Result<LoadedScene, FileError> {
    parse_scene_with(text, name, &|_| None)
}

/// Reads a scene whose map is at hand: `files` gives the content of a file by the path that the scene and the map's YAML
/// spell, relative to the scene.
///
/// # Errors
/// As [`parse_scene`], and when a file of the map is missing or no map.
pub fn parse_scene_with(
    text: &str,
    name: &str,
    files: &dyn Fn(&Path) -> Option<Vec<u8>>,
) -> Result<LoadedScene, FileError> {
    parse(Path::new(name), text, &|file, _| {
        files(file).ok_or_else(|| FileError::new(file, Problem::Missing))
    })
}

pub(super) fn parse(
    path: &Path,
    text: &str,
    read_file: ReadFile<'_>,
) -> Result<LoadedScene, FileError> {
    let document = Document { path, text };
    let root = DeTable::parse(text).map_err(|e| {
        let reason = e.message().to_owned();
        document.error(e.span().map_or(0, |s| s.start), Problem::Syntax { reason })
    })?;
    let root = Table::root(document, root.get_ref());

    // The format first: a file of another version has other keys.
    let format = root.require(
        "format",
        &format!("the first line of a scene is format = {FORMAT:?}"),
    )?;
    if format.text()? != FORMAT {
        return Err(format.error(Problem::Format {
            found: format.text()?.to_owned(),
            expected: FORMAT,
        }));
    }
    root.expect_keys(&[
        "format",
        "name",
        "area",
        "obstacles",
        "objects",
        "start",
        "end",
        "robot",
        "net",
        "planner",
        "physics",
    ])?;
    let name = root
        .get("name")
        .map_or(Ok("unnamed"), |v| v.text())?
        .to_owned();

    let mut warnings = Vec::new();
    let (robot, preset) = parameters::robot(&root, &mut warnings)?;
    let area = area::read(&root, &robot, path, read_file)?;
    let mut parts = vec![text.as_bytes()];
    parts.extend(area.hashed.iter().map(Vec::as_slice));
    let sha256 = sha256_hex(&parts);

    warnings.extend(area.warnings);
    let scene = Scene {
        name,
        area: area.area,
        obstacles: shapes::obstacles(&root)?,
        map: area.map,
        objects: shapes::objects(&root, &robot)?,
        start: pair(&root, "start")?,
        end: pair(&root, "end")?,
        robot,
        net: parameters::net(&root)?,
        planner: parameters::planner(&root, &robot, &mut warnings)?,
        physics: parameters::physics(&root, &robot, preset)?,
    };
    checks::check(&scene, &root)?;
    let reference = SceneReference {
        name: scene.name.clone(),
        sha256,
        content_sha256: Some(content::sha256(&scene)),
    };
    Ok(LoadedScene {
        scene,
        reference,
        warnings,
    })
}

/// `[start]` or `[end]`.
fn pair(root: &Table<'_>, key: &str) -> Result<PairPose, FileError> {
    use super::toml_reader::Range::Heading;
    use pairtrawl_geometry::Pose;
    let table = root
        .require(key, &format!("give [{key}] with left, right and heading"))?
        .table()?;
    table.expect_keys(&["left", "right", "heading", "left_heading", "right_heading"])?;
    let left = table
        .require("left", "give the left robot's position, [x, y]")?
        .point()?;
    let right = table
        .require("right", "give the right robot's position, [x, y]")?
        .point()?;
    let (left_heading, right_heading) = match (
        table.get("heading"),
        table.get("left_heading"),
        table.get("right_heading"),
    ) {
        (Some(both), None, None) => (both.number(Heading)?, both.number(Heading)?),
        (None, Some(left), Some(right)) => (left.number(Heading)?, right.number(Heading)?),
        (Some(both), _, _) => {
            let reason = "stands beside left_heading or right_heading: give heading for both robots, or one for each, not all";
            return Err(both.error(Problem::Conflict {
                field: both.name().to_owned(),
                reason: reason.to_owned(),
            }));
        }
        (None, left, _) => {
            let missing = match left {
                Some(_) => "right_heading",
                None => "heading",
            };
            let remedy =
                "give heading for both robots, or left_heading and right_heading".to_owned();
            return Err(table.error(Problem::MissingKey {
                field: table.field(missing),
                remedy,
            }));
        }
    };
    Ok(PairPose {
        left: Pose::at(left, left_heading),
        right: Pose::at(right, right_heading),
    })
}
