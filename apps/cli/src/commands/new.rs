use super::planning::create_folder;
use crate::arguments::NewArguments;
use crate::exit::{Exit, Failure};
use crate::interrupt;
use crate::output::Done;
use pairtrawl::files::write_atomically;
use serde_json::json;

/// The commented scene that `new` writes.
pub const TEMPLATE: &str = include_str!("new_scene.toml");

/// `pairtrawl new`: a commented scene to start from. Never overwrites one.
pub fn new(arguments: &NewArguments) -> Result<Done, Failure> {
    let directory = &arguments.directory;
    let path = directory.join("scene.toml");
    // symlink_metadata: a dangling link is something, too.
    if path.symlink_metadata().is_ok() {
        return Err(Failure::new(
            Exit::Files,
            format!("{} exists and is not overwritten", path.display()),
        )
        .with_remedy("give another folder, or remove that file"));
    }
    create_folder(directory)?;
    interrupt::while_writing(|| write_atomically(&path, TEMPLATE.as_bytes()))?;
    let text = format!(
        "wrote {scene}\n\nnext: pairtrawl plan {scene} -o {out}\n",
        scene = path.display(),
        out = directory.join("out").display()
    );
    let object = json!({ "command": "new", "files": [path.display().to_string()] });
    Ok(Done {
        exit: Exit::Done,
        text,
        object,
    })
}
