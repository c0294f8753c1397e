//! A scene at one moment, and the text and files that it is read from.

use pairtrawl::files::{FileError, LoadedScene, parse_scene_with, read_bounded};
use serde::{Deserialize, Serialize};
use std::cell::RefCell;
use std::path::{Path, PathBuf};
use toml::Table;

/// Bytes of a scene file, and of any file of its map, at most.
pub const FILE_BYTES: u64 = 256 << 20;

/// What a scene is read from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Source {
    /// The file, or what stands for it in messages.
    name: String,
    /// False for what never was a file: messages then do not name one.
    named: bool,
    text: String,
    /// The files of its map, by path.
    files: Vec<(PathBuf, Vec<u8>)>,
}

impl Source {
    /// The text of the scene file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// False for what never was a file.
    pub fn is_named(&self) -> bool {
        self.named
    }
}

/// A scene at one moment: edits make a new one, plans keep the one they are for.
pub struct SceneState {
    /// The scene as the library reads it.
    pub loaded: LoadedScene,
    source: Source,
}

impl SceneState {
    /// Reads a scene from its source.
    pub fn read(source: Source) -> Result<Self, FileError> {
        let file = |path: &Path| {
            let mut files = source.files.iter();
            files
                .find(|(name, _)| name == path)
                .map(|(_, content)| content.clone())
        };
        let loaded = parse_scene_with(&source.text, &source.name, &file)?;
        Ok(Self { loaded, source })
    }

    /// The same with another text, which nobody wrote to a file.
    pub fn with_text(&self, text: String) -> Result<Self, FileError> {
        let source = self.source.clone();
        Self::read(Source {
            text,
            named: false,
            ..source
        })
    }

    /// The source.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// A scene of a text that was just made, and never was a file.
    pub fn of_text(text: String) -> Result<Self, FileError> {
        Self::read(Source {
            name: "scene".to_owned(),
            named: false,
            text,
            files: Vec::new(),
        })
    }

    /// A scene of a text, and of the files on disk that it names, relative to `name`.
    pub fn with_files(name: String, named: bool, text: String) -> Result<Self, FileError> {
        let files = RefCell::new(Vec::new());
        let loaded = parse_scene_with(&text, &name, &|file| {
            let content = read_bounded(file, FILE_BYTES).ok()?;
            files.borrow_mut().push((file.to_owned(), content.clone()));
            Some(content)
        })?;
        let source = Source {
            name,
            named,
            text,
            files: files.into_inner(),
        };
        Ok(Self { loaded, source })
    }

    /// Its keys and values.
    pub fn document(&self) -> Result<Table, String> {
        self.source
            .text
            .parse::<Table>()
            .map_err(|error| error.to_string())
    }
}
