use pairtrawl_world::WorldError;
use pairtrawl_world::ros_map::RosMapError;
use std::path::{Path, PathBuf};

/// A file that cannot be read or written, or does not say what it must.
#[derive(Debug, thiserror::Error)]
#[error("{}{}: {problem}", path.display(), line.map(|n| format!(":{n}")).unwrap_or_default())]
pub struct FileError {
    /// The file.
    pub path: PathBuf,
    /// The line, from 1, where there is one.
    pub line: Option<usize>,
    /// What is wrong with it.
    pub problem: Problem,
}

/// What is wrong with a file.
#[derive(Debug, thiserror::Error)]
pub enum Problem {
    /// It is not there.
    #[error("there is no such file")]
    Missing,
    /// It is a folder.
    #[error("this is a folder, a file is needed")]
    Directory,
    /// It is a device, a pipe or a socket, which may have no end.
    #[error("this is a device, pipe or socket, a regular file is needed")]
    NotRegular,
    /// It is longer than anything of its kind.
    #[error("the file has more than {bound} bytes, the bound for its kind")]
    TooLong {
        /// The greatest number of bytes.
        bound: u64,
    },
    /// It has no content.
    #[error("the file is empty")]
    Empty,
    /// It is not text.
    #[error("the file is not UTF-8 text: byte {offset} does not fit")]
    NotText {
        /// Offset of the first byte that does not fit.
        offset: usize,
    },
    /// It is not TOML or JSON.
    #[error("{reason}")]
    Syntax {
        /// What the parser says.
        reason: String,
    },
    /// Its first field names another format or version.
    #[error("format is {found:?}, this program reads {expected:?}")]
    Format {
        /// What the file says.
        found: String,
        /// What is read.
        expected: &'static str,
    },
    /// A key that means nothing.
    #[error("unknown key {key}: {remedy}")]
    UnknownKey {
        /// The key with its table.
        key: String,
        /// The key that was probably meant, or the keys that there are.
        remedy: String,
    },
    /// A key that must be there.
    #[error("{field} is missing: {remedy}")]
    MissingKey {
        /// The key with its table.
        field: String,
        /// What to write.
        remedy: String,
    },
    /// A value of the wrong type or out of range.
    #[error("{field} is {value}, it must be {bound}")]
    Value {
        /// The key with its table.
        field: String,
        /// The value as it stands.
        value: String,
        /// What is allowed.
        bound: String,
    },
    /// Values that do not go together.
    #[error("{field}: {reason}")]
    Conflict {
        /// The key with its table.
        field: String,
        /// What does not go together, with numbers, and the remedy.
        reason: String,
    },
    /// The scene cannot be turned into a world.
    #[error(transparent)]
    World(#[from] WorldError),
    /// A ROS map is damaged.
    #[error(transparent)]
    Map(#[from] RosMapError),
    /// The system refuses: permission, disk.
    #[error("cannot {action}: {source}")]
    System {
        /// What was tried.
        action: &'static str,
        /// What the system says.
        source: std::io::Error,
    },
}

impl FileError {
    pub(super) fn new(path: &Path, problem: impl Into<Problem>) -> Self {
        Self {
            path: path.to_owned(),
            line: None,
            problem: problem.into(),
        }
    }

    #[cfg(feature = "fs")]
    pub(super) fn system(path: &Path, action: &'static str, source: std::io::Error) -> Self {
        Self::new(path, Problem::System { action, source })
    }

    /// True when the system refuses (permission, disk). A file that is not there counts as bad input: the
    /// user can correct its name.
    pub fn is_from_system(&self) -> bool {
        matches!(self.problem, Problem::System { .. })
    }
}
