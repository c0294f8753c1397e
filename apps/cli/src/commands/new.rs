use crate::arguments::NewArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output::{Done, FilesAlone, Report};
use crate::results::in_folder;

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
        .with_help("give another folder, or remove that file"));
    }
    in_folder(directory, &[], |results| {
        let files = results.write(&[("scene.toml", TEMPLATE)])?;
        let text = format!(
            "next: pairtrawl plan {} -o {}\n\n",
            path.display(),
            directory.join("out").display()
        );
        Report::new("new", Exit::Done, FilesAlone {}).done(Exit::Done, text, &[], &files)
    })
}
