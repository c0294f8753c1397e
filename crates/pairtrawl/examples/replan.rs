//! A pair is on its way when an obstacle turns out to stand elsewhere: plans the rest of the way anew.
//!
//! `cargo run --example replan`

use pairtrawl::geometry::Segment;
use pairtrawl::model::{Obstacle, PairTrajectory, Plan, Scene, numbers};
use pairtrawl::{PlanOptions, Planner, RehearsalMode, files};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let mut loaded = files::read_scene(Path::new("scenes/paper-experiment/scene.toml"))?;
    let planner = Planner::new(PlanOptions {
        rehearsal: RehearsalMode::Skip,
        ..PlanOptions::default()
    });
    let before = planner
        .plan(&loaded.scene, &loaded.reference, &mut ())?
        .plan;
    describe("before", &before);

    // Twenty seconds later the pair is 1 cm off its path. A mission knows how far it has come from the time that its
    // controllers are at, and which objects are in the net from where the line between the robots was.
    let passed = before.waypoint_at(20.0);
    let scene = &mut loaded.scene;
    remove_gathered(scene, &before.trajectory, passed);
    scene.start = before.trajectory.pair(passed);
    scene.start.left.x += 0.01;
    if let Some(Obstacle::Box { min, max }) = scene.obstacles.first_mut() {
        min.x -= 0.04;
        max.x -= 0.04;
    }
    let rest = planner
        .replan(&before, passed, scene, &loaded.reference, &mut ())?
        .plan;
    describe("the rest", &rest);
    for warning in &rest.warnings {
        println!("warning: {warning}");
    }
    Ok(())
}

/// Removes the objects that the line between the robots has passed over up to a waypoint.
fn remove_gathered(scene: &mut Scene, trajectory: &PairTrajectory, passed: usize) {
    scene.objects.retain(|object| {
        (0..=passed).all(|i| {
            let pair = trajectory.pair(i);
            let line = Segment::new(pair.left.position(), pair.right.position());
            line.distance(object.position) > object.footprint_radius()
        })
    });
}

fn describe(name: &str, plan: &Plan) {
    println!(
        "{name}: {} circles, {} waypoints, a net of {}, J {}, {} iterations; {} claims proven",
        plan.circles.len(),
        plan.trajectory.len(),
        numbers::length(plan.net_length),
        numbers::cost(plan.cost.total()),
        plan.solver.iterations,
        plan.certificate.claims.len(),
    );
}
