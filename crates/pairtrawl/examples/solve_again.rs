//! Solves a plan again from its own baseline and says what that takes: `solve_again SCENE PLAN [auto] [REPEATS]`.
//!
//! Time is the processor's, the least of all repeats: on a machine that others use it says what wall time does not.

use pairtrawl::files::{read_plan, read_scene};
use pairtrawl::model::{PairTrajectory, Scales};
use pairtrawl::trajopt::{Problem, Settings, optimize};
use pairtrawl::world::World;
use std::error::Error;
use std::path::Path;

/// Seconds that this thread has spent on a processor.
fn processor_seconds() -> f64 {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 / 1e9
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (Some(scene), Some(plan)) = (arguments.first(), arguments.get(1)) else {
        return Err("usage: solve_again SCENE PLAN [auto] [REPEATS]".into());
    };
    let free = arguments.iter().any(|word| word == "auto");
    let repeats = (arguments.last().and_then(|word| word.parse().ok())).unwrap_or(1);
    let scene = read_scene(Path::new(scene))?.scene;
    let plan = read_plan(Path::new(plan))?;
    let scales = Scales::of(&scene);
    let length = (!free).then_some(scales.scaled(plan.net_length));
    let scaled = scales.scene(&scene);
    let world = World::new(&scaled, length)?;
    let problem = Problem::new(&scaled, length, &world.pieces);
    let (left, right) = plan
        .baseline
        .ok_or("the plan says nothing of its baseline")?;
    let baseline = scales.scaled_trajectory(&PairTrajectory {
        left,
        right,
        step_time: plan.step_time.ok_or("the plan has no step time")?,
    });
    let settings = Settings::default().settled();
    let mut least = f64::INFINITY;
    let mut solution = None;
    for _ in 0..repeats {
        let began = processor_seconds();
        solution = Some(optimize(&problem, &baseline, &settings));
        least = least.min(processor_seconds() - began);
    }
    let solution = solution.ok_or("REPEATS is 0")?;
    println!(
        "{}",
        serde_json::json!({
            "seconds": least,
            "iterations": solution.iterations,
            "status": solution.status.name(),
            "residual": solution.residual,
        })
    );
    Ok(())
}
