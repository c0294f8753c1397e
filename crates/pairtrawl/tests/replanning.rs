//! Planning again while the pair is on its way.

use pairtrawl::files::{LoadedScene, parse_scene, read_scene};
use pairtrawl::geometry::{Point, Pose, Segment};
use pairtrawl::model::{Footprint, Object, PairPose, PairTrajectory, Plan, Scene, Warning};
use pairtrawl::{NetLength, OrderMethod, PlanOptions, Planner, RehearsalMode};

/// A hall in which the objects' own order leads once around and on along the first stretch.
const RING: &str = r#"
    format = "pairtrawl-scene/1"
    name = "ring"
    area = { min = [0.0, 0.0], max = [10.0, 7.0], resolution = 0.05 }
    objects = [
        { position = [3.8, 1.2], radius = 0.03 },
        { position = [5.0, 1.2], radius = 0.03 },
        { position = [8.2, 3.4], radius = 0.03 },
        { position = [5.0, 5.6], radius = 0.03 },
        { position = [1.8, 3.4], radius = 0.03 },
        { position = [4.4, 1.2], radius = 0.03 },
        { position = [5.6, 1.2], radius = 0.03 },
    ]
    start = { left = [1.0, 1.55], right = [1.0, 0.85], heading = 0.0 }
    end = { left = [9.0, 1.55], right = [9.0, 0.85], heading = 0.0 }
"#;

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

fn apart(a: PairPose, b: PairPose) -> f64 {
    a.left.position().distance(b.left.position()) + a.right.position().distance(b.right.position())
}

/// The first pair moved by a part of the way to the second one, its headings kept.
fn between(a: PairPose, b: PairPose, part: f64) -> PairPose {
    let moved = |a: Pose, b: Pose| {
        let step = (b.position() - a.position()) * part;
        Pose::at(a.position() + step, a.heading)
    };
    PairPose {
        left: moved(a.left, b.left),
        right: moved(a.right, b.right),
    }
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
fn a_way_that_passes_a_place_twice_is_planned_on_from_where_the_pair_has_come() {
    let loaded = parse_scene(RING, "ring").expect("the scene is good");
    let planner = planner(PlanOptions {
        order: OrderMethod::Given,
        ..PlanOptions::default()
    });
    let before = planner
        .plan(&loaded.scene, &loaded.reference, &mut ())
        .expect("there is a plan")
        .plan;
    let way = &before.trajectory;
    // The waypoints, half a round apart at least, between which the pair is nearest to where it has been.
    let (first, second) = (0..way.len())
        .flat_map(|i| (i + way.len() / 3..way.len()).map(move |j| (i, j)))
        .min_by(|a, b| {
            let gap = |(i, j): &(usize, usize)| apart(way.pair(*i), way.pair(*j));
            gap(a).total_cmp(&gap(b))
        })
        .expect("waypoints");
    // The pair is on its first round, off its path, and closer to where it is to be on the second.
    let start = between(way.pair(first), way.pair(second), 0.55);
    let nearest = (0..way.len())
        .min_by(|a, b| apart(way.pair(*a), start).total_cmp(&apart(way.pair(*b), start)))
        .expect("waypoints");
    assert!(
        nearest > first + way.len() / 4,
        "the way passes no place twice"
    );
    let scene = on_the_way(&loaded.scene, way, first, start);
    assert!(scene.objects.len() >= 3);
    let rest = planner
        .replan(&before, first, &scene, &loaded.reference, &mut ())
        .expect("there is a plan")
        .plan;
    assert!(rest.certificate.is_valid());
    assert!(!planned_from_nothing(&rest));
    assert_eq!(rest.trajectory.len(), way.len() - first);
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
        position: Point::new(3.9, 1.0),
        footprint: Footprint::Disc(0.03),
        mass: 0.025,
        leave: false,
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
