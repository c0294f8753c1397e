//! What is finished of a reproduction that is not.

use crate::failure::Failure;
use crate::results::create_folder;
use pairtrawl::files::{sha256_hex, write_atomically};
use std::path::{Path, PathBuf};

/// The subfolder.
const FOLDER: &str = "unfinished";

/// A folder of finished pieces of work, each a file that says for which program and input it counts.
#[derive(Debug)]
pub struct Unfinished {
    folder: PathBuf,
    stamp: String,
}

impl Unfinished {
    /// In a subfolder of `output`.
    ///
    /// # Errors
    /// When it cannot be made.
    pub fn new(output: &Path, quick: bool, authors: Option<&str>) -> Result<Self, Failure> {
        let folder = output.join(FOLDER);
        create_folder(&folder)?;
        // Another build may compute other numbers. Where it cannot be read, the version has to do.
        let program = std::env::current_exe().and_then(std::fs::read);
        let program = program.map_or(env!("CARGO_PKG_VERSION").to_owned(), |bytes| {
            sha256_hex(&[&bytes])
        });
        let authors = authors.unwrap_or("none");
        let stamp = format!("program {program} quick {quick} authors {authors}");
        Ok(Self { folder, stamp })
    }

    /// A piece of work, when it is there and counts.
    pub fn read(&self, name: &str) -> Option<String> {
        let text = std::fs::read_to_string(self.path(name)).ok()?;
        let (stamp, content) = text.split_once('\n')?;
        (stamp == self.stamp).then(|| content.to_owned())
    }

    /// Keeps a piece of work. One that cannot be kept is made again after an interruption, no more.
    pub fn write(&self, name: &str, text: &str) {
        let content = format!("{}\n{text}", self.stamp);
        let _ = write_atomically(&self.path(name), content.as_bytes());
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.join(format!("{name}.txt"))
    }
}

/// Removes the subfolder of `output`, once all is finished.
pub fn remove(output: &Path) {
    // Only succeeds where there is one; one that stays behind does no harm.
    let _ = std::fs::remove_dir_all(output.join(FOLDER));
}
