//! Scenes that cannot be done are proven so; scenes that can be done never are.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

mod support;

use pairtrawl_certificate::infeasibility::{self, Proof, ProofKind};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Obstacle, OccupancyMap, Scene, Units};
use support::build::{cube, hall, wall};

/// The first proof.
fn prove(scene: &Scene, net_length: Option<f64>) -> Option<Proof> {
    infeasibility::prove(scene, net_length).into_iter().next()
}

fn proven(scene: &Scene, net_length: Option<f64>) -> Proof {
    let proof = prove(scene, net_length).expect("a proof");
    println!("{}", proof.message);
    proof
}

#[test]
fn known_solutions_are_never_proven_infeasible() {
    for n in 1..=9 {
        let case = support::witness(n);
        assert_eq!(
            prove(&case.scene, Some(case.net_length)),
            None,
            "witness {n}"
        );
        assert_eq!(prove(&case.scene, None), None, "witness {n}, any net");
    }
}

#[test]
fn a_net_shorter_than_the_start_is_named_with_the_length_that_would_do() {
    let mut scene = hall(6.0, 4.0, 2.0, 5.0);
    // Splayed headings put the hitches farther apart than the axles.
    scene.start.left.heading = -0.3;
    scene.start.right.heading = 0.3;
    let needed = 0.8 + 2.0 * 0.207 * 0.3_f64.sin();
    let ProofKind::NetTooShort { needed: found, .. } = proven(&scene, Some(0.9)).kind else {
        panic!("wrong kind")
    };
    assert!((found - needed).abs() < 1e-12);
    assert_eq!(prove(&scene, Some(needed + 1e-9)), None);
    assert_eq!(prove(&scene, None), None);
}

#[test]
fn a_net_too_short_to_pass_over_an_object_is_named() {
    let mut scene = hall(6.0, 4.0, 2.0, 5.0);
    scene.start.left.y = 2.1;
    scene.start.right.y = 1.6;
    scene.end.left.y = 2.1;
    scene.end.right.y = 1.6;
    scene.objects.push(cube(3.0, 2.0));
    let needed = 2.0 * 0.24 + 0.05_f64.hypot(0.05);
    assert!(matches!(
        proven(&scene, Some(needed - 0.001)).kind,
        ProofKind::ObjectTooWide { object: 0, needed: found, .. } if (found - needed).abs() < 1e-12
    ));
    assert_eq!(prove(&scene, Some(needed + 0.001)), None);
}

/// A wall across the hall at x = 3 with a gap of `gap` around y = 2.
fn gapped(gap: f64) -> Scene {
    let mut scene = hall(6.0, 4.0, 2.0, 5.0);
    scene.obstacles.push(wall(2.9, -1.0, 3.1, 2.0 - 0.5 * gap));
    scene.obstacles.push(wall(2.9, 2.0 + 0.5 * gap, 3.1, 5.0));
    scene
}

#[test]
fn a_gap_below_two_radii_cuts_the_way_and_a_wider_one_does_not() {
    for gap in [0.0, 0.1, 0.3, 0.44, 0.46] {
        let proof = proven(&gapped(gap), None);
        let ProofKind::WayCut { place, width, .. } = proof.kind else {
            panic!("wrong kind: {proof:?}")
        };
        assert!((width - gap).abs() < 0.01, "gap {gap}: {width}");
        assert!(
            gap == 0.0 || place.distance(Point::new(3.0, 2.0)) < 0.4,
            "gap {gap}: {place:?}"
        );
        assert!(
            proof.message.contains("obstacle 0") || proof.message.contains("obstacle 1"),
            "{}",
            proof.message
        );
    }
    for gap in [0.4799999, 0.48, 0.5, 0.8, 2.0] {
        assert_eq!(prove(&gapped(gap), None), None, "gap {gap}");
    }
}

#[test]
fn an_object_in_a_gap_narrows_it() {
    let mut scene = gapped(0.9);
    assert_eq!(prove(&scene, None), None);
    scene.objects.push(cube(3.0, 2.0));
    // Pinned and cut at once; either proof is right.
    let proof = proven(&scene, None);
    assert!(matches!(
        proof.kind,
        ProofKind::WayCut { .. } | ProofKind::ObjectPinned { .. }
    ));
}

#[test]
fn the_area_bounds_the_way_beside_an_obstacle() {
    let mut scene = hall(6.0, 4.0, 2.0, 5.0);
    scene.obstacles.push(wall(2.9, 0.2, 3.1, 3.8));
    let proof = proven(&scene, None);
    assert!(matches!(proof.kind, ProofKind::WayCut { .. }));
    assert!(
        proof.message.contains("edge of the area"),
        "{}",
        proof.message
    );
    scene.obstacles[0] = wall(2.9, 0.2, 3.1, 3.7);
    assert_eq!(prove(&scene, None), None);
}

#[test]
fn walls_of_a_map_cut_the_way() {
    for (yaw, gap, cut) in [
        (0.0, 8, true),
        (0.0, 10, false),
        (0.7, 8, true),
        (0.7, 10, false),
    ] {
        let scene = mapped(yaw, gap);
        let proof = prove(&scene, None);
        assert_eq!(proof.is_some(), cut, "yaw {yaw}, {gap} cells: {proof:?}");
        if let Some(proof) = proof {
            println!("{}", proof.message);
            assert!(
                matches!(proof.kind, ProofKind::WayCut { width, .. } if (width - 0.05 * gap as f64).abs() < 0.01)
            );
        }
    }
}

/// A hall of 6 m x 4 m as a turned map of 5 cm cells, with a wall one cell thick and a gap of `gap` cells in it.
fn mapped(yaw: f64, gap: usize) -> Scene {
    let (columns, rows) = (120, 80);
    let mut map = OccupancyMap {
        origin: Pose::new(3.0, -2.0, yaw),
        resolution: 0.05,
        columns,
        rows,
        blocked: vec![false; columns * rows],
    };
    for row in (0..rows).filter(|r| !(36..36 + gap).contains(r)) {
        map.blocked[row * columns + 60] = true;
    }
    let mut scene = hall(6.0, 4.0, 2.0, 5.0);
    let turned = |p: Pose| Pose::at(map.from_cells(p.position() * 20.0), p.heading + yaw);
    for pair in [&mut scene.start, &mut scene.end] {
        pair.left = turned(pair.left);
        pair.right = turned(pair.right);
    }
    scene.area.min = Point::new(-3.0, -3.0);
    scene.area.max = Point::new(10.0, 8.0);
    scene.map = Some(map);
    scene
}

/// Four walls around (3, 2), `inner` from it, the right one with a gap.
fn boxed(inner: f64, gap: f64) -> Scene {
    let mut scene = hall(10.0, 6.0, 1.0, 9.0);
    let (x, y, t) = (5.0, 3.8, 0.1);
    scene.obstacles = vec![
        wall(x - inner - t, y - inner - t, x - inner, y + inner + t),
        wall(x - inner - t, y - inner - t, x + inner + t, y - inner),
        wall(x - inner - t, y + inner, x + inner + t, y + inner + t),
        wall(x + inner, y - inner - t, x + inner + t, y - 0.5 * gap),
        wall(x + inner, y + 0.5 * gap, x + inner + t, y + inner + t),
    ];
    scene.objects.push(cube(x, y));
    scene
}

#[test]
fn an_object_behind_walls_is_enclosed() {
    // Closed; a gap that no robot passes, the object out of reach from outside.
    for (inner, gap, net) in [
        (1.0, -0.1, None),
        (1.0, -0.1, Some(3.0)),
        (1.2, 0.3, Some(1.7)),
    ] {
        let proof = proven(&boxed(inner, gap), net);
        assert!(matches!(
            proof.kind,
            ProofKind::ObjectEnclosed { object: 0, .. }
        ));
    }
    // Open enough for robots, on both sides of the object.
    assert_eq!(prove(&boxed(1.2, 1.0), Some(2.0)), None);
}

#[test]
fn a_window_with_a_line_of_sight_is_no_enclosure() {
    // Each robot on its own can stand outside with a free line through the window: the argument has nothing to say, on
    // no grid, however coarse against the window.
    for window in [0.3, 0.06] {
        assert_eq!(
            prove(&boxed(1.2, window), Some(2.0)),
            None,
            "window {window}"
        );
    }
}

#[test]
fn an_object_behind_a_nonconvex_obstacle_is_enclosed() {
    let mut scene = hall(10.0, 6.0, 1.0, 9.0);
    // A clasp, open to the left, and a box that shuts it.
    let ring = [
        (4.0, 3.0),
        (6.0, 3.0),
        (6.0, 5.0),
        (4.0, 5.0),
        (4.0, 4.8),
        (5.8, 4.8),
        (5.8, 3.2),
        (4.0, 3.2),
    ];
    scene.obstacles.push(wall(3.9, 3.1, 4.1, 4.9));
    scene.obstacles.push(Obstacle::Polygon(
        ring.map(|(x, y)| Point::new(x, y)).to_vec(),
    ));
    scene.objects.push(cube(5.0, 4.0));
    assert!(matches!(
        proven(&scene, None).kind,
        ProofKind::ObjectEnclosed { object: 0, .. }
    ));
}

#[test]
fn an_object_close_to_an_obstacle_is_pinned_unless_the_start_or_end_line_passes_between() {
    let half_diagonal = 0.5 * 0.05_f64.hypot(0.05);
    let at_gap = |gap: f64| {
        let mut scene = hall(10.0, 6.0, 2.0, 9.0);
        scene.obstacles.push(wall(4.0, 4.0, 6.0, 5.0));
        scene.objects.push(cube(5.0, 4.0 - gap - half_diagonal));
        scene
    };
    for gap in [0.01, 0.2, 0.47] {
        let proof = proven(&at_gap(gap), Some(1.5));
        let ProofKind::ObjectPinned {
            object: 0,
            gap: found,
            ..
        } = proof.kind
        else {
            panic!("wrong kind: {proof:?}")
        };
        assert!((found - gap).abs() < 1e-9);
    }
    assert_eq!(prove(&at_gap(0.481), Some(1.5)), None);

    // The end line stands between: the object is taken at the end, coming from below.
    let mut scene = at_gap(0.3);
    scene.end.left = Pose::new(4.5, 3.72, std::f64::consts::FRAC_PI_2);
    scene.end.right = Pose::new(5.5, 3.72, std::f64::consts::FRAC_PI_2);
    assert_eq!(prove(&scene, Some(1.5)), None);

    // Headings that may leave the line's normal by a right angle could sweep back and forth.
    let mut scene = at_gap(0.3);
    scene.planner.max_skew = 1.5;
    assert_eq!(prove(&scene, Some(1.5)), None);
}

#[test]
fn a_net_too_long_for_the_ends_is_named_with_the_length_that_would_do() {
    let mut scene = hall(6.0, 4.0, 2.0, 5.0);
    scene.end.right.y += 0.1;
    let proof = proven(&scene, Some(8.0));
    let ProofKind::NetTooLong { most, .. } = proof.kind else {
        panic!("wrong kind: {proof:?}")
    };
    assert!((most - 7.0).abs() < 1e-9);
    let says = [
        "too long",
        "8.000 m",
        "at the end",
        "0.700 m",
        "at most 7.000 m",
    ];
    assert!(
        says.iter().all(|s| proof.message.contains(s)),
        "{}",
        proof.message
    );
    assert_eq!(prove(&scene, Some(7.0)), None);
    assert_eq!(prove(&scene, None), None);
}

#[test]
fn an_object_close_to_the_edge_of_the_area_is_pinned_there() {
    let half_diagonal = 0.5 * 0.05_f64.hypot(0.05);
    let at_gap = |gap: f64| {
        let mut scene = hall(10.0, 6.0, 2.0, 9.0);
        scene.objects.push(cube(5.0, 6.0 - gap - half_diagonal));
        scene
    };
    for gap in [0.01, 0.2, 0.239] {
        let proof = proven(&at_gap(gap), Some(1.5));
        let ProofKind::ObjectAtEdge {
            object: 0,
            gap: found,
            ..
        } = proof.kind
        else {
            panic!("wrong kind: {proof:?}")
        };
        assert!((found - gap).abs() < 1e-9);
        assert!(proof.message.contains("the edge of the area"));
    }
    assert_eq!(prove(&at_gap(0.241), Some(1.5)), None);
    // The end line stands between.
    let mut scene = at_gap(0.2);
    let forward = std::f64::consts::FRAC_PI_2;
    scene.end.left = Pose::new(4.5, 5.9, forward);
    scene.end.right = Pose::new(5.5, 5.9, forward);
    assert_eq!(prove(&scene, Some(1.5)), None);
}

#[test]
fn proofs_hold_at_every_scale() {
    let mut scene = hall(10.0, 6.0, 2.0, 9.0);
    scene.obstacles.push(wall(4.0, -1.0, 4.2, 2.0));
    scene.obstacles.push(wall(4.0, 2.3, 4.2, 7.0));
    scene.objects.push(cube(8.0, 3.0));
    let ProofKind::WayCut { place, .. } = proven(&scene, None).kind else {
        panic!("wrong kind")
    };
    for factor in [0.02, 0.1, 10.0, 1000.0] {
        let units = Units {
            length: 1.0 / factor,
            ..Units::SI
        };
        let ProofKind::WayCut { place: scaled, .. } = proven(&units.scene(&scene), None).kind
        else {
            panic!("factor {factor}")
        };
        assert!(
            (scaled / factor).distance(place) < 0.1,
            "{factor}: {scaled:?}"
        );
    }
}

#[test]
fn malformed_scenes_have_no_proof_and_do_not_panic() {
    let mut scene = hall(6.0, 4.0, 2.0, 5.0);
    scene.area.max.x = f64::NAN;
    assert_eq!(prove(&scene, Some(0.1)), None);
    let mut scene = hall(6.0, 4.0, 2.0, 5.0);
    scene.area.max.x = 1e308;
    assert_eq!(prove(&scene, None), None);
    let mut scene = hall(6.0, 4.0, 2.0, 5.0);
    scene
        .obstacles
        .push(Obstacle::Polygon(vec![Point::ZERO, Point::new(1.0, 1.0)]));
    assert_eq!(prove(&scene, None), None);
    let mut scene = hall(6.0, 4.0, 2.0, 5.0);
    scene.obstacles.push(wall(0.5, 1.0, 1.5, 3.0)); // Start in collision.
    assert_eq!(prove(&scene, None), None);
    assert_eq!(prove(&hall(6.0, 4.0, 2.0, 5.0), Some(f64::NAN)), None);
    let mut scene = hall(6.0, 4.0, 2.0, 5.0);
    scene.area.max = Point::new(1e6, 1e6);
    assert_eq!(prove(&scene, None), None);
}
