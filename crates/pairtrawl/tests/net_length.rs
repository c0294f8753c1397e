//! The cost of the best plan over the length of the net.

use pairtrawl::files::{LoadedScene, parse_scene, read_scene};
use pairtrawl::model::LengthRefusal;
use pairtrawl::{
    LengthRange, Observer, PlanError, PlanOptions, RehearsalMode, Stage, length_curve,
};
use std::sync::atomic::{AtomicUsize, Ordering};

fn scene(name: &str) -> LoadedScene {
    let path = format!(
        "{}/../../scenes/{name}/scene.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    read_scene(path.as_ref()).expect("the scene is good")
}

fn quick() -> PlanOptions {
    PlanOptions {
        explore: false,
        rehearsal: RehearsalMode::Skip,
        ..PlanOptions::default()
    }
}

#[test]
fn a_proof_against_every_length_is_an_error() {
    // The object lies 3 cm beside a wall that no robot passes behind.
    let text = r#"
        format = "pairtrawl-scene/1"
        area = { min = [0.0, 0.0], max = [6.0, 3.0], resolution = 0.05 }
        objects = [{ position = [3.0, 0.56], radius = 0.03 }]
        obstacles = [{ box = [0.0, 0.0, 6.0, 0.5] }]
        start = { left = [0.5, 1.95], right = [0.5, 1.25], heading = 0.0 }
        end = { left = [5.5, 1.95], right = [5.5, 1.25], heading = 0.0 }
    "#;
    let scene = parse_scene(text, "beside a wall")
        .expect("the scene is good")
        .scene;
    let range = LengthRange {
        points: 2,
        ..LengthRange::default_for(&scene)
    };
    let refused = length_curve(&scene, &quick(), &range, &mut ());
    assert!(
        matches!(refused, Err(PlanError::Infeasible(_))),
        "{refused:?}"
    );
}

#[test]
fn a_length_that_is_proven_too_short_is_a_point_that_says_so() {
    let scene = scene("witness-9").scene;
    let range = LengthRange {
        from: 0.2,
        to: LengthRange::default_for(&scene).to,
        points: 2,
    };
    let curve = length_curve(&scene, &quick(), &range, &mut ()).expect("there is a route");
    assert!(
        matches!(curve.points[0].outcome, Err(LengthRefusal::Proven(_))),
        "{:?}",
        curve.points
    );
    assert!(!curve.interrupted);
    assert!(curve.minimum.is_some());
}

/// Interrupts after so many questions of the last stage.
struct Impatient {
    solving: bool,
    questions: AtomicUsize,
}

impl Observer for Impatient {
    fn started(&mut self, stage: Stage, _round: usize) {
        self.solving = stage == Stage::Optimize;
    }

    fn interrupted(&self) -> bool {
        let one_less = |left: usize| left.checked_sub(1);
        self.solving
            && self
                .questions
                .fetch_update(Ordering::Relaxed, Ordering::Relaxed, one_less)
                .is_err()
    }
}

#[test]
fn what_is_solved_when_it_is_interrupted_is_kept() {
    let scene = scene("witness-9").scene;
    let range = LengthRange {
        points: 6,
        ..LengthRange::default_for(&scene)
    };
    let curve_after = |questions: usize| {
        let mut watch = Impatient {
            solving: false,
            questions: AtomicUsize::new(questions),
        };
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(1)
            .build()
            .expect("a thread");
        pool.install(|| length_curve(&scene, &quick(), &range, &mut watch))
            .expect("there is a route")
    };
    let whole = curve_after(usize::MAX);
    assert!(!whole.interrupted);
    assert_eq!(whole.points.len(), 6);
    let part = curve_after(150);
    assert!(part.interrupted);
    assert!(
        (1..6).contains(&part.points.len()),
        "{} points",
        part.points.len()
    );
    for point in &part.points {
        assert!(
            whole.points.contains(point),
            "{point:?} is not of the curve"
        );
    }
}
