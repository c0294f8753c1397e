//! Planning through the library: errors, interruption, planning again.

use pairtrawl::files::{LoadedScene, read_scene};
use pairtrawl::geometry::Pose;
use pairtrawl::model::{ClaimId, Footprint, Object, Obstacle, Plan, Rehearsal, Warning};
use pairtrawl::{
    Candidate, NetLength, Observer, OrderMethod, PlanError, PlanOptions, Planned, Planner,
    RehearsalMode, Stage, check, plan,
};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

fn scene(name: &str) -> LoadedScene {
    let path = format!(
        "{}/../../scenes/{name}/scene.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    read_scene(path.as_ref()).expect("the scene is good")
}

fn quick() -> PlanOptions {
    PlanOptions {
        rehearsal: RehearsalMode::Skip,
        ..PlanOptions::default()
    }
}

fn planned(loaded: &LoadedScene, options: &PlanOptions) -> Planned {
    plan(&loaded.scene, &loaded.reference, options, &mut ()).expect("there is a plan")
}

/// Stops after a number of questions, and remembers which stages began.
struct Impatient {
    questions: AtomicUsize,
    stages: Vec<Stage>,
}

impl Observer for Impatient {
    fn started(&mut self, stage: Stage, _round: usize) {
        self.stages.push(stage);
    }

    fn interrupted(&self) -> bool {
        let one_less = |left: usize| left.checked_sub(1);
        let asked = self
            .questions
            .fetch_update(Ordering::Relaxed, Ordering::Relaxed, one_less);
        asked.is_err()
    }
}

#[test]
fn stages_run_in_order_and_are_timed() {
    let loaded = scene("witness-9");
    let mut watch = Impatient {
        questions: AtomicUsize::new(usize::MAX),
        stages: Vec::new(),
    };
    let made = plan(
        &loaded.scene,
        &loaded.reference,
        &PlanOptions::default(),
        &mut watch,
    )
    .expect("there is a plan");
    let expected = [
        Stage::Proofs,
        Stage::World,
        Stage::Order,
        Stage::Explore,
        Stage::Centerline,
        Stage::Baseline,
        Stage::Optimize,
        Stage::Certify,
        Stage::Rehearse,
    ];
    assert_eq!(watch.stages, expected);
    assert_eq!(
        made.stages
            .iter()
            .map(|s| s.name.as_str())
            .collect::<Vec<_>>(),
        expected.map(Stage::name)
    );
    assert_eq!(made.plan.rehearsal, Rehearsal::Passed);
    assert!(made.plan.certificate.is_valid() && made.rehearsal.is_some());
}

#[test]
fn an_observer_stops_it_at_any_question() {
    let loaded = scene("witness-9");
    for questions in [0, 1, 5, 9, 12, 20] {
        let mut watch = Impatient {
            questions: AtomicUsize::new(questions),
            stages: Vec::new(),
        };
        let stopped = plan(&loaded.scene, &loaded.reference, &quick(), &mut watch);
        assert_eq!(
            stopped.unwrap_err(),
            PlanError::Interrupted,
            "after {questions}"
        );
    }
}

/// Makes one stage outlast the time limit.
struct Slow {
    stage: Stage,
    pause: Duration,
}

impl Observer for Slow {
    fn started(&mut self, stage: Stage, _round: usize) {
        if stage == self.stage {
            std::thread::sleep(self.pause);
        }
    }
}

#[test]
fn the_time_limit_names_the_stage() {
    let loaded = scene("witness-9");
    let limit = Duration::from_secs(2);
    let options = PlanOptions {
        time_limit: Some(limit),
        explore: false,
        ..quick()
    };
    for stage in [Stage::World, Stage::Order] {
        let mut slow = Slow {
            stage,
            pause: limit,
        };
        let refused = plan(&loaded.scene, &loaded.reference, &options, &mut slow);
        let error = refused.expect_err("the time is up");
        assert_eq!(error, PlanError::TimeLimit { limit: 2.0, stage });
        assert!(error.to_string().contains(stage.name()), "{error}");
    }
}

/// Interrupts a stage that has asked so many times.
struct StopsIn {
    stage: Stage,
    running: Option<Stage>,
    questions: AtomicUsize,
}

impl Observer for StopsIn {
    fn started(&mut self, stage: Stage, _round: usize) {
        self.running = Some(stage);
    }

    fn finished(&mut self, stage: Stage, _seconds: f64) {
        // A stage that asks seldom has come to its end before it could be stopped.
        if stage == self.stage && self.questions.load(Ordering::Relaxed) > 0 {
            self.running = None;
        }
    }

    fn interrupted(&self) -> bool {
        self.running == Some(self.stage)
            && (self.questions)
                .fetch_update(Ordering::Relaxed, Ordering::Relaxed, |n| n.checked_sub(1))
                .is_err()
    }
}

#[test]
fn exploring_is_interrupted_between_iterations() {
    let loaded = scene("witness-9");
    let mut watch = StopsIn {
        stage: Stage::Explore,
        running: None,
        questions: AtomicUsize::new(20),
    };
    let stopped = plan(&loaded.scene, &loaded.reference, &quick(), &mut watch);
    assert_eq!(stopped.unwrap_err(), PlanError::Interrupted);
    assert_eq!(watch.running, Some(Stage::Explore));
}

#[test]
fn the_same_plan_on_one_thread_and_on_many() {
    let loaded = scene("witness-3");
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("a pool");
        let mut plan = pool
            .install(|| planned(&loaded, &PlanOptions::default()))
            .plan;
        plan.solver.seconds = 0.0;
        plan
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn a_given_order_is_kept() {
    let loaded = scene("paper-experiment");
    let options = PlanOptions {
        order: OrderMethod::Given,
        ..quick()
    };
    let plan = planned(&loaded, &options).plan;
    let firsts: Vec<_> = plan
        .order
        .iter()
        .map(|&c| plan.circles[c].objects.iter().min())
        .collect();
    assert!(firsts.is_sorted(), "{firsts:?}");
}

#[test]
fn a_net_shorter_than_the_pair_is_a_proof_and_not_a_failure() {
    let loaded = scene("paper-experiment");
    let options = PlanOptions {
        net_length: Some(NetLength::Fixed(0.5)),
        ..quick()
    };
    let refused = plan(&loaded.scene, &loaded.reference, &options, &mut ());
    assert!(
        matches!(refused, Err(PlanError::Infeasible { .. })),
        "{refused:?}"
    );
}

#[test]
fn a_moved_obstacle_is_planned_around_from_the_plan_before() {
    let mut loaded = scene("paper-experiment");
    let planner = Planner::new(quick());
    let before = planned(&loaded, &planner.options).plan;
    let Obstacle::Box { min, max } = &mut loaded.scene.obstacles[0] else {
        panic!("a box")
    };
    min.x -= 0.04;
    max.x -= 0.04;
    max.y += 0.06;
    let again = planner
        .replan(&before, 0, &loaded.scene, &loaded.reference, &mut ())
        .expect("there is a plan")
        .plan;
    assert!(again.certificate.is_valid());
    assert_eq!(
        again
            .warnings
            .iter()
            .filter(|w| **w == Warning::PlannedFromNothing)
            .count(),
        0
    );
    let cold = planned(&loaded, &planner.options).plan;
    let (warm_cost, cold_cost) = (again.cost.total(), cold.cost.total());
    assert!(
        warm_cost <= 1.002 * cold_cost,
        "J {warm_cost} warm, {cold_cost} cold"
    );
    assert!(
        again.solver.iterations < cold.solver.iterations,
        "{} iterations warm, {} cold",
        again.solver.iterations,
        cold.solver.iterations
    );
}

#[test]
fn a_pair_that_is_on_its_way_and_off_its_path_is_planned_on() {
    let mut loaded = scene("paper-experiment");
    let planner = Planner::new(quick());
    let before = planned(&loaded, &planner.options).plan;
    // At a quarter of the way, 1.5 cm off; what was swept is gathered.
    let at = before.trajectory.len() / 4;
    loaded.scene.start = before.trajectory.pair(at);
    loaded.scene.start.left.x += 0.015;
    loaded.scene.start.right.y -= 0.01;
    let scene = &mut loaded.scene;
    let start_y = scene.start.midpoint().y;
    scene
        .objects
        .retain(|object| object.position.y > start_y || object.position.x > 1.5);
    let again = planner
        .replan(&before, at, &loaded.scene, &loaded.reference, &mut ())
        .expect("there is a plan")
        .plan;
    assert!(again.certificate.is_valid());
    assert!(again.trajectory.len() < before.trajectory.len());
    assert_eq!(again.trajectory.pair(0).left.x, loaded.scene.start.left.x);
}

#[test]
fn an_object_off_the_path_makes_it_plan_from_nothing() {
    let mut loaded = scene("paper-experiment");
    let planner = Planner::new(quick());
    let before = planned(&loaded, &planner.options).plan;
    loaded.scene.objects.push(Object {
        position: pairtrawl::geometry::Point::new(3.8, 0.7),
        footprint: Footprint::Disc(0.03),
        mass: 0.025,
        leave: false,
    });
    let again = planner
        .replan(&before, 0, &loaded.scene, &loaded.reference, &mut ())
        .expect("there is a plan")
        .plan;
    assert!(again.certificate.is_valid());
    assert_eq!(
        again
            .warnings
            .iter()
            .filter(|w| **w == Warning::PlannedFromNothing)
            .count(),
        1,
        "{:?}",
        again.warnings
    );
}

#[test]
fn the_time_law_goes_with_the_plan() {
    let made = planned(&scene("witness-9"), &quick());
    let (law, trajectory) = (&made.plan.time_law, &made.plan.trajectory);
    assert_eq!(law.len(), trajectory.len());
    assert_eq!(law[0], 0.0);
    for (i, times) in law.windows(2).enumerate() {
        // Never faster than cruise speed, and never so slow that the pair hardly moves.
        let step = times[1] - times[0];
        let length = |poses: &[Pose]| poses[i].position().distance(poses[i + 1].position());
        let longer = length(&trajectory.left).max(length(&trajectory.right));
        assert!(step >= longer / 0.22 - 1e-9, "step {i} takes {step} s");
        assert!(
            step < 20.0 * trajectory.step_time,
            "step {i} takes {step} s"
        );
    }
}

#[test]
fn a_course_longer_than_the_waypoints_reach_is_named_with_the_number_needed() {
    // Start and end are close enough; the way between them is not straight.
    let loaded = scene("witness-2");
    let steps = |plan: &Planned| {
        let (left, right) = plan.plan.trajectory.path_lengths();
        (left.max(right) / 0.05).ceil() as usize
    };
    let needed = steps(&planned(&loaded, &quick()));
    let apart = loaded
        .scene
        .start
        .midpoint()
        .distance(loaded.scene.end.midpoint());
    let few = (2.0 * apart / 0.05) as usize;
    assert!(few < needed * 9 / 10, "{few} of {needed}");
    let options = PlanOptions {
        waypoints: Some(few),
        explore: false,
        ..quick()
    };
    let error = plan(&loaded.scene, &loaded.reference, &options, &mut ()).expect_err("too few");
    let message = error.to_string();
    assert!(message.contains(&format!("{few} waypoints")), "{message}");
    let remedy = error.remedy().expect("a remedy");
    assert!(remedy.starts_with("give at least"), "{remedy}");
    let named: usize = remedy
        .split(' ')
        .find_map(|word| word.parse().ok())
        .expect("a number");
    assert!(named.abs_diff(needed) < needed / 5, "{named}, {needed}");
}

#[test]
fn an_edited_time_law_is_judged_and_a_plan_without_one_is_read_linearly() {
    let loaded = scene("witness-9");
    let made = planned(&loaded, &quick()).plan;
    let speed = |time_law: Option<&[f64]>| {
        let candidate = Candidate {
            net_length: made.net_length,
            trajectory: &made.trajectory,
            scene: Some(&made.scene),
            overrides: &made.overrides,
            time_law,
            left_out: &[],
        };
        let certificate = check(&loaded.scene, &loaded.reference, &candidate);
        let claim = certificate.claims.iter().find(|c| c.id == ClaimId::Speed);
        (certificate.is_valid(), claim.unwrap().clone())
    };
    assert_eq!(speed(Some(&made.time_law)).1, made.certificate.claims[7]);
    assert!(speed(Some(&made.time_law)).0 && speed(None).0);
    let mut edited = made.time_law.clone();
    edited[10] += 0.5;
    let (valid, claim) = speed(Some(&edited));
    assert!(
        !valid && !claim.holds && claim.step == Some(10),
        "{claim:?}"
    );
    assert!(claim.detail.contains("step 10 takes -"), "{claim:?}");
    // A slower law keeps the robot's limits, but is not what is driven, which is said.
    let slower: Vec<f64> = made.time_law.iter().map(|t| 2.0 * t).collect();
    let (valid, claim) = speed(Some(&slower));
    assert!(
        valid && claim.detail.contains("another time law"),
        "{claim:?}"
    );
}

#[test]
fn more_waypoints_leave_the_run_time_as_it_is() {
    for name in ["witness-9", "paper-experiment"] {
        let loaded = scene(name);
        let made = planned(&loaded, &quick()).plan;
        let options = PlanOptions {
            waypoints: Some(2 * made.trajectory.len()),
            ..quick()
        };
        let fine = planned(&loaded, &options).plan;
        let duration = |plan: &Plan| plan.time_law[plan.time_law.len() - 1];
        let ratio = duration(&fine) / duration(&made);
        assert!(
            (ratio - 1.0).abs() < 0.05,
            "{name}: {ratio} times the run time"
        );
    }
}
