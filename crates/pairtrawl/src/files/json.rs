//! Reading JSON: the format that a text says it is of, and how a text is refused that is no JSON.

use super::{FileError, Problem};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::path::Path;

/// A value from the text of a file; `path` stands for the file in messages.
pub(super) fn from_json<T: DeserializeOwned>(text: &str, path: &Path) -> Result<T, FileError> {
    serde_json::from_str(text).map_err(|e| FileError {
        path: path.to_owned(),
        line: (e.line() > 0).then(|| e.line()),
        problem: Problem::Syntax {
            reason: e.to_string(),
        },
    })
}

/// The format that a text says it is of; a file of another kind has other fields.
pub(super) fn stated_format(text: &str, path: &Path) -> Result<Option<String>, FileError> {
    #[derive(Deserialize)]
    struct Header {
        format: Option<String>,
    }
    let header: Header = from_json(text, path)?;
    Ok(header.format)
}
