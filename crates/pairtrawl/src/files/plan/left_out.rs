//! Between the file's words for what is left and the model's.

use super::file::{FileLeave, FileLeftOut, FileLeftWhy};
use pairtrawl_model::{Leave, LeftOut, LeftWhy};

impl From<&LeftOut> for FileLeftOut {
    fn from(left: &LeftOut) -> Self {
        Self {
            object: left.object,
            why: match left.why {
                LeftWhy::Proven => FileLeftWhy::Proven,
                LeftWhy::NotFound => FileLeftWhy::NotFound,
            },
            text: left.text.clone(),
        }
    }
}

impl From<FileLeftOut> for LeftOut {
    fn from(left: FileLeftOut) -> Self {
        Self {
            object: left.object,
            why: match left.why {
                FileLeftWhy::Proven => LeftWhy::Proven,
                FileLeftWhy::NotFound => LeftWhy::NotFound,
            },
            text: left.text,
        }
    }
}

impl From<Leave> for FileLeave {
    fn from(leave: Leave) -> Self {
        match leave {
            Leave::None => Self::None,
            Leave::Unreachable => Self::Unreachable,
        }
    }
}

impl From<FileLeave> for Leave {
    fn from(leave: FileLeave) -> Self {
        match leave {
            FileLeave::None => Self::None,
            FileLeave::Unreachable => Self::Unreachable,
        }
    }
}
