//! Prints how many seconds are simulated in a second of processor time, on one thread: two robots drive with a net of 2 m through
//! 13 cubes over 4 m, and through 80 over 12 m, in this project's engine and in rapier.
//!
//! For this project's engine it also prints what a step costs, stage by stage.
//!
//! Where the system tells (Linux), time is that of the processor, so that other programs do not count; elsewhere it is the clock's.

use pairtrawl_execution::rehearse_in;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Area, Footprint, NetSpec, Object, PairTrajectory, PhysicsParameters, PlannerParameters, Robot,
    Scene,
};
use pairtrawl_reference::Reference;
use pairtrawl_simulation::{Options, Simulation, Stage};
use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::sync::OnceLock;
use std::time::Instant;

/// When the clock was looked at first.
static STARTED: OnceLock<Instant> = OnceLock::new();
/// Cubes, and steps of 5 cm.
const RUNS: [(usize, usize); 2] = [(13, 80), (80, 240)];

fn main() -> Result<(), Box<dyn Error>> {
    for (cubes, steps) in RUNS {
        println!("{cubes} cubes");
        let (scene, trajectory) = run(cubes, steps);
        let reference = Reference::of_scene(&scene, &trajectory)?;
        for (name, options) in [
            ("steps of 10 ms", Options::default()),
            ("quick, 20 ms", Options::quick()),
            (
                "as with controllers, 2 ms",
                Options {
                    time_step: 2e-3,
                    ..Options::default()
                },
            ),
            ("rapier, 1 ms", Options::rapier()),
        ] {
            let mut simulation = Simulation::new(&scene, 2.0, &options)?;
            let started = seconds();
            let record = rehearse_in(&mut simulation, &scene, &reference, &options)?;
            let factor = record.duration / (seconds() - started);
            let home = record.gathered.iter().filter(|&&g| g).count();
            println!(
                "{name}: {factor:.1} simulated seconds a second, {home} of {cubes} cubes gathered"
            );
        }
        print_budget(&scene, &reference)?;
    }
    Ok(())
}

/// What a step of 10 ms costs.
fn print_budget(scene: &Scene, reference: &Reference) -> Result<(), Box<dyn Error>> {
    let options = Options::default();
    let mut simulation = Simulation::new(scene, 2.0, &options)?;
    simulation.measure(|| STARTED.get_or_init(Instant::now).elapsed().as_nanos() as u64);
    rehearse_in(&mut simulation, scene, reference, &options)?;
    let Some(work) = simulation.work() else {
        return Ok(());
    };
    let steps = work.steps as f64;
    let a_step = |count: u64| count as f64 / steps;
    println!(
        "a step: {:.1} parts, {:.1} places of contact, {:.3} orders, {:.2} systems of {:.0} products of blocks, {:.1} looks; unsolved: {}",
        a_step(work.parts),
        a_step(work.contacts),
        a_step(work.orders),
        a_step(work.systems),
        work.products as f64 / work.systems as f64,
        a_step(work.looks),
        work.unconverged,
    );
    for (stage, time) in Stage::ALL.iter().zip(work.times) {
        println!(
            "  {:10} {:6.1} us",
            format!("{stage:?}"),
            a_step(time) / 1e3
        );
    }
    Ok(())
}

/// Time of this thread on the processor, or of the clock, s.
fn seconds() -> f64 {
    let on_processor = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = on_processor.and_then(|s| s.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(
        || STARTED.get_or_init(Instant::now).elapsed().as_secs_f64(),
        |ns| ns * 1e-9,
    )
}

/// Straight ahead, through cubes that lie in rows.
fn run(cubes: usize, steps: usize) -> (Scene, PairTrajectory) {
    let pose = |x: f64, i: usize| Pose::new(x, 0.05 * i as f64, FRAC_PI_2);
    let path = |x: f64| (0..=steps).map(|i| pose(x, i)).collect();
    let trajectory = PairTrajectory {
        left: path(-0.4),
        right: path(0.4),
        step_time: 0.25,
    };
    let spacing = 0.0125 * (steps as f64) * 3.25 / cubes as f64;
    let object = |i: usize| Object {
        position: Point::new(0.06 * ((i * 5) % 7) as f64 - 0.18, 0.3 + spacing * i as f64),
        footprint: Footprint::Box(0.05, 0.05),
        mass: 0.025,
        leave: false,
    };
    let scene = Scene {
        name: "speed".to_owned(),
        area: Area {
            min: Point::new(-99.0, -99.0),
            max: Point::new(99.0, 99.0),
            resolution: 0.05,
        },
        obstacles: Vec::new(),
        map: None,
        objects: (0..cubes).map(object).collect(),
        start: trajectory.pair(0),
        end: trajectory.pair(steps),
        robot: Robot::default(),
        net: NetSpec::default(),
        planner: PlannerParameters::default(),
        physics: PhysicsParameters::default(),
    };
    (scene, trajectory)
}
