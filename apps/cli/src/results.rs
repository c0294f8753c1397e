//! The folder that a command writes its results to. That it can be written to is found out before any work; what an
//! earlier run left there is set aside when the command fails, so that nobody takes it for this run's.

use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt;
use crate::output::Done;
use pairtrawl::files::{check_writable, write_atomically};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Where the results of an earlier run go when a command fails, inside of the folder.
const EARLIER: &str = "earlier";

/// The folder that is being worked for, and the names of the results that it may hold.
static OPEN: Mutex<Option<(PathBuf, &'static [&'static str])>> = Mutex::new(None);

/// A folder for results.
#[derive(Debug)]
pub struct Results<'a> {
    folder: &'a Path,
}

impl Results<'_> {
    /// Writes files, each atomically, in the order given; Ctrl-C waits until it is done.
    pub fn write(&self, contents: &[(&str, impl AsRef<[u8]>)]) -> Result<Vec<PathBuf>, Failure> {
        interrupt::while_writing(|| {
            let written = contents.iter().map(|(name, content)| {
                let path = self.folder.join(name);
                write_atomically(&path, content.as_ref())?;
                Ok(path)
            });
            let written = written.collect::<Result<Vec<_>, Failure>>()?;
            // What stands there now is this run's.
            *open() = None;
            Ok(written)
        })
    }
}

/// Works for a folder, which is created when missing. `names` are the files that the work may write, the main one first:
/// where that one stands already, an earlier run's results stand. When the work fails they are moved to the subfolder
/// `earlier`, which replaces those that are there, and the failure says so; a folder that was created and stayed empty goes.
///
/// # Errors
/// What the work says, or at once that the folder cannot be made or written to.
pub fn in_folder(
    folder: &Path,
    names: &'static [&'static str],
    work: impl FnOnce(&Results<'_>) -> Result<Done, Failure>,
) -> Result<Done, Failure> {
    let missing = !folder.exists();
    let ready = std::fs::create_dir_all(folder)
        .map_err(|error| {
            let message = format!("cannot create the folder {}: {error}", folder.display());
            Failure::new(Exit::Files, message)
        })
        .and_then(|()| Ok(check_writable(folder)?));
    let ended = match ready {
        Err(failure) => Err(failure.with_help("give a folder that you may write to, with -o")),
        Ok(()) => {
            *open() = Some((folder.to_owned(), names));
            work(&Results { folder }).map_err(|mut failure| {
                failure.details.set_aside = set_aside().map(|folder| folder.display().to_string());
                failure
            })
        }
    };
    *open() = None;
    if ended.is_err() && missing {
        // Only succeeds while it is empty; a folder that stays behind does no harm.
        let _ = std::fs::remove_dir(folder);
    }
    ended
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
