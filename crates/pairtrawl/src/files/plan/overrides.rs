//! Between the file's words for what the command line changed and the model's.

use super::file::{Auto, FileLeave, FileNetLength, FileOverrides};
use pairtrawl_model::{Leave, Overrides};

impl From<&Overrides> for FileOverrides {
    fn from(overrides: &Overrides) -> Self {
        let net_length = |length: Option<f64>| {
            length.map_or(FileNetLength::Auto(Auto::Auto), FileNetLength::Fixed)
        };
        Self {
            net_length: overrides.net_length.map(net_length),
            leave: overrides.leave.map(FileLeave::from),
        }
    }
}

impl From<FileOverrides> for Overrides {
    fn from(overrides: FileOverrides) -> Self {
        Self {
            net_length: overrides.net_length.map(|length| match length {
                FileNetLength::Fixed(length) => Some(length),
                FileNetLength::Auto(Auto::Auto) => None,
            }),
            leave: overrides.leave.map(Leave::from),
        }
    }
}
