//! Runs the built program and looks at how it ended.
#![allow(dead_code, reason = "each test file uses its own part")]

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};

/// The program with arguments, not started yet.
pub fn program<S: AsRef<std::ffi::OsStr>>(arguments: &[S]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_pairtrawl"));
    command.args(arguments).stdin(Stdio::null());
    command
}

/// Runs the program to its end.
pub fn run<S: AsRef<std::ffi::OsStr>>(arguments: &[S]) -> Output {
    program(arguments).output().expect("the program starts")
}

pub fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("standard output is UTF-8")
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("standard error is UTF-8")
}

/// What Ctrl-C does; the program must be running.
#[cfg(unix)]
pub fn interrupt(child: &Child) {
    let sent = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(
        sent.expect("kill runs").success(),
        "the program had ended before the signal"
    );
}

/// A JSON file.
pub fn json(path: &Path) -> Value {
    let text =
        std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).expect("JSON")
}

/// A scene of the library.
pub fn library_scene(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../scenes")
        .join(name)
        .join("scene.toml")
}

pub fn text(path: &Path) -> &str {
    path.to_str().expect("paths of tests are UTF-8")
}

/// A small scene that can be planned within a second.
pub const SMALL: &str = r#"
format = "pairtrawl-scene/1"
name = "small"

[area]
min = [0.0, 0.0]
max = [4.0, 3.0]
resolution = 0.05

[[obstacles]]
box = [1.8, 0.0, 2.2, 0.4]

[[objects]]
position = [2.0, 1.5]
size = [0.05, 0.05]

[start]
left = [0.5, 1.85]
right = [0.5, 1.15]
heading = 0.0

[end]
left = [3.5, 1.85]
right = [3.5, 1.15]
heading = 0.0

[net]
length = 1.2
"#;

/// The same with two more objects, of which object 1 is too close to the obstacle to be swept.
pub fn pinned() -> String {
    let objects = r#"
[[objects]]
position = [2.0, 0.6]
size = [0.05, 0.05]

[[objects]]
position = [2.5, 1.5]
radius = 0.03
"#;
    SMALL.replace("name = \"small\"", "name = \"pinned\"") + objects
}

/// A folder with `scene.toml` in it.
pub fn folder_with(scene: impl AsRef<[u8]>) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, scene).expect("the scene is written");
    (folder, path)
}

/// The names of all files below a folder, sorted; empty when it does not exist.
pub fn files_below(folder: &Path) -> Vec<String> {
    let mut names = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(next) = folders.pop() {
        let Ok(entries) = std::fs::read_dir(&next) else {
            continue;
        };
        for entry in entries {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else {
                names.push(
                    path.strip_prefix(folder)
                        .expect("below")
                        .display()
                        .to_string(),
                );
            }
        }
    }
    names.sort();
    names
}
