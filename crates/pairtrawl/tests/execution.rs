//! Trials in full physics, reduced plants, files.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

mod drive;

use pairtrawl::execute::{
    Drag, ExecutionObserver, ExecutionOptions, MonteCarloOptions, NominalInertia, PlantParameters,
    Plants, ReducedRun, Sensing, controller_parameters, execute_trajectory, monte_carlo, recording,
};
use pairtrawl::files::execution_json;
use pairtrawl::model::{ControllerKind, Execution, ExecutionEventKind, SceneReference};
use pairtrawl::reference::Reference;
use pairtrawl_control::SupervisorLimits;
use std::sync::atomic::{AtomicUsize, Ordering};

fn options() -> ExecutionOptions {
    ExecutionOptions {
        trials: 2,
        ..ExecutionOptions::default()
    }
}

fn run(options: &ExecutionOptions) -> Execution {
    let t = drive::trajectory();
    execute_trajectory(&drive::scene(&t), drive::NET, &t, options, &()).unwrap()
}

fn without_clock(mut execution: Execution) -> Execution {
    execution.trials.iter_mut().for_each(|t| t.seconds = 0.0);
    execution
}

#[test]
fn the_adaptive_law_brings_everything_home_and_threads_change_nothing() {
    let pool = |threads| {
        rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap()
    };
    let one = pool(1).install(|| run(&options()));
    let two = pool(2).install(|| run(&options()));
    assert!(one.gathered_everything(), "{:?}", one.trials[0].gathered);
    assert!(one.warnings.is_empty() && one.reference_certificate.is_valid());
    for trial in &one.trials {
        assert!(trial.events.is_empty(), "{:?}", trial.events);
        for t in trial.tracking {
            assert!(t.settled_rms < 0.02 && t.settled_max < 0.05, "{t:?}");
        }
        assert!(
            trial.drag[0].mean > 0.02 && trial.drag[0].max < 2.0,
            "{:?}",
            trial.drag
        );
        assert!(trial.cost.distance > 1000.0);
    }
    assert_ne!(one.trials[0].seed, one.trials[1].seed);
    assert_eq!(without_clock(one), without_clock(two));
}

#[test]
fn the_printed_law_drifts_until_the_pair_is_stopped_and_stands() {
    let kind = ControllerKind::ModelBased;
    let execution = run(&ExecutionOptions {
        controller: kind,
        trials: 1,
        payload: Some(0.4),
        ..options()
    });
    let trial = &execution.trials[0];
    let mass: f64 = trial.conditions.object_masses.iter().sum();
    assert!((mass - 0.4).abs() < 1e-12);
    let stopped = trial
        .events
        .iter()
        .any(|e| matches!(e.kind, ExecutionEventKind::PairStopped { .. }));
    assert!(stopped, "{:?}", trial.events);
    let last = trial.samples.last().unwrap();
    assert!(
        last.forward.iter().all(|v| v.abs() < 0.02),
        "still moving at {:?} m/s",
        last.forward
    );
    // Both cubes lay in the net, but they did not come to the end.
    assert!(!execution.gathered_everything() && trial.duration < execution.reference_duration);
}

/// Interrupts once a trial is finished.
struct StopsAfterOne(AtomicUsize);

impl ExecutionObserver for StopsAfterOne {
    fn finished(&self, _index: usize) {
        self.0.fetch_add(1, Ordering::SeqCst);
    }
    fn interrupted(&self) -> bool {
        self.0.load(Ordering::SeqCst) > 0
    }
}

#[test]
fn finished_trials_are_kept_when_interrupted() {
    let t = drive::trajectory();
    let options = ExecutionOptions {
        trials: 3,
        ..options()
    };
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    let observer = StopsAfterOne(AtomicUsize::new(0));
    let execution = pool
        .install(|| execute_trajectory(&drive::scene(&t), drive::NET, &t, &options, &observer))
        .unwrap();
    assert!(execution.interrupted && !execution.gathered_everything());
    assert_eq!((execution.trials.len(), execution.trials_wanted), (1, 3));
}

#[test]
fn options_out_of_range_are_named() {
    let t = drive::trajectory();
    let refuse = |options: ExecutionOptions| {
        execute_trajectory(&drive::scene(&t), drive::NET, &t, &options, &())
            .unwrap_err()
            .to_string()
    };
    assert!(
        refuse(ExecutionOptions {
            friction: [2.0, 1.0],
            ..options()
        })
        .contains("friction is 1")
    );
    assert!(
        refuse(ExecutionOptions {
            trials: 0,
            ..options()
        })
        .contains("trials is 0")
    );
    let mut odd = options();
    odd.physics.time_step = 0.0015;
    assert!(refuse(odd).contains("time_step"));
}

#[test]
fn files_say_what_happened() {
    let execution = run(&ExecutionOptions {
        trials: 1,
        ..options()
    });
    let json: serde_json::Value = serde_json::from_str(&execution_json(
        &execution,
        &options(),
        &SceneReference::default(),
    ))
    .unwrap();
    assert_eq!(json["format"], "pairtrawl-execution/1");
    let trial = &json["trials"][0];
    assert_eq!(trial["gathered"], serde_json::json!([true, true]));
    assert_eq!(trial["controller"], "mrac");
    assert_eq!(trial["seed"].as_u64(), Some(execution.trials[0].seed));
    assert_eq!(trial["final"]["net"].as_array().map(Vec::len), Some(16));
    for key in ["events", "tracking", "cost", "drag", "seconds"] {
        assert!(!trial[key].is_null(), "{key}");
    }
    assert_eq!(json["summary"]["gathered_rate"], 1.0);

    let t = drive::trajectory();
    let scene = drive::scene(&t);
    let files = recording(&scene, drive::NET, &t, &t.times(), &execution.trials[0]).unwrap();
    let summary = mcap::Summary::read(&files.mcap).unwrap().unwrap();
    assert!(
        !summary.chunk_indexes.is_empty(),
        "chunk indexes must be kept"
    );
    let messages: Vec<_> = mcap::MessageStream::new(&files.mcap)
        .unwrap()
        .map(Result::unwrap)
        .collect();
    let of = |topic: &str| messages.iter().filter(|m| m.channel.topic == topic).count();
    let (samples, frames) = (
        execution.trials[0].samples.len(),
        execution.trials[0].frames.len(),
    );
    assert_eq!(
        (of("/left/odom"), of("/tf"), of("/markers"), of("/map")),
        (samples, samples, frames, 1)
    );
    assert!(messages.windows(2).all(|w| w[0].log_time <= w[1].log_time));
    assert!(
        messages
            .iter()
            .all(|m| m.channel.message_encoding == "cdr" && m.data[..4] == [0, 1, 0, 0])
    );
    assert!(
        files
            .metadata
            .contains(&format!("  message_count: {}\n", messages.len()))
    );
    // A path: header (time 0, "map" in 4 + 4 bytes), then as many poses as the plan has waypoints.
    let path = messages
        .iter()
        .find(|m| m.channel.topic == "/left/plan")
        .unwrap();
    assert_eq!(path.data[20..24], (t.len() as u32).to_le_bytes());
}

#[test]
fn every_law_meets_the_same_random_runs() {
    let t = drive::trajectory();
    let scene = drive::scene(&t);
    let options = MonteCarloOptions {
        runs: 20,
        ..MonteCarloOptions::default()
    };
    let table = monte_carlo(&scene, &t, &options, &()).unwrap();
    assert!(!table.interrupted);
    let row = |kind| table.rows.iter().find(|r| r.controller == kind).unwrap();
    assert_eq!(
        row(ControllerKind::Mrac).successes,
        20,
        "{:?}",
        row(ControllerKind::Mrac)
    );
    assert!(
        row(ControllerKind::ModelBased).successes < 10,
        "{:?}",
        row(ControllerKind::ModelBased)
    );
    assert!(row(ControllerKind::ModelBased).max[0] > 2.0 * row(ControllerKind::Mrac).max[0]);
    assert_eq!(monte_carlo(&scene, &t, &options, &()).unwrap(), table);
}

#[test]
fn every_law_meets_the_same_random_runs_in_full_physics() {
    let t = drive::trajectory();
    let scene = drive::scene(&t);
    let options = MonteCarloOptions {
        plants: Plants::Full {
            net_length: drive::NET,
            physics: pairtrawl::simulation::Options::default(),
        },
        runs: 6,
        ..MonteCarloOptions::default()
    };
    let table = monte_carlo(&scene, &t, &options, &()).unwrap();
    assert!(!table.interrupted);
    let row = |kind| table.rows.iter().find(|r| r.controller == kind).unwrap();
    let (adaptive, model_based) = (row(ControllerKind::Mrac), row(ControllerKind::ModelBased));
    assert!(adaptive.successes > model_based.successes, "{table:?}");
    // Runs that stay on their path bring home what lies on it.
    let all = scene.objects.len() as f64;
    assert!(adaptive.gathered.unwrap() > 0.9 * all, "{adaptive:?}");
    assert!(
        adaptive.max[0] < 0.1 && adaptive.rms[0] > 0.0,
        "{adaptive:?}"
    );
    let one = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    assert_eq!(
        one.install(|| monte_carlo(&scene, &t, &options, &()).unwrap()),
        table
    );
}

#[test]
fn growing_load_from_varying_directions_is_held() {
    let t = drive::trajectory();
    let scene = drive::scene(&t);
    let reference = Reference::of_scene(&scene, &t).unwrap();
    // 25 g more sixteen times over the drive, on each robot.
    let drag = |time: f64| {
        let steps = (16.0 * time / reference.duration()).ceil().clamp(0.0, 16.0);
        let direction = (0.6 * time).sin();
        [
            Drag {
                force: 0.025 * steps * 0.2 * 9.81,
                direction,
            },
            Drag {
                force: 0.1,
                direction: -direction,
            },
        ]
    };
    for sensing in [Sensing::perfect(), Sensing::default()] {
        let run = ReducedRun {
            reference: &reference,
            controller: controller_parameters(
                &scene,
                ControllerKind::Mrac,
                NominalInertia::PaperTable,
            ),
            supervisor: SupervisorLimits::default(),
            sensing: [sensing; 2],
            plants: [PlantParameters::new(&scene.robot, &scene.physics, 1.0, 1.0); 2],
            drag: &drag,
            seeds: [3, 4],
        };
        let outcome = run.drive(&()).unwrap().unwrap();
        assert_eq!(outcome.stopped, None);
        assert!(
            outcome.rms() < 0.02 && outcome.worst() < 0.05,
            "{outcome:?}"
        );
        assert!(outcome.max_torque < 3.0);
    }
}
