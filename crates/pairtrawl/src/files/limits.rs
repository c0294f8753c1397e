use super::{FileError, Problem};
use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;

/// Bytes of a scene file.
pub(super) const SCENE_BYTES: u64 = 4 << 20;
/// Bytes of a map's YAML file.
pub(super) const MAP_YAML_BYTES: u64 = 64 << 10;
/// Bytes of a map's image.
pub(super) const MAP_IMAGE_BYTES: u64 = 256 << 20;
/// Bytes of a plan.
pub(super) const PLAN_BYTES: u64 = 256 << 20;

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
pub(super) fn text<'a>(path: &Path, bytes: &'a [u8]) -> Result<&'a str, FileError> {
    std::str::from_utf8(bytes).map_err(|e| {
        FileError::new(
            path,
            Problem::NotText {
                offset: e.valid_up_to(),
            },
        )
    })
}
