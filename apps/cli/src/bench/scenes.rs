use crate::exit::Exit;
use crate::failure::Failure;
use std::path::{Path, PathBuf};

/// Folders inside one another that are looked into.
const DEEPEST: usize = 6;

/// A scene of a folder.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct SceneFile {
    /// Its path from the folder, without `scene.toml` or `.toml`, with `/`.
    pub name: String,
    /// The file.
    pub path: PathBuf,
}

/// All scenes below a folder, by name.
///
/// # Errors
/// When a folder cannot be read, or there is no scene.
pub fn scenes_below(folder: &Path) -> Result<Vec<SceneFile>, Failure> {
    let mut found = Vec::new();
    collect(folder, &mut Vec::new(), &mut found)?;
    found.sort();
    if found.is_empty() {
        let message = format!("{}: no .toml file lies below this folder", folder.display());
        let help = "give a folder of scenes; `pairtrawl generate` and `pairtrawl new` make some";
        return Err(Failure::new(Exit::BadInput, message).with_help(help));
    }
    Ok(found)
}

fn collect(
    folder: &Path,
    parts: &mut Vec<String>,
    found: &mut Vec<SceneFile>,
) -> Result<(), Failure> {
    let refuse = |error: std::io::Error| {
        let exit = match error.kind() {
            std::io::ErrorKind::NotFound | std::io::ErrorKind::NotADirectory => Exit::BadInput,
            _ => Exit::Files,
        };
        let message = format!("{}: the folder cannot be read: {error}", folder.display());
        Failure::new(exit, message).with_help("give a folder of scenes")
    };
    for entry in std::fs::read_dir(folder).map_err(refuse)? {
        let path = entry.map_err(refuse)?.path();
        let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
            continue;
        };
        if name.starts_with('.') {
            continue;
        }
        if path.is_dir() {
            if parts.len() < DEEPEST {
                parts.push(name.to_owned());
                collect(&path, parts, found)?;
                parts.pop();
            }
        } else if let Some(stem) = name.strip_suffix(".toml") {
            let mut own = parts.clone();
            if stem != "scene" || own.is_empty() {
                own.push(stem.to_owned());
            }
            let name = own.join("/");
            found.push(SceneFile { name, path });
        }
    }
    Ok(())
}
