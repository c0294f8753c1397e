use crate::arguments::{GenerateArguments, Kind, name};
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output::{Done, Report};
use crate::results::in_folder;
use pairtrawl::files::read_map;
use pairtrawl::generate::{self as scenes, Litter};
use pairtrawl::model::numbers::length;
use pairtrawl::model::{Scene, Warning};
use schemars::JsonSchema;
use serde::Serialize;
use std::path::Path;

/// Defaults of the arguments that only some kinds have.
const DIFFICULTY: u8 = 5;
const WAYPOINTS: u32 = 200;
const SIZE: [f64; 2] = [15.0, 10.0];
const BOXES: u32 = 3;
const OBJECTS: u32 = 12;
const NEAR: f64 = 0.62;

/// A generated scene in numbers.
#[derive(Serialize, JsonSchema)]
pub struct GenerateReport {
    /// How many objects lie in it.
    objects: usize,
    /// How many obstacles stand in it.
    obstacles: usize,
    /// Length of the net, m; left out where the planner chooses it.
    #[serde(skip_serializing_if = "Option::is_none")]
    net_length: Option<f64>,
    /// Waypoints of the plan that solves it; left out where none is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    waypoints: Option<usize>,
}

/// A scene, and what stands in its folder.
struct Made {
    scene: Scene,
    waypoints: Option<usize>,
    /// Names and contents, the scene last.
    files: Vec<(&'static str, Vec<u8>)>,
    warnings: Vec<Warning>,
}

/// `pairtrawl generate`: a scene that is solvable by construction with its solution, or litter as it lies.
pub fn generate(arguments: &GenerateArguments) -> Result<Done, Failure> {
    refuse_foreign(arguments)?;
    in_folder(&arguments.output, &[], |results| {
        let made = match arguments.kind {
            Kind::Witness => solvable(scenes::Kind::Witness, arguments),
            Kind::Serpentine => solvable(scenes::Kind::Serpentine, arguments),
            Kind::Litter => on_map(arguments),
            Kind::Hall => hall(arguments),
        }?;
        let files = results.write(&made.files)?;
        let about = GenerateReport {
            objects: made.scene.objects.len(),
            obstacles: made.scene.obstacles.len(),
            net_length: made.scene.net.length,
            waypoints: made.waypoints,
        };
        let mut text = format!(
            "{}: {} objects, {} obstacles",
            made.scene.name, about.objects, about.obstacles
        );
        if let (Some(net), Some(waypoints)) = (about.net_length, about.waypoints) {
            text.push_str(&format!(
                ", net {}, witness of {waypoints} waypoints",
                length(net)
            ));
        }
        text.push('\n');
        Report::new("generate", Exit::Done, about)
            .scene(&made.scene.name)
            .done(Exit::Done, text, &made.warnings, &files)
    })
}

/// Options that a kind does not have are mistakes.
fn refuse_foreign(arguments: &GenerateArguments) -> Result<(), Failure> {
    let natural = matches!(arguments.kind, Kind::Litter | Kind::Hall);
    let (litter, hall) = (
        matches!(arguments.kind, Kind::Litter),
        matches!(arguments.kind, Kind::Hall),
    );
    let given = [
        ("--difficulty", arguments.difficulty.is_some(), !natural),
        ("--waypoints", arguments.waypoints.is_some(), !natural),
        ("--map", arguments.map.is_some(), litter),
        ("--size", arguments.size.is_some(), hall),
        ("--obstacles", arguments.obstacles.is_some(), hall),
        ("--objects", arguments.objects.is_some(), natural),
        ("--near", arguments.near.is_some(), natural),
    ];
    match given.iter().find(|(_, is_given, has)| *is_given && !has) {
        None => Ok(()),
        Some((option, ..)) => {
            let kind = name(&arguments.kind).unwrap_or_default();
            let message = format!("{option} means nothing for --kind {kind}");
            Err(Failure::new(Exit::Usage, message)
                .with_help("leave it out, or choose another kind; `pairtrawl generate --help` lists who takes what"))
        }
    }
}

/// A scene with its solution.
fn solvable(kind: scenes::Kind, arguments: &GenerateArguments) -> Result<Made, Failure> {
    let difficulty = arguments.difficulty.unwrap_or(DIFFICULTY);
    let waypoints = arguments.waypoints.unwrap_or(WAYPOINTS) as usize;
    let made = scenes::generate(kind, difficulty, arguments.seed, waypoints)
        .map_err(|error| Failure::new(Exit::Usage, error.to_string()))?;
    let toml = scenes::scene_toml(&made.scene)
        .map_err(|error| Failure::new(Exit::Internal, error.to_string()))?;
    Ok(Made {
        waypoints: Some(made.witness.len()),
        files: vec![
            ("witness.json", scenes::witness_json(&made).into_bytes()),
            ("scene.toml", toml.into_bytes()),
        ],
        scene: made.scene,
        warnings: Vec::new(),
    })
}

/// Litter on a map, which is copied beside the scene.
fn on_map(arguments: &GenerateArguments) -> Result<Made, Failure> {
    let Some(path) = &arguments.map else {
        return Err(
            Failure::new(Exit::Usage, "--kind litter needs a map").with_help(
                "give a ROS map with --map MAP.yaml, or take --kind hall, which needs none",
            ),
        );
    };
    let loaded = read_map(path)?;
    let about = litter(arguments, &format!("litter-{}", name_of(path)));
    let scene = scenes::litter(loaded.map, loaded.area, &about)
        .map_err(|error| Failure::new(Exit::Usage, format!("{}: {error}", path.display())))?;
    let toml = scenes::scene_toml_on_map(&scene, "map.yaml");
    // The readers of maps tell images by their first bytes; the name is for people.
    let image = if loaded.image.starts_with(b"P") {
        "map.pgm"
    } else {
        "map.png"
    };
    Ok(Made {
        waypoints: None,
        files: vec![
            ("map.yaml", loaded.metadata.to_yaml(image).into_bytes()),
            (image, loaded.image),
            ("scene.toml", toml.into_bytes()),
        ],
        scene,
        warnings: loaded.warnings,
    })
}

/// Litter in an open hall.
fn hall(arguments: &GenerateArguments) -> Result<Made, Failure> {
    let size = arguments.size.unwrap_or(SIZE);
    let boxes = arguments.obstacles.unwrap_or(BOXES) as usize;
    let about = litter(arguments, &format!("hall-{}x{}-{boxes}", size[0], size[1]));
    let scene = scenes::litter_hall(size, boxes, &about)
        .map_err(|error| Failure::new(Exit::Usage, error.to_string()))?;
    let toml = scenes::scene_toml(&scene)
        .map_err(|error| Failure::new(Exit::Internal, error.to_string()))?;
    Ok(Made {
        waypoints: None,
        files: vec![("scene.toml", toml.into_bytes())],
        scene,
        warnings: Vec::new(),
    })
}

fn litter(arguments: &GenerateArguments, place: &str) -> Litter {
    let objects = arguments.objects.unwrap_or(OBJECTS) as usize;
    let near = arguments.near.unwrap_or(NEAR);
    let seed = arguments.seed;
    Litter {
        name: format!("{place}-{objects}-{near}-{seed}"),
        objects,
        near,
        seed,
    }
}

/// What people call a map: its file, or its folder where that says more.
fn name_of(path: &Path) -> String {
    let stem = |path: &Path| path.file_stem().map(|s| s.to_string_lossy().into_owned());
    let file = stem(path).unwrap_or_else(|| "map".to_owned());
    match path.parent().and_then(stem) {
        Some(folder) if file == "map" || folder.contains(&file) => folder,
        _ => file,
    }
}
