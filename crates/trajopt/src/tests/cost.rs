//! J of trajectories against sums written by hand.

use super::between;
use crate::evaluate;
use pairtrawl_generate::{Kind, generate};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Obstacle, PairTrajectory, Scene};
use std::f64::consts::PI;

/// A generated scene with everything taken out of it.
fn empty_scene() -> Scene {
    let mut scene = generate(Kind::Witness, 1, 1, 60).expect("a scene").scene;
    scene.obstacles.clear();
    scene.objects.truncate(1);
    scene.objects[0].position = Point::new(100.0, 100.0);
    scene
}

fn trajectory(left: &[(f64, f64, f64)], right: &[(f64, f64, f64)]) -> PairTrajectory {
    let poses =
        |list: &[(f64, f64, f64)]| list.iter().map(|&(x, y, h)| Pose::new(x, y, h)).collect();
    PairTrajectory {
        left: poses(left),
        right: poses(right),
        step_time: 0.2,
    }
}

/// Both robots at rest at this separation, for a single waypoint.
fn still(separation: f64) -> PairTrajectory {
    trajectory(&[(0.0, separation, 0.0)], &[(0.0, 0.0, 0.0)])
}

fn assert_close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9 * (1.0 + b.abs()), "{a} for {b}");
}

#[test]
fn three_waypoints_by_hand() {
    // Left: 0.03 straight on, then 0.04 to the side. Right: 0.05, then stands. d_max 2: rest at 1.2732, d_min 0.2.
    let pair = trajectory(
        &[(0.0, 1.0, 0.0), (0.03, 1.0, 0.02), (0.03, 1.04, -0.03)],
        &[(0.0, 0.0, 0.0), (0.05, 0.0, 0.0), (0.05, 0.0, 0.1)],
    );
    let cost = evaluate(&empty_scene(), &pair, 2.0);
    // 300 (0.03 + 0.04 + 0.05) + 10 (0.02 + 0.05 + 0.1)
    assert_close(cost.distance, 36.0 + 1.7);
    // left: x 0.0009, y 0.0016, heading (-0.07)^2; right: x 0.0025, heading 0.01
    assert_close(
        cost.smoothness,
        110.0 * (0.0009 + 0.0016 + 0.0025) + 0.0049 + 0.01,
    );
    assert_eq!(cost.obstacle, 0.0);
    let inner = |d: f64| 20.0 * (PI / 2.0 / (4.0 / PI - 0.2) * (d - 4.0 / PI)).tan().powi(2);
    let by_hand = inner(1.0) + inner(1.0004_f64.sqrt()) + inner((1.04_f64.powi(2) + 0.0004).sqrt());
    assert_close(cost.expansion, by_hand);
    // The number itself, so that the formula here cannot drift with the other.
    assert!(
        (cost.expansion - 9.660_874_66).abs() < 1e-7,
        "{}",
        cost.expansion
    );
    assert_close(
        cost.total(),
        cost.distance + cost.smoothness + cost.expansion,
    );
}

#[test]
fn weights_scale_their_own_terms() {
    let mut scene = empty_scene();
    let pair = trajectory(
        &[(0.0, 1.0, 0.0), (0.03, 1.0, 0.02), (0.03, 1.04, -0.03)],
        &[(0.0, 0.0, 0.0), (0.05, 0.0, 0.0), (0.05, 0.0, 0.1)],
    );
    let before = evaluate(&scene, &pair, 2.0);
    let p = &mut scene.planner;
    (p.a1, p.a2, p.a4) = (2.0, 3.0, 5.0);
    let after = evaluate(&scene, &pair, 2.0);
    assert_close(after.smoothness, 2.0 * before.smoothness);
    assert_close(after.distance, 3.0 * before.distance);
    assert_close(after.expansion, 5.0 * before.expansion);
}

#[test]
fn expansion_cases() {
    let scene = empty_scene();
    let at = |d: f64| evaluate(&scene, &still(d), 1.0).expansion;
    // K3 outside [d_min, d_max] = [0.1, 1].
    assert_eq!((at(0.0999), at(1.0001)), (1e7, 1e7));
    assert_eq!(at(2.0 / PI), 0.0);
    // Half way between d_min and rest the tangent's argument is -pi/4.
    assert_close(at(0.5 * (0.1 + 2.0 / PI)), 20.0);
    // Outer branch at d = 0.9: 15 x^2 + x^2 / 0.01 with x = 0.9 - 2/pi = 0.26338.
    assert_close(at(0.9), 115.0 * (0.9 - 2.0 / PI) * (0.9 - 2.0 / PI));
    assert!((at(0.9) - 7.977_5).abs() < 1e-3, "{}", at(0.9));
    // A barrier at both ends.
    assert!(at(0.1001) > 1e6 && at(0.9999) > 1e6);
}

#[test]
fn the_printed_sign_of_the_outer_branch_rewards_overstretching() {
    let scene = empty_scene();
    let rest = 2.0 / PI;
    // As printed: kd2 (d - d_rest)^2 - (d - d_rest)^2 / (d - d_max)^2.
    let printed = |d: f64| 15.0 * (d - rest).powi(2) - (d - rest).powi(2) / (d - 1.0).powi(2);
    let mut last = 0.0;
    for k in 1..8 {
        let d = 1.0 - 10.0_f64.powi(-k);
        assert!(printed(d) < last, "falls all the way");
        last = printed(d);
        let ours = evaluate(&scene, &still(d), 1.0).expansion;
        assert!(ours > 0.0 && ours > -0.99 * printed(d), "ours rises");
    }
    assert!(last < -1e12, "without a bound: {last}");
}

#[test]
fn obstacle_cases() {
    let mut scene = empty_scene();
    scene.obstacles = vec![
        Obstacle::Box {
            min: Point::new(-0.1, -0.1),
            max: Point::new(0.1, 0.1),
        },
        Obstacle::Circle {
            center: Point::new(0.0, 3.0),
            radius: 0.2,
        },
        Obstacle::Polygon(vec![
            Point::new(5.0, 0.0),
            Point::new(6.0, 0.0),
            Point::new(5.5, 1.0),
        ]),
    ];
    let at = |scene: &Scene, x: f64, y: f64| {
        let pair = trajectory(&[(x, y, 0.0)], &[(50.0, 50.0, 0.0)]);
        evaluate(scene, &pair, 1.0).obstacle
    };
    for (x, y, inside) in [
        (0.0, 0.05, true),
        (0.0, 0.11, false),
        (0.0, 3.19, true),
        (0.0, 3.21, false),
        (5.5, 0.5, true),
        (5.05, 0.5, false),
    ] {
        assert_eq!(
            at(&scene, x, y),
            if inside { 1e7 } else { 0.0 },
            "({x}, {y})"
        );
    }
    // The potential of an object's circle: K2/2 (1/D - 1/R)^2, R the footprint's radius and the robot's, whatever margin the
    // circles of order, centerline and baseline have.
    scene.obstacles.clear();
    scene.objects[0].position = Point::new(0.0, 0.0);
    scene.planner.circle_margin = Some(0.4);
    assert_eq!(at(&scene, 0.3, 0.0), 0.0);
    let radius = scene.objects[0].footprint_radius() + scene.robot.radius;
    assert_close(at(&scene, 0.2, 0.0), 0.5e7 * (5.0 - 1.0 / radius).powi(2));
    scene.planner.a3 = 0.5;
    assert_close(at(&scene, 0.2, 0.0), 0.25e7 * (5.0 - 1.0 / radius).powi(2));
}

#[test]
fn a_witness_by_hand() {
    let made = generate(Kind::Witness, 4, 3, 120).expect("a scene");
    let (pair, length) = (&made.witness, made.net_length);
    let mut random = fastrand::Rng::with_seed(20);
    let mut shaken = pair.clone();
    for pose in shaken.left.iter_mut().chain(&mut shaken.right) {
        pose.x += between(&mut random, -0.002, 0.002);
        pose.heading += between(&mut random, -0.02, 0.02);
    }
    for pair in [pair, &shaken] {
        let cost = evaluate(&made.scene, pair, length);
        let (mut distance, mut smoothness, mut expansion) = (0.0, 0.0, 0.0);
        for p in [&pair.left, &pair.right] {
            for i in 1..p.len() {
                let (dx, dy) = (p[i].x - p[i - 1].x, p[i].y - p[i - 1].y);
                distance += 300.0 * (dx * dx + dy * dy).sqrt();
                distance += 10.0 * (p[i].heading - p[i - 1].heading).abs();
            }
            for i in 1..p.len() - 1 {
                smoothness += 110.0 * (p[i - 1].x - 2.0 * p[i].x + p[i + 1].x).powi(2);
                smoothness += 110.0 * (p[i - 1].y - 2.0 * p[i].y + p[i + 1].y).powi(2);
                let turn = p[i - 1].heading - 2.0 * p[i].heading + p[i + 1].heading;
                smoothness += turn * turn;
            }
        }
        let (rest, least) = (2.0 / PI * length, 0.1 * length);
        for (l, r) in pair.left.iter().zip(&pair.right) {
            let d = ((l.x - r.x).powi(2) + (l.y - r.y).powi(2)).sqrt();
            expansion += if d < rest {
                20.0 * (0.5 * PI * (d - rest) / (rest - least)).tan().powi(2)
            } else {
                15.0 * (d - rest).powi(2) + (d - rest).powi(2) / (d - length).powi(2)
            };
        }
        assert_close(cost.distance, distance);
        assert_close(cost.smoothness, smoothness);
        assert_close(cost.expansion, expansion);
    }
}
