use super::with_scene;
use crate::arguments::ExportArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt;
use crate::output::{Done, FilesAlone, Report};
use pairtrawl::files::{LoadedScene, read_plan, write_atomically};
use pairtrawl::simulation::export;
use std::path::PathBuf;

/// `pairtrawl export`: scene, robots, net and objects for other simulators.
pub fn export(arguments: &ExportArguments) -> Result<Done, Failure> {
    with_scene(&arguments.scene, &|loaded| export_in(loaded, arguments))
}

fn export_in(loaded: &LoadedScene, arguments: &ExportArguments) -> Result<Done, Failure> {
    let file = read_plan(&arguments.plan)?;
    let scene = &loaded.scene;
    let trajectory = file.trajectory(scene);
    let mut contents = Vec::new();
    let cannot = |error: pairtrawl::simulation::SimulationError| {
        Failure::new(
            Exit::BadInput,
            format!("{} cannot be exported: {error}", arguments.plan.display()),
        )
    };
    if let Some(path) = &arguments.mjcf {
        contents.push((
            path.clone(),
            export::mjcf(scene, file.net_length, &trajectory).map_err(cannot)?,
        ));
    }
    if let Some(path) = &arguments.sdf {
        contents.push((
            path.clone(),
            export::sdf(scene, file.net_length, &trajectory).map_err(cannot)?,
        ));
    }
    interrupt::while_writing(|| {
        contents
            .iter()
            .try_for_each(|(path, text)| write_atomically(path, text.as_bytes()))
    })?;
    let files: Vec<PathBuf> = contents.into_iter().map(|(path, _)| path).collect();
    Report::new("export", Exit::Done, FilesAlone {})
        .scene(&scene.name)
        .done(Exit::Done, String::new(), &loaded.warnings, &files)
}
