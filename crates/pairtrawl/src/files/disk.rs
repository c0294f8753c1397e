//! Files on a disk: read with a bound, written whole or not at all.

use super::{
    FileError, InfeasibleFile, LoadedMap, LoadedScene, PlanFile, Problem, csv_text, execution_json,
    is_infeasible, parse_infeasible, parse_plan, plan_json, scene, tum_text, write_atomically,
};
use pairtrawl_execution::ExecutionOptions;
use pairtrawl_model::{Execution, Plan, Robot, SceneReference, Side};
use pairtrawl_reference::Reference;
use pairtrawl_world::ros_map::Unknown;
use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;

/// Bytes of a scene file.
const SCENE_BYTES: u64 = 4 << 20;
/// Bytes of a plan.
const PLAN_BYTES: u64 = 256 << 20;

/// Reads and checks a scene file and the map that it names.
///
/// # Errors
/// When a file cannot be read, is no scene, or describes one that makes no sense.
pub fn read_scene(path: &Path) -> Result<LoadedScene, FileError> {
    let bytes = read_bounded(path, SCENE_BYTES)?;
    scene::parse(path, text(path, &bytes)?, &|file, bound| {
        read_bounded(file, bound)
    })
}

/// Reads a ROS map, its YAML file and the image that it names, for the default robot. Unknown cells count as occupied.
///
/// # Errors
/// When a file cannot be read or is no map, or the map is too large.
pub fn read_map(path: &Path) -> Result<LoadedMap, FileError> {
    scene::map_file(path, Unknown::Occupied, &Robot::default(), &read_bounded)
}

/// Reads a plan file.
///
/// # Errors
/// When it cannot be read, is not JSON, lacks one of the first four fields, or has numbers that mean nothing.
pub fn read_plan(path: &Path) -> Result<PlanFile, FileError> {
    let bytes = read_bounded(path, PLAN_BYTES)?;
    parse_plan(text(path, &bytes)?, path)
}

/// What `pairtrawl check` judges.
#[derive(Clone, Debug, PartialEq)]
pub enum Checkable {
    /// A plan.
    Plan(Box<PlanFile>),
    /// Proofs that there is none.
    Infeasible(InfeasibleFile),
}

/// Reads a plan, or proofs that there is none, whichever the file says that it is.
///
/// # Errors
/// As [`read_plan`].
pub fn read_checkable(path: &Path) -> Result<Checkable, FileError> {
    let bytes = read_bounded(path, PLAN_BYTES)?;
    let text = text(path, &bytes)?;
    // Whatever is not of the other format is judged as a plan.
    match is_infeasible(text, path) {
        true => Ok(Checkable::Infeasible(parse_infeasible(text, path)?)),
        false => Ok(Checkable::Plan(Box::new(parse_plan(text, path)?))),
    }
}

/// Writes `plan.json`, every field of the format, atomically.
///
/// # Errors
/// When the system refuses.
pub fn write_plan(path: &Path, plan: &Plan) -> Result<(), FileError> {
    let text =
        plan_json(plan).map_err(|e| FileError::system(path, "write the plan as JSON", e.into()))?;
    write_atomically(path, text.as_bytes())
}

/// Writes `execution.json` atomically.
///
/// # Errors
/// When the system refuses.
pub fn write_execution(
    path: &Path,
    execution: &Execution,
    options: &ExecutionOptions,
    scene: &SceneReference,
) -> Result<(), FileError> {
    let text = execution_json(execution, options, scene);
    write_atomically(path, text.as_bytes())
}

/// Writes `plan.csv`, atomically.
///
/// # Errors
/// When the system refuses.
pub fn write_csv(path: &Path, reference: &Reference) -> Result<(), FileError> {
    write_atomically(path, csv_text(reference).as_bytes())
}

/// Writes what one robot drives as a TUM file, atomically.
///
/// # Errors
/// When the system refuses.
pub fn write_tum(path: &Path, reference: &Reference, side: Side) -> Result<(), FileError> {
    write_atomically(path, tum_text(reference, side).as_bytes())
}

/// The content of a regular file of at most `bound` bytes.
///
/// # Errors
/// When it is missing, a folder, a device or pipe (looked at before it is opened, since opening a pipe can wait forever),
/// empty or too long, or when the system refuses.
pub fn read_bounded(path: &Path, bound: u64) -> Result<Vec<u8>, FileError> {
    let refuse = |problem| Err(FileError::new(path, problem));
    let metadata = match std::fs::metadata(path) {
        Ok(metadata) => metadata,
        // A path with a zero byte in it, or through a file as if it were a folder, names no file either.
        Err(e)
            if matches!(
                e.kind(),
                ErrorKind::NotFound | ErrorKind::NotADirectory | ErrorKind::InvalidInput
            ) =>
        {
            return refuse(Problem::Missing);
        }
        Err(e) => return Err(FileError::system(path, "look at the file", e)),
    };
    if metadata.is_dir() {
        return refuse(Problem::Directory);
    }
    if !metadata.is_file() {
        return refuse(Problem::NotRegular);
    }
    if metadata.len() > bound {
        return refuse(Problem::TooLong { bound });
    }
    let file = File::open(path).map_err(|e| FileError::system(path, "open the file", e))?;
    // Files of the kernel declare no length, so the length is bounded here too.
    let mut content = Vec::new();
    file.take(bound + 1)
        .read_to_end(&mut content)
        .map_err(|e| FileError::system(path, "read the file", e))?;
    if content.len() as u64 > bound {
        return refuse(Problem::TooLong { bound });
    }
    if content.is_empty() {
        return refuse(Problem::Empty);
    }
    Ok(content)
}

/// The content as text.
fn text<'a>(path: &Path, bytes: &'a [u8]) -> Result<&'a str, FileError> {
    std::str::from_utf8(bytes).map_err(|e| {
        FileError::new(
            path,
            Problem::NotText {
                offset: e.valid_up_to(),
            },
        )
    })
}
