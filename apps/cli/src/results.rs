//! The folder that a command writes its results to. That it can be written to is found out before any work; what an
//! earlier run left there is set aside when the command fails, so that nobody takes it for this run's.

use crate::earlier;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt;
use crate::output::Done;
use pairtrawl::files::{check_writable, write_atomically};
use std::path::{Path, PathBuf};

/// Makes a folder where there is none.
///
/// # Errors
/// What the system says.
pub fn create_folder(folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(|error| {
        let message = format!("cannot create the folder {}: {error}", folder.display());
        Failure::new(Exit::Files, message)
    })
}

/// A folder for results.
#[derive(Debug)]
pub struct Results<'a> {
    folder: &'a Path,
}

impl Results<'_> {
    /// Moves the results of an earlier run out of the way before this one writes that it failed; the folder that they are in
    /// now, when there were any.
    pub fn set_aside(&self) -> Option<String> {
        earlier::set_aside().map(|folder| folder.display().to_string())
    }

    /// Removes files that an earlier run left and that this one does not write.
    pub fn clear(&self, names: &[&str]) {
        for name in names {
            // Only succeeds where there is one.
            let _ = std::fs::remove_file(self.folder.join(name));
        }
    }

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
            earlier::settle();
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
    let ready = create_folder(folder).and_then(|()| Ok(check_writable(folder)?));
    let ended = match ready {
        Err(failure) => Err(failure.with_help("give a folder that you may write to, with -o")),
        Ok(()) => {
            earlier::work_for(folder, names);
            let results = Results { folder };
            work(&results).map_err(|mut failure| {
                let aside = results.set_aside();
                failure.details.set_aside = failure.details.set_aside.take().or(aside);
                failure
            })
        }
    };
    earlier::settle();
    if ended.is_err() && missing {
        // Only succeeds while it is empty; a folder that stays behind does no harm.
        let _ = std::fs::remove_dir(folder);
    }
    ended
}
