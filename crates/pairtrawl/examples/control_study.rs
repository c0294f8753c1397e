//! Measures what the controllers can do along a plan; `docs/control.md` quotes its tables.
//!
//! `cargo run --release --example control_study -- SCENE PLAN monte-carlo [RUNS]`
//! `cargo run --release --example control_study -- SCENE PLAN load-steps`
//! `cargo run --release --example control_study -- SCENE PLAN payload`
//! `cargo run --release --example control_study -- SCENE PLAN trials [TRIALS [LAW]]`
//! `cargo run --release --example control_study -- SCENE PLAN record FOLDER`

use pairtrawl::execute::{
    Drag, ExecutionOptions, MonteCarloOptions, NominalInertia, PlantParameters, ReducedRun,
    Sensing, controller_parameters, execute_trajectory, monte_carlo, write_recording,
};
use pairtrawl::files::{read_plan, read_scene, write_execution};
use pairtrawl::model::{ControllerKind, PairTrajectory, Scene};
use pairtrawl::reference::Reference;
use pairtrawl_control::{LawParameters, SupervisorLimits};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scene_path, plan_path, study, rest @ ..] = arguments.as_slice() else {
        println!("give SCENE PLAN and one of monte-carlo, load-steps, payload, trials, record");
        return Ok(());
    };
    let loaded = read_scene(Path::new(scene_path))?;
    let plan = read_plan(Path::new(plan_path))?;
    let (scene, length) = (&loaded.scene, plan.net_length);
    let trajectory = &plan.trajectory(scene);
    let count = |default: usize| rest.first().map_or(Ok(default), |n| n.parse());
    match study.as_str() {
        "monte-carlo" => monte_carlo_table(scene, trajectory, count(1000)?),
        "load-steps" => load_steps(scene, trajectory),
        "payload" => payload(scene, length, trajectory),
        "trials" => trials(
            scene,
            length,
            trajectory,
            count(5)?,
            rest.get(1).map(String::as_str),
        ),
        "record" => {
            let folder = rest.first().ok_or("give a folder")?;
            let options = ExecutionOptions {
                trials: 1,
                ..ExecutionOptions::default()
            };
            let execution = execute_trajectory(scene, length, trajectory, &options, &())?;
            write_execution(
                &Path::new(folder).join("execution.json"),
                &execution,
                &options,
                &loaded.reference,
            )?;
            write_recording(
                Path::new(folder),
                scene,
                length,
                trajectory,
                &trajectory.times(),
                &execution.trials[0],
            )?;
            Ok(())
        }
        other => Err(format!("there is no study {other}").into()),
    }
}

fn monte_carlo_table(
    scene: &Scene,
    trajectory: &PairTrajectory,
    runs: usize,
) -> Result<(), Box<dyn Error>> {
    for delayed_velocity in [false, true] {
        for nominal_inertia in [NominalInertia::PaperTable, NominalInertia::Robot] {
            println!("velocity delayed: {delayed_velocity}, nominal inertia: {nominal_inertia:?}");
            let options = MonteCarloOptions {
                runs,
                delayed_velocity,
                nominal_inertia,
                ..Default::default()
            };
            for row in monte_carlo(scene, trajectory, &options, &())?.rows {
                println!(
                    "{:12} success {:5.1} % stopped {:4} beyond traction {:3} rms {:.3?} max {:.3?} m torque {:.2} N m",
                    row.controller.name(),
                    100.0 * row.successes as f64 / row.runs as f64,
                    row.stopped,
                    row.failures_beyond_traction,
                    row.rms,
                    row.max,
                    row.max_torque
                );
            }
        }
    }
    Ok(())
}

/// 25 g more sixteen times; all of it drags at each robot, from directions that swing by 60 degrees.
fn load_steps(scene: &Scene, trajectory: &PairTrajectory) -> Result<(), Box<dyn Error>> {
    let reference = Reference::of_scene(scene, trajectory)?;
    let weight = scene.physics.object_friction * scene.physics.gravity;
    let drag = |time: f64| {
        let steps = (16.0 * time / reference.duration()).ceil().clamp(0.0, 16.0);
        let force = 0.025 * steps * weight;
        let swing = |phase: f64| {
            std::f64::consts::FRAC_PI_3 * libm::sin(std::f64::consts::TAU * time / 10.0 + phase)
        };
        [
            Drag {
                force,
                direction: swing(0.0),
            },
            Drag {
                force,
                direction: swing(2.0),
            },
        ]
    };
    let plant = PlantParameters::new(&scene.robot, &scene.physics, 1.0, 1.0);
    for (name, sensing) in [
        ("perfect sensors", Sensing::perfect()),
        ("noisy, 30 ms late", Sensing::default()),
    ] {
        for kind in ControllerKind::ALL {
            for factor in [0.25, 1.0, 4.0] {
                let mut controller = controller_parameters(scene, kind, NominalInertia::PaperTable);
                match &mut controller.law {
                    LawParameters::Mrac(g) => {
                        for rates in [&mut g.state_rate, &mut g.input_rate, &mut g.bias_rate] {
                            *rates = rates.map(|r| r * factor);
                        }
                    }
                    LawParameters::Integral(g) => g.integral = g.integral.map(|k| k * factor),
                    LawParameters::ModelBased if factor == 1.0 => {}
                    LawParameters::ModelBased => continue,
                }
                let supervisor = SupervisorLimits {
                    tracking_error: 1e3,
                    ..SupervisorLimits::default()
                };
                let run = ReducedRun {
                    reference: &reference,
                    controller,
                    supervisor,
                    sensing: [sensing; 2],
                    plants: [plant; 2],
                    drag: &drag,
                    seeds: [1, 2],
                };
                let outcome = run.drive(&())?.ok_or("interrupted")?;
                println!(
                    "{name:18} {:12} rates x{factor:<4} rms {:.4} max {:.4} m torque {:.3} N m adapted {:.3?}",
                    kind.name(),
                    outcome.rms(),
                    outcome.worst(),
                    outcome.max_torque,
                    outcome.greatest
                );
            }
        }
    }
    Ok(())
}

/// Full physics with heavier and heavier objects.
fn payload(scene: &Scene, length: f64, trajectory: &PairTrajectory) -> Result<(), Box<dyn Error>> {
    for kind in ControllerKind::ALL {
        for payload in [0.2, 0.4, 0.8, 1.6, 3.2, 4.8, 6.4] {
            let options = ExecutionOptions {
                controller: kind,
                trials: 1,
                payload: Some(payload),
                ..ExecutionOptions::default()
            };
            let mut heavy = scene.clone();
            heavy.physics.tension_limit = 100.0;
            let execution = execute_trajectory(&heavy, length, trajectory, &options, &())?;
            let Some(t) = execution.trials.first() else {
                continue;
            };
            let [left, right] = t.tracking;
            println!(
                "{:12} payload {payload:.1} kg rms {:.4} max {:.4} m drag {:.2} N torque {:.2} N m gathered {}/{} {}",
                kind.name(),
                left.settled_rms.max(right.settled_rms),
                left.settled_max.max(right.settled_max),
                t.drag[0].max.max(t.drag[1].max),
                t.max_torque[0].max(t.max_torque[1]),
                t.gathered_count(),
                t.gathered.len(),
                t.events.first().map_or(String::new(), |e| format!(
                    "{:.1} s: {}",
                    e.time,
                    e.kind.describe()
                ))
            );
            if t.tracking.iter().any(|s| s.settled_max > 0.2) {
                break;
            }
        }
    }
    Ok(())
}

/// Full physics, masses of 15 to 50 g.
fn trials(
    scene: &Scene,
    length: f64,
    trajectory: &PairTrajectory,
    count: usize,
    law: Option<&str>,
) -> Result<(), Box<dyn Error>> {
    let wanted = |kind: &ControllerKind| law.is_none_or(|name| kind.name() == name);
    for kind in ControllerKind::ALL.into_iter().filter(wanted) {
        let options = ExecutionOptions {
            controller: kind,
            trials: count,
            object_mass: Some([0.015, 0.050]),
            ..ExecutionOptions::default()
        };
        let execution = execute_trajectory(scene, length, trajectory, &options, &())?;
        let all = execution
            .trials
            .iter()
            .filter(|t| t.gathered_everything())
            .count();
        let clean = execution
            .trials
            .iter()
            .filter(|t| t.events.is_empty())
            .count();
        let worst = |f: &dyn Fn(&pairtrawl::model::TrackingStatistics) -> f64| {
            execution
                .trials
                .iter()
                .flat_map(|t| t.tracking.iter().map(f))
                .fold(0.0, f64::max)
        };
        println!(
            "{:12} {count} trials: all gathered in {all}, no event in {clean}, worst rms {:.4} m, worst error {:.4} m",
            kind.name(),
            worst(&|t| t.settled_rms),
            worst(&|t| t.settled_max)
        );
        for t in execution.trials.iter().filter(|_| count <= 20) {
            let first = t
                .events
                .first()
                .map(|e| format!("{:.1} s: {}", e.time, e.kind.describe()));
            println!(
                "    seed {:20} gathered {}/{} J {:.0} {}",
                t.seed,
                t.gathered_count(),
                t.gathered.len(),
                t.cost.total(),
                first.unwrap_or_default()
            );
        }
        println!("    {:?}", execution.warnings);
    }
    Ok(())
}
