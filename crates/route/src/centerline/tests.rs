use super::itinerary::{Itinerary, check_order};
use super::*;
use crate::error::RouteError;
use crate::terrain::Terrain;
use crate::terrain::tests::{box_distance, pair_pose, scene};
use pairtrawl_geometry::{Point, Pose, wrap_angle};
use pairtrawl_model::Circle;

fn circles(centers: &[[f64; 2]]) -> Vec<Circle> {
    let circle = |(i, &c): (usize, &[f64; 2])| Circle {
        center: c.into(),
        radius: 0.275,
        objects: vec![i],
    };
    centers.iter().enumerate().map(circle).collect()
}

/// Curvature by the circle through every third pose.
fn tightest_curvature(poses: &[Pose]) -> f64 {
    let of = |w: &[Pose]| {
        let (a, b) = (
            w[3].position() - w[0].position(),
            w[6].position() - w[3].position(),
        );
        2.0 * a.cross(b).abs() / (a.norm() * b.norm() * (a + b).norm())
    };
    poses.windows(7).map(of).fold(0.0, f64::max)
}

fn check_line(line: &[Pose], itinerary: &Itinerary, reach: f64) {
    assert!(line[0].position().distance(itinerary.start.position()) < 1e-9);
    assert!(
        line[line.len() - 1]
            .position()
            .distance(itinerary.end.position())
            < 1e-9
    );
    assert!(wrap_angle(line[0].heading - itinerary.start.heading).abs() < 1e-9);
    assert!(wrap_angle(line[line.len() - 1].heading - itinerary.end.heading).abs() < 1e-9);
    for w in line.windows(2) {
        let step = w[0].position().distance(w[1].position());
        assert!(step > 0.02 && step < 0.06, "{step}");
        assert!((w[1].heading - w[0].heading).abs() < 0.35, "{w:?}");
    }
    // Every circle in order: the nearest pose behind the last circle's.
    let mut from = 0;
    for goal in &itinerary.goals {
        let distance = |i: usize| line[i].position().distance(*goal);
        let first = (from..line.len()).find(|&i| distance(i) < reach);
        from = first.unwrap_or_else(|| panic!("{goal:?} is not reached in order"));
    }
}

#[test]
fn the_line_keeps_curvature_and_clearance_and_takes_every_circle_in_order() {
    let centers = [[2.0, 4.5], [5.0, 5.2], [7.5, 3.0], [5.0, 1.0]];
    let s = scene(
        10.0,
        7.0,
        &centers,
        pair_pose(1.0, 1.5, 1.5),
        pair_pose(2.6, 1.0, -2.8),
    );
    let boxes = [[3.0, 1.8, 6.0, 4.0], [8.6, 4.5, 9.5, 6.0]];
    let obstacle = |p| {
        boxes
            .iter()
            .map(|&b| box_distance(p, b))
            .fold(f64::INFINITY, f64::min)
    };
    let terrain = Terrain::sample(&s, obstacle);
    let itinerary = Itinerary::new(&circles(&centers), &s, &[0, 1, 2, 3]).unwrap();
    let line = hybrid_a_star::on_terrain(&terrain, &itinerary).unwrap();
    check_line(&line, &itinerary, 0.15);
    assert!(
        tightest_curvature(&line) < 1.0 / 0.45,
        "{}",
        tightest_curvature(&line)
    );
    for pose in &line {
        for side in [0.3, -0.3] {
            let robot = pose.position() + pose.forward().perp() * side;
            assert!(obstacle(robot) > 0.24, "a robot beside {pose:?} touches");
        }
    }
    // What a person would draw: not much longer than the string of straight lines.
    let length: f64 = line
        .windows(2)
        .map(|w| w[0].position().distance(w[1].position()))
        .sum();
    let stops: Vec<Point> = [[1.0, 1.5]]
        .iter()
        .chain(&centers)
        .chain(&[[2.6, 1.0]])
        .map(|&p| p.into())
        .collect();
    let string: f64 = stops.windows(2).map(|w| w[0].distance(w[1])).sum();
    assert!(length < 1.12 * string, "{length} {string}");
    assert_eq!(
        line,
        hybrid_a_star::on_terrain(&terrain, &itinerary).unwrap()
    );
}

#[test]
fn a_reversal_is_one_loop_of_a_pair_that_can_drive_it() {
    let centers = [[6.0, 3.0]];
    let s = scene(
        9.0,
        6.0,
        &centers,
        pair_pose(1.0, 3.0, 0.0),
        pair_pose(1.0, 3.8, std::f64::consts::PI),
    );
    let terrain = Terrain::sample(&s, |_| 50.0);
    let itinerary = Itinerary::new(&circles(&centers), &s, &[0]).unwrap();
    let line = hybrid_a_star::on_terrain(&terrain, &itinerary).unwrap();
    check_line(&line, &itinerary, 0.3);
    let turned: f64 = line
        .windows(2)
        .map(|w| (w[1].heading - w[0].heading).abs())
        .sum();
    assert!(turned < 4.6, "needless turns: {turned} rad");
    assert!(
        tightest_curvature(&line) < 1.0 / 0.25,
        "{}",
        tightest_curvature(&line)
    );
}

#[test]
fn a_gap_just_wide_enough_for_the_pair_is_found_and_a_closed_one_is_an_error() {
    let centers = [[7.0, 3.0]];
    let s = scene(
        9.0,
        6.0,
        &centers,
        pair_pose(1.5, 1.5, 0.0),
        pair_pose(8.0, 3.0, 0.0),
    );
    let itinerary = Itinerary::new(&circles(&centers), &s, &[0]).unwrap();
    let wall = |gap: f64| {
        let (low, high) = (
            [4.0, -1.0, 4.3, 3.0 - 0.5 * gap],
            [4.0, 3.0 + 0.5 * gap, 4.3, 7.0],
        );
        Terrain::sample(&s, move |p| box_distance(p, low).min(box_distance(p, high)))
    };
    let line = hybrid_a_star::on_terrain(&wall(1.1), &itinerary).unwrap();
    check_line(&line, &itinerary, 0.15);
    let through = line.iter().filter(|p| p.x > 4.0 && p.x < 4.3);
    assert!(through.clone().count() > 3);
    for pose in through {
        assert!(
            (pose.y - 3.0).abs() < 0.05 && pose.heading.abs() < 0.2,
            "{pose:?}"
        );
    }
    let error = hybrid_a_star::on_terrain(&wall(0.2), &itinerary).unwrap_err();
    assert_eq!(
        error,
        RouteError::NoPath {
            from: Point::new(1.5, 1.5),
            to: Point::new(7.0, 3.0)
        }
    );
}

#[test]
fn a_search_that_is_given_up_does_not_say_that_the_way_is_closed() {
    let centers = [[7.0, 3.0]];
    let s = scene(
        9.0,
        6.0,
        &centers,
        pair_pose(1.5, 1.5, 0.0),
        pair_pose(8.0, 3.0, 0.0),
    );
    let itinerary = Itinerary::new(&circles(&centers), &s, &[0]).unwrap();
    // The way leads around the upper end of a wall: no straight edge goes there.
    let terrain = Terrain::sample(&s, |p| box_distance(p, [4.0, -1.0, 4.3, 3.5]));
    assert!(hybrid_a_star::on_terrain(&terrain, &itinerary).is_ok());
    let error = rrt_star::on_terrain(&terrain, &itinerary, 1, 1).unwrap_err();
    let (from, to) = (Point::new(1.5, 1.5), Point::new(7.0, 3.0));
    let states = 1;
    assert_eq!(error, RouteError::SearchLimit { from, to, states });
    let words = error.to_string();
    assert!(
        words.contains("within 1 states") && words.contains("there may be one"),
        "{words}"
    );
    // What is said in meters keeps its places and the count.
    let (from, to) = (from * 2.0, to * 2.0);
    let meters = error.in_meters(2.0);
    assert_eq!(meters, RouteError::SearchLimit { from, to, states });
}

#[test]
fn objects_on_the_way_are_well_inside_or_outside_of_the_band() {
    // The last object lies where the left robot would drive on the straight line.
    let centers = [[2.5, 2.0], [8.0, 2.0], [5.0, 2.3]];
    let s = scene(
        10.0,
        5.0,
        &centers,
        pair_pose(1.0, 2.0, 0.0),
        pair_pose(9.0, 2.0, 0.0),
    );
    let terrain = Terrain::sample(&s, |_| 50.0);
    let goals = circles(&centers[..2]);
    let line =
        hybrid_a_star::on_terrain(&terrain, &Itinerary::new(&goals, &s, &[0, 1]).unwrap()).unwrap();
    let object: Point = centers[2].into();
    let nearest = line
        .iter()
        .map(|p| p.position().distance(object))
        .fold(f64::INFINITY, f64::min);
    assert!(!(0.2..0.45).contains(&nearest), "{nearest}");
}

#[test]
fn orders_that_are_no_permutation_are_refused() {
    assert_eq!(check_order(&[1, 0, 2], 3), Ok(()));
    assert_eq!(
        check_order(&[0, 0, 2], 3),
        Err(RouteError::BadOrder {
            index: 0,
            times: 2,
            circles: 3
        })
    );
    assert_eq!(
        check_order(&[0, 2], 3),
        Err(RouteError::BadOrder {
            index: 1,
            times: 0,
            circles: 3
        })
    );
    assert_eq!(
        check_order(&[0, 3, 1], 3),
        Err(RouteError::BadOrder {
            index: 3,
            times: 1,
            circles: 3
        })
    );
}

#[test]
fn rrt_star_takes_every_circle_too_and_gets_cheaper_with_more_samples() {
    let centers = [[2.0, 4.5], [7.5, 4.8], [7.5, 1.5]];
    let s = scene(
        10.0,
        7.0,
        &centers,
        pair_pose(1.0, 1.5, 1.5),
        pair_pose(2.0, 0.9, -3.1),
    );
    let obstacle = |p| box_distance(p, [3.0, 1.9, 6.0, 5.0]);
    let terrain = Terrain::sample(&s, obstacle);
    let itinerary = Itinerary::new(&circles(&centers), &s, &[0, 1, 2]).unwrap();
    let plan =
        |seed, iterations| rrt_star::on_terrain(&terrain, &itinerary, seed, iterations).unwrap();
    let line = plan(1, 600);
    check_line(&line, &itinerary, 0.3);
    assert!(
        tightest_curvature(&line) < 1.0 / 0.35,
        "{}",
        tightest_curvature(&line)
    );
    assert!(line.iter().all(|p| obstacle(p.position()) > 0.4));
    assert_eq!(line, plan(1, 600));
    assert_ne!(line, plan(2, 600));
    let way = |n| rrt_star::leg_cost(&terrain, Point::new(2.0, 4.5), Point::new(7.5, 1.5), n);
    let (few, many) = (way(150).unwrap(), way(2500).unwrap());
    assert!(many < few, "{many} {few}");
    // The best way rounds the box's upper right corner, or its lower left one, at the distance that costs nothing.
    let string = [[2.0, 4.5], [2.41, 1.31], [7.5, 1.5]].map(Point::from);
    let shortest = string[0].distance(string[1]) + string[1].distance(string[2]);
    assert!(many < 1.12 * shortest, "{many} {shortest}");
}
