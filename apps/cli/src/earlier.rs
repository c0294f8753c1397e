//! The results of an earlier run, which must not pass for those of a run that fails.

use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Where the results of an earlier run go when a command fails, inside of the folder.
const EARLIER: &str = "earlier";

/// The folder that is being worked for, and the names of the results that it may hold.
static OPEN: Mutex<Option<(PathBuf, &'static [&'static str])>> = Mutex::new(None);

/// These results are being worked for.
pub fn work_for(folder: &Path, names: &'static [&'static str]) {
    *open() = Some((folder.to_owned(), names));
}

/// What stands in the folder now is this run's, or the work is over.
pub fn settle() {
    *open() = None;
}

/// Moves the results of an earlier run out of the way; the folder that they are in now, when there were any.
pub fn set_aside() -> Option<PathBuf> {
    let (folder, names) = open().take()?;
    let main = names.first()?;
    if !folder.join(main).is_file() {
        return None;
    }
    let earlier = folder.join(EARLIER);
    std::fs::create_dir_all(&earlier).ok()?;
    for name in names {
        // Not every run writes every file: what this one did not write must not stay from a run before it.
        if std::fs::rename(folder.join(name), earlier.join(name)).is_err() {
            let _ = std::fs::remove_file(earlier.join(name));
        }
    }
    Some(earlier)
}

fn open() -> std::sync::MutexGuard<'static, Option<(PathBuf, &'static [&'static str])>> {
    OPEN.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
}
