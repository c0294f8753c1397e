//! Planning again while the pair is on its way.

use pairtrawl::files::{LoadedScene, read_scene};
use pairtrawl::geometry::{Point, Segment};
use pairtrawl::model::{Footprint, Object, PairPose, PairTrajectory, Plan, Scene, Warning};
use pairtrawl::{NetLength, PlanOptions, Planner, RehearsalMode};

fn planner(options: PlanOptions) -> Planner {
    Planner::new(PlanOptions {
        rehearsal: RehearsalMode::Skip,
        ..options
    })
}

fn paper_experiment() -> LoadedScene {
    let path = format!(
        "{}/../../scenes/paper-experiment/scene.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    read_scene(path.as_ref()).expect("the scene is good")
}

fn line(pair: PairPose) -> Segment {
    Segment::new(pair.left.position(), pair.right.position())
}

/// The scene for a pair that has passed a waypoint: what it swept is gone.
fn on_the_way(scene: &Scene, before: &PairTrajectory, passed: usize, start: PairPose) -> Scene {
    let mut rest = scene.clone();
    rest.start = start;
    rest.objects.retain(|object| {
        let swept = |i| line(before.pair(i)).distance(object.position) <= object.footprint_radius();
        !(0..=passed).any(swept)
    });
    rest
}

/// For each circle of a plan in its order, the first waypoint at which the line between the robots is nearest to it.
fn when_swept(plan: &Plan) -> Vec<usize> {
    let nearest = |center: Point| {
        let distance = |i: &usize| line(plan.trajectory.pair(*i)).distance(center);
        (0..plan.trajectory.len())
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .expect("waypoints")
    };
    (plan.order.iter())
        .map(|&circle| nearest(plan.circles[circle].center))
        .collect()
}

fn planned_from_nothing(plan: &Plan) -> bool {
    plan.warnings.contains(&Warning::PlannedFromNothing)
}

#[test]
fn the_net_keeps_its_length_in_mid_tow() {
    let loaded = paper_experiment();
    let planner = planner(PlanOptions {
        net_length: Some(NetLength::Auto),
        ..PlanOptions::default()
    });
    let before = planner
        .plan(&loaded.scene, &loaded.reference, &mut ())
        .expect("there is a plan")
        .plan;
    assert_eq!(before.overrides.net_length, Some(None));
    let passed = before.trajectory.len() / 4;
    let start = before.trajectory.pair(passed);
    let mut scene = on_the_way(&loaded.scene, &before.trajectory, passed, start);
    let rest = planner
        .replan(&before, passed, &scene, &loaded.reference, &mut ())
        .expect("there is a plan")
        .plan;
    assert!(!planned_from_nothing(&rest));
    assert_eq!(rest.net_length, before.net_length);
    assert_eq!(rest.overrides.net_length, Some(Some(before.net_length)));

    // An object off the path: planned from nothing, and with the same net all the same.
    scene.objects.push(Object {
        position: Point::new(3.9, 1.6),
        footprint: Footprint::Disc(0.03),
        mass: 0.025,
    });
    let rest = planner
        .replan(&before, passed, &scene, &loaded.reference, &mut ())
        .expect("there is a plan")
        .plan;
    assert!(planned_from_nothing(&rest));
    assert_eq!(rest.net_length, before.net_length);
}

#[test]
fn order_and_centerline_are_those_of_the_rest() {
    let loaded = paper_experiment();
    let planner = planner(PlanOptions::default());
    let before = planner
        .plan(&loaded.scene, &loaded.reference, &mut ())
        .expect("there is a plan")
        .plan;
    let passed = before.trajectory.len() / 4;
    let start = before.trajectory.pair(passed);
    let mut scene = on_the_way(&loaded.scene, &before.trajectory, passed, start);
    // In the file the last object now comes first: the file's order is not the one in which they are swept.
    scene.objects.reverse();
    let rest = planner
        .replan(&before, passed, &scene, &loaded.reference, &mut ())
        .expect("there is a plan")
        .plan;
    assert!(!planned_from_nothing(&rest));
    assert!(rest.circles.len() < before.circles.len());
    let swept = when_swept(&rest);
    assert!(swept.is_sorted(), "{:?} are swept at {swept:?}", rest.order);
    assert!(!rest.order.is_sorted(), "any order would pass");
    assert!(rest.centerline.is_empty(), "no centerline was searched");
}
