//! Plans a scene, and says what was proven and what the physics makes of it.
//!
//! `cargo run --example plan_scene -- [SCENE]`

use pairtrawl::model::{Rehearsal, numbers};
use pairtrawl::{PlanOptions, files, plan};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1);
    let path = path.unwrap_or_else(|| "scenes/witness-9/scene.toml".to_owned());
    let loaded = files::read_scene(Path::new(&path))?;
    let made = plan(
        &loaded.scene,
        &loaded.reference,
        &PlanOptions::default(),
        &mut (),
    )?;
    let plan = &made.plan;

    println!(
        "{}: a net of {}, J {}, {} waypoints, {} to drive",
        loaded.scene.name,
        numbers::length(plan.net_length),
        numbers::cost(plan.cost.total()),
        plan.trajectory.len(),
        numbers::duration(plan.times().last().copied().unwrap_or_default()),
    );
    for claim in &plan.certificate.claims {
        let margin = numbers::quantity(claim.margin, claim.id.unit());
        println!("  proven: {} (margin {margin})", claim.id.meaning());
    }
    match &plan.rehearsal {
        Rehearsal::Passed => println!("  the rehearsal brings everything home"),
        Rehearsal::Failed { event, time, .. } => println!(
            "  the rehearsal fails after {}: {event}",
            numbers::duration(*time)
        ),
        Rehearsal::Skipped => println!("  there was no rehearsal"),
    }
    for warning in &plan.warnings {
        println!("  warning: {warning}");
    }
    for stage in &made.stages {
        println!("  {:>10} {}", stage.name, numbers::duration(stage.seconds));
    }
    Ok(())
}
