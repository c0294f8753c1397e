use super::planning::{create_folder, list};
use crate::arguments::{GenerateArguments, Kind};
use crate::exit::{Exit, Failure};
use crate::interrupt;
use crate::output::Done;
use pairtrawl::files::write_atomically;
use pairtrawl::generate as scenes;
use serde_json::json;

/// `pairtrawl generate`: a scene that is solvable by construction, and its solution.
pub fn generate(arguments: &GenerateArguments) -> Result<Done, Failure> {
    let kind = match arguments.kind {
        Kind::Witness => scenes::Kind::Witness,
        Kind::Serpentine => scenes::Kind::Serpentine,
    };
    let (difficulty, seed) = (arguments.difficulty, arguments.seed);
    let waypoints = arguments.waypoints as usize;
    let made = scenes::generate(kind, difficulty, seed, waypoints)
        .map_err(|error| Failure::new(Exit::Usage, error.to_string()))?;
    let toml = scenes::scene_toml(&made.scene)
        .map_err(|error| Failure::new(Exit::Internal, error.to_string()))?;

    create_folder(&arguments.output)?;
    let contents = [
        ("witness.json", scenes::witness_json(&made)),
        ("scene.toml", toml),
    ];
    let files: Vec<_> = contents
        .iter()
        .map(|(name, _)| arguments.output.join(name))
        .collect();
    interrupt::while_writing(|| {
        files
            .iter()
            .zip(&contents)
            .try_for_each(|(path, (_, text))| write_atomically(path, text.as_bytes()))
    })?;
    let text = format!(
        "{}: {} objects, {} obstacles, net {:.3} m, witness of {} waypoints\nwrote {}\n",
        made.scene.name,
        made.scene.objects.len(),
        made.scene.obstacles.len(),
        made.net_length,
        made.witness.len(),
        list(&files)
    );
    let object = json!({
        "command": "generate",
        "scene": made.scene.name,
        "objects": made.scene.objects.len(),
        "obstacles": made.scene.obstacles.len(),
        "net_length": made.net_length,
        "waypoints": made.witness.len(),
        "files": files.iter().map(|file| file.display().to_string()).collect::<Vec<_>>(),
    });
    Ok(Done {
        exit: Exit::Done,
        text,
        object,
    })
}
