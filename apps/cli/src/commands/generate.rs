use crate::arguments::{GenerateArguments, Kind};
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output::{Done, Report};
use crate::results::in_folder;
use pairtrawl::generate as scenes;
use pairtrawl::model::numbers::length;
use schemars::JsonSchema;
use serde::Serialize;

/// A generated scene in numbers.
#[derive(Serialize, JsonSchema)]
pub struct GenerateReport {
    /// How many objects lie in it.
    objects: usize,
    /// How many obstacles stand in it.
    obstacles: usize,
    /// Length of the net, m.
    net_length: f64,
    /// Waypoints of the plan that solves it.
    waypoints: usize,
}

/// `pairtrawl generate`: a scene that is solvable by construction, and its solution.
pub fn generate(arguments: &GenerateArguments) -> Result<Done, Failure> {
    in_folder(&arguments.output, &[], |results| {
        let kind = match arguments.kind {
            Kind::Witness => scenes::Kind::Witness,
            Kind::Serpentine => scenes::Kind::Serpentine,
        };
        let (difficulty, seed) = (arguments.difficulty, arguments.seed);
        let made = scenes::generate(kind, difficulty, seed, arguments.waypoints as usize)
            .map_err(|error| Failure::new(Exit::Usage, error.to_string()))?;
        let toml = scenes::scene_toml(&made.scene)
            .map_err(|error| Failure::new(Exit::Internal, error.to_string()))?;
        let files = results.write(&[
            ("witness.json", scenes::witness_json(&made)),
            ("scene.toml", toml),
        ])?;
        let about = GenerateReport {
            objects: made.scene.objects.len(),
            obstacles: made.scene.obstacles.len(),
            net_length: made.net_length,
            waypoints: made.witness.len(),
        };
        let text = format!(
            "{}: {} objects, {} obstacles, net {}, witness of {} waypoints\n",
            made.scene.name,
            about.objects,
            about.obstacles,
            length(about.net_length),
            about.waypoints,
        );
        Report::new("generate", Exit::Done, about)
            .scene(&made.scene.name)
            .done(Exit::Done, text, &[], &files)
    })
}
