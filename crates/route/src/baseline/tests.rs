use super::*;
use crate::centerline::hybrid_a_star;
use crate::centerline::itinerary::Itinerary;
use crate::terrain::tests::{box_distance, pair_pose, scene};
use pairtrawl_geometry::{Segment, wrap_angle};
use pairtrawl_model::PairPose;

struct Case {
    scene: Scene,
    terrain: Terrain,
    circles: Vec<Circle>,
    order: Vec<usize>,
    line: Vec<Pose>,
}

const BOXES: [[f64; 4]; 2] = [[3.0, 1.8, 6.0, 4.0], [6.3, 1.0, 6.9, 1.8]];

fn obstacle(p: Point) -> f64 {
    BOXES
        .iter()
        .map(|&b| box_distance(p, b))
        .fold(f64::INFINITY, f64::min)
}

/// Around a box through five objects, two of them in one circle and off its center.
fn case() -> Case {
    let objects = [[2.0, 4.5], [4.6, 5.0], [4.8, 5.3], [7.6, 3.0], [5.0, 0.9]];
    let scene = scene(
        9.0,
        7.0,
        &objects,
        pair_pose(1.0, 1.5, 1.5),
        pair_pose(2.2, 0.9, -3.0),
    );
    let circle = |x, y, radius, objects| Circle {
        center: Point::new(x, y),
        radius,
        objects,
    };
    let circles = vec![
        circle(5.0, 0.9, 0.275, vec![4]),
        circle(4.7, 5.15, 0.455, vec![1, 2]),
        circle(2.0, 4.5, 0.275, vec![0]),
        circle(7.6, 3.0, 0.275, vec![3]),
    ];
    let terrain = Terrain::sample(&scene, obstacle);
    let order = vec![2, 1, 3, 0];
    let line =
        hybrid_a_star::on_terrain(&terrain, &Itinerary::new(&circles, &scene, &order).unwrap())
            .unwrap();
    Case {
        scene,
        terrain,
        circles,
        order,
        line,
    }
}

impl Case {
    fn baseline(&self, waypoints: Option<usize>) -> Result<PairTrajectory, RouteError> {
        on_terrain(
            &self.terrain,
            &self.scene,
            &self.circles,
            &self.line,
            &self.order,
            waypoints,
        )
    }
}

#[test]
fn the_pair_takes_every_object_between_it_and_leaves_every_obstacle_outside() {
    let case = case();
    let pair = case.baseline(None).unwrap();
    let n = pair.len();
    for i in 0..n {
        let (l, r) = (pair.left[i].position(), pair.right[i].position());
        assert!(obstacle(l).min(obstacle(r)) > 0.24, "waypoint {i}");
        for k in 0..=20 {
            assert!(obstacle(l.lerp(r, f64::from(k) / 20.0)) > 0.0, "rung {i}");
        }
        let separation = l.distance(r);
        assert!(
            separation > 0.49 && separation < 0.95 * 1.5,
            "waypoint {i}: {separation}"
        );
        for object in &case.scene.objects {
            let near = object.position.distance(l).min(object.position.distance(r));
            assert!(near > 0.24 + 0.035 + 0.02, "waypoint {i}: {near}");
        }
        if i > 0 && i + 1 < n {
            let normal = pair.pair(i).normal_heading();
            for pose in [pair.left[i], pair.right[i]] {
                assert!(
                    wrap_angle(pose.heading - normal).abs() < 1.0,
                    "waypoint {i}"
                );
            }
        }
    }
    for object in &case.scene.objects {
        let covered = (0..n - 1).any(|i| {
            let corners = [
                pair.left[i],
                pair.left[i + 1],
                pair.right[i + 1],
                pair.right[i],
            ]
            .map(Pose::position);
            (0..4).all(|k| {
                (corners[(k + 1) % 4] - corners[k]).cross(object.position - corners[k]) <= 1e-12
            })
        });
        assert!(covered, "{:?} is not swept", object.position);
    }
}

#[test]
fn steps_and_ends_are_those_of_the_scene() {
    let case = case();
    let pair = case.baseline(None).unwrap();
    let planner = &case.scene.planner;
    let (left, right) = pair.path_lengths();
    assert!(pair.len() >= (1.3 * left.max(right) / planner.max_step).ceil() as usize);
    for track in [&pair.left, &pair.right] {
        for w in track.windows(2) {
            assert!(w[0].position().distance(w[1].position()) <= planner.max_step);
            assert!(
                (w[1].heading - w[0].heading).abs() < 2.0 * planner.max_turn,
                "{w:?}"
            );
        }
    }
    let last = pair.len() - 1;
    for (pose, scene) in [
        (pair.left[0], case.scene.start.left),
        (pair.right[0], case.scene.start.right),
        (pair.left[last], case.scene.end.left),
        (pair.right[last], case.scene.end.right),
    ] {
        assert!(pose.position().distance(scene.position()) < 1e-12);
        assert!(wrap_angle(pose.heading - scene.heading).abs() < 1e-9);
    }
    assert_eq!(pair, case.baseline(None).unwrap());
}

#[test]
fn the_number_of_waypoints_can_be_given() {
    let mut case = case();
    assert_eq!(case.baseline(Some(123)).unwrap().len(), 123);
    assert_eq!(case.baseline(Some(2)).unwrap().len(), 2);
    assert_eq!(
        case.baseline(Some(1)).unwrap_err(),
        RouteError::TooFewWaypoints { waypoints: 1 }
    );
    case.scene.planner.waypoints = Some(321);
    assert_eq!(case.baseline(None).unwrap().len(), 321);
}

#[test]
fn centerlines_that_are_none_are_refused() {
    let mut case = case();
    case.line.truncate(1);
    assert_eq!(
        case.baseline(None).unwrap_err(),
        RouteError::BadCenterline { poses: 1 }
    );
    case.line = vec![
        Pose::new(1.0, 1.0, 0.0),
        Pose::new(f64::NAN, 0.0, 0.0),
        Pose::new(2.0, 1.0, 0.0),
    ];
    assert_eq!(
        case.baseline(None).unwrap_err(),
        RouteError::BadCenterline { poses: 2 }
    );
    case.line = vec![Pose::new(1.0, 1.0, 0.0); 2];
    assert!(case.baseline(None).is_ok());
}

#[test]
fn a_gap_too_narrow_for_two_abreast_is_passed_staggered() {
    let start = pair_pose(1.0, 3.0, 0.0);
    let scene = scene(9.0, 6.0, &[[7.0, 3.0]], start, pair_pose(8.3, 3.0, 0.0));
    let (low, high) = ([4.0, -1.0, 4.4, 2.56], [4.0, 3.44, 4.4, 7.0]);
    let obstacle = |p| box_distance(p, low).min(box_distance(p, high));
    let terrain = Terrain::sample(&scene, obstacle);
    let circles = vec![Circle {
        center: Point::new(7.0, 3.0),
        radius: 0.275,
        objects: vec![0],
    }];
    let itinerary = Itinerary::new(&circles, &scene, &[0]).unwrap();
    let line = hybrid_a_star::on_terrain(&terrain, &itinerary).unwrap();
    let pair = on_terrain(&terrain, &scene, &circles, &line, &[0], None).unwrap();
    for i in 1..pair.len() - 1 {
        let PairPose { left, right } = pair.pair(i);
        assert!(
            obstacle(left.position()).min(obstacle(right.position())) > 0.24,
            "waypoint {i}"
        );
        assert!(
            pair.pair(i).separation() > 0.475,
            "waypoint {i}: {}",
            pair.pair(i).separation()
        );
        let normal = pair.pair(i).normal_heading();
        let skew = wrap_angle(left.heading - normal)
            .abs()
            .max(wrap_angle(right.heading - normal).abs());
        assert!(skew < 1.1, "waypoint {i}: {skew}");
    }
}

#[test]
fn no_robot_is_led_between_objects_that_leave_it_no_room() {
    let mut random = crate::random::SplitMix::new(7);
    let mut close = 0;
    for _ in 0..4 {
        let mut objects: Vec<[f64; 2]> = Vec::new();
        while objects.len() < 45 {
            let at = |k: usize| 0.01 * k as f64;
            let object = [0.7 + at(random.below(860)), 0.7 + at(random.below(560))];
            let ends = [[1.2, 1.2], [8.8, 5.8]];
            let distance = |p: &[f64; 2]| Point::from(*p).distance(object.into());
            let is_free = |p: &[f64; 2]| distance(p) > 0.08;
            if objects.iter().all(is_free) && ends.iter().all(|end| distance(end) > 1.0) {
                objects.push(object);
            }
        }
        let start = pair_pose(1.2, 1.2, 0.0);
        let mut scene = scene(10.0, 7.0, &objects, start, pair_pose(8.8, 5.8, 0.0));
        scene.net.length = None;
        let world = World::new(&scene, None).unwrap();
        let order = crate::visiting_order(&world, &scene).unwrap();
        let line = hybrid_a_star::centerline(&world, &scene, &order).unwrap();
        let pair = baseline(&world, &scene, &line, &order, None).unwrap();
        let room = |i: usize, j: usize| {
            Point::from(objects[i]).distance(objects[j].into()) - 2.0 * (0.035 + 0.24)
        };
        for (i, j) in (0..45).flat_map(|i| (0..i).map(move |j| (i, j))) {
            if room(i, j) >= 0.0 {
                continue;
            }
            close += 1;
            let between = Segment::new(objects[i].into(), objects[j].into());
            for track in [&pair.left, &pair.right] {
                for step in track.windows(2) {
                    let step = Segment::new(step[0].position(), step[1].position());
                    assert!(!step.intersects(&between), "{between:?}");
                }
            }
        }
    }
    assert!(close > 20, "only {close} pairs of objects are close");
}
