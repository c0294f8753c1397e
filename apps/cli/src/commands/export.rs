use super::planning::list;
use crate::arguments::ExportArguments;
use crate::exit::{Exit, Failure};
use crate::interrupt;
use crate::output::{self, Done};
use pairtrawl::files::{read_plan, read_scene, write_atomically};
use pairtrawl::simulation::export;
use serde_json::json;

/// `pairtrawl export`: scene, robots, net and objects for other simulators.
pub fn export(arguments: &ExportArguments) -> Result<Done, Failure> {
    let loaded = read_scene(&arguments.scene)?;
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
    let files: Vec<_> = contents.into_iter().map(|(path, _)| path).collect();
    let mut text = String::new();
    output::warnings(&mut text, &loaded.warnings);
    text.push_str(&format!("wrote {}\n", list(&files)));
    let object = json!({
        "command": "export",
        "files": files.iter().map(|file| file.display().to_string()).collect::<Vec<_>>(),
        "warnings": loaded.warnings,
    });
    Ok(Done {
        exit: Exit::Done,
        text,
        object,
    })
}
