use super::with_scene;
use crate::arguments::ExportArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt;
use crate::output::{Done, FilesAlone, Report};
use pairtrawl::execute::evenly_sampled;
use pairtrawl::files::{LoadedScene, read_plan, write_atomically};
use pairtrawl::reference::Reference;
use pairtrawl::simulation::export;
use std::path::PathBuf;

/// Time between two exported poses, s.
const SAMPLE_INTERVAL: f64 = 0.02;

/// `pairtrawl export`: scene, robots, net and objects for other simulators.
pub fn export(arguments: &ExportArguments) -> Result<Done, Failure> {
    with_scene(&arguments.scene, &|loaded| export_in(loaded, arguments))
}

fn export_in(loaded: &LoadedScene, arguments: &ExportArguments) -> Result<Done, Failure> {
    let file = read_plan(&arguments.plan)?;
    let scene = &loaded.scene;
    let cannot = |error: String| {
        Failure::new(
            Exit::BadInput,
            format!("{} cannot be exported: {error}", arguments.plan.display()),
        )
    };
    let reference = Reference::of_scene(scene, &file.trajectory(scene))
        .map_err(|error| cannot(error.to_string()))?;
    // Other simulators follow poses that are linear in time: the motion that is driven, finely sampled.
    let trajectory = evenly_sampled(&reference, SAMPLE_INTERVAL);
    let mut contents = Vec::new();
    if let Some(path) = &arguments.mjcf {
        contents.push((
            path.clone(),
            export::mjcf(scene, file.net_length, &trajectory)
                .map_err(|error| cannot(error.to_string()))?,
        ));
    }
    if let Some(path) = &arguments.sdf {
        contents.push((
            path.clone(),
            export::sdf(scene, file.net_length, &trajectory)
                .map_err(|error| cannot(error.to_string()))?,
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
