//! Drives a plan by controllers in simulated physics, with noisy sensors and robots that differ from their model.
//!
//! `cargo run --example run_trial -- [SCENE]`

use pairtrawl::execute::{ExecutionOptions, execute};
use pairtrawl::model::{ControllerKind, numbers};
use pairtrawl::{PlanOptions, RehearsalMode, files, plan};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1);
    let path = path.unwrap_or_else(|| "scenes/witness-9/scene.toml".to_owned());
    let loaded = files::read_scene(Path::new(&path))?;
    let options = PlanOptions {
        rehearsal: RehearsalMode::Skip,
        ..PlanOptions::default()
    };
    let plan = plan(&loaded.scene, &loaded.reference, &options, &mut ())?.plan;

    let options = ExecutionOptions {
        controller: ControllerKind::Mrac,
        trials: 2,
        robot_mass: [0.9, 1.1],
        ..ExecutionOptions::default()
    };
    let execution = execute(&loaded.scene, &plan, &options, &())?;
    for warning in &execution.warnings {
        println!("warning: {warning}");
    }
    for trial in &execution.trials {
        let [left, right] = &trial.tracking;
        println!(
            "trial {}: {} of {} objects gathered in {}; farthest off the plan {} (left), {} (right)",
            trial.index,
            trial.gathered_count(),
            trial.gathered.len(),
            numbers::duration(trial.duration),
            numbers::length(left.max),
            numbers::length(right.max),
        );
        for event in &trial.events {
            println!(
                "  {} {}",
                numbers::duration(event.time),
                event.kind.describe()
            );
        }
    }
    Ok(())
}
