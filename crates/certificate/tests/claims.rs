//! Each claim at its bound: what happens between waypoints and at a touch.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

mod support;

use pairtrawl_certificate::certify;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Footprint, Object, Obstacle, OccupancyMap, PairTrajectory};
use support::Case;
use support::build::{cube, hall, straight, wall};
use support::claim;

#[test]
fn exact_drives_hold_with_the_margins_that_one_computes_by_hand() {
    let mut case = straight();
    case.scene.objects.push(cube(1.2, 2.1));
    case.scene.obstacles.push(wall(1.0, 2.7, 2.0, 3.0));
    let margin = |name| claim(&case, name).margin;
    let expected = [
        ("endpoints", 1e-6),
        ("step", 0.01),
        ("turn", 0.1),
        ("forward", 0.040001),
        ("no_sideways_slip", 1e-4),
        ("speed", 0.26 - 0.04 / 0.3),
        ("abreast", 1.0),
        ("robot_clearance", 0.3 - 0.24),
        (
            "robots_miss_objects",
            0.3 - 0.24 - 0.5 * 0.05_f64.hypot(0.05),
        ),
        ("net_encloses_no_obstacle", 0.3),
        ("every_object_covered", 0.3),
        ("separation", 0.8 - 0.48),
        ("net_reach", 1.5 - 0.8),
        ("inside_area", 1.0),
    ];
    for (name, value) in expected {
        assert!(
            (margin(name) - value).abs() < 1e-10,
            "{name}: {} instead of {value}",
            margin(name)
        );
    }
    assert!(certify(&case.scene, 1.5, &case.trajectory, None).is_valid());
}

#[test]
fn claims_name_the_robot_the_obstacle_and_the_object() {
    let mut case = straight();
    case.scene.obstacles.push(wall(5.0, 0.0, 6.0, 1.0));
    case.scene.obstacles.push(wall(1.2, 2.5, 1.3, 3.0));
    case.scene.objects.push(cube(1.2, 2.0));
    case.scene.objects.push(cube(1.3, 3.5));
    let clearance = claim(&case, "robot_clearance");
    assert!(
        !clearance.holds
            && clearance.detail.contains("left robot")
            && clearance.detail.contains("obstacle 1 (box)")
    );
    assert_eq!(clearance.step, Some(4));
    let covered = claim(&case, "every_object_covered");
    assert!(
        !covered.holds && covered.detail.contains("object 1"),
        "{covered:?}"
    );
    assert!((covered.margin + 1.1).abs() < 1e-9);
    assert_eq!(covered.place, Some(Point::new(1.3, 3.5)));
}

#[test]
fn nothing_to_hold_against_is_an_infinite_margin() {
    let case = straight();
    for name in [
        "robot_clearance",
        "robots_miss_objects",
        "net_encloses_no_obstacle",
        "every_object_covered",
    ] {
        let claim = claim(&case, name);
        assert!(
            claim.holds && claim.margin == f64::INFINITY && claim.step.is_none(),
            "{claim:?}"
        );
    }
}

#[test]
fn bounds_hold_to_a_nanometer() {
    let mut case = straight();
    for (excess, holds) in [(0.0, true), (9e-10, true), (1.2e-9, false)] {
        case.scene.obstacles = vec![wall(1.0, 2.4 + 0.24 - excess, 2.0, 3.0)];
        assert_eq!(
            claim(&case, "robot_clearance").holds,
            holds,
            "excess {excess}"
        );
        case.scene.planner.max_step = 0.04 - excess;
        assert_eq!(claim(&case, "step").holds, holds, "excess {excess}");
        case.net_length = 0.8 - excess;
        assert_eq!(claim(&case, "net_reach").holds, holds, "excess {excess}");
        // An obstacle may touch the net from outside the robots' reach: here its upper end.
        case.scene.obstacles = vec![wall(0.9, 1.0, 1.0 + excess, 3.0)];
        assert_eq!(
            claim(&case, "net_encloses_no_obstacle").holds,
            holds,
            "excess {excess}"
        );
    }
    // The tolerances that bounds are made of have no further slack.
    let mut case = straight();
    for (off, holds) in [(0.99e-6, true), (1.01e-6, false)] {
        case.scene.start.left.y = 2.4 + off;
        assert_eq!(claim(&case, "endpoints").holds, holds);
        case.scene.start.left.y = 2.4;
    }
    for (slip, holds) in [(0.99e-4, true), (1.01e-4, false)] {
        case.trajectory.left[10].y = 2.4 + slip;
        assert_eq!(claim(&case, "no_sideways_slip").holds, holds);
    }
    case.trajectory.left[10].y = 2.4;
    for (back, holds) in [(0.99e-6, true), (1.01e-6, false)] {
        case.trajectory.left[10].x = case.trajectory.left[9].x - back;
        assert_eq!(claim(&case, "forward").holds, holds);
    }
}

/// Two poses per robot and nothing else.
fn one_step(left: [Pose; 2], right: [Pose; 2], net_length: f64) -> Case {
    let scene = hall(8.0, 4.0, 2.0, 5.0);
    Case {
        scene,
        net_length,
        trajectory: PairTrajectory {
            left: left.to_vec(),
            right: right.to_vec(),
            step_time: 0.3,
        },
    }
}

#[test]
fn robots_that_come_close_between_waypoints_are_seen() {
    // They swap sides: 0.6 m apart at both ends, at one point half way.
    let (a, b) = (Pose::new(1.0, 1.0, 0.0), Pose::new(1.0, 1.6, 0.0));
    let separation = claim(&one_step([a, b], [b, a], 2.0), "separation");
    assert!(
        !separation.holds && (separation.margin + 0.48).abs() < 1e-12,
        "{separation:?}"
    );
}

#[test]
fn the_net_is_longest_between_waypoints() {
    // Headings swing outward from -a to a, left, and from a to -a, right: the hitches are widest apart at half a step
    // when the robots' axles bulge, here by turning through the direction across.
    let across = std::f64::consts::FRAC_PI_2;
    for swing in [0.05, 0.3, 1.0] {
        let left = [-across - swing, -across + swing].map(|h| Pose::new(2.0, 2.4, h));
        let right = [across + swing, across - swing].map(|h| Pose::new(2.0, 1.6, h));
        let widest = 0.8 + 2.0 * 0.207;
        let claim = claim(&one_step(left, right, 2.0), "net_reach");
        // The true maximum, and a certified bound that never lies below it.
        let margin = 2.0 - widest;
        assert!(
            claim.margin <= margin + 1e-15 && claim.margin > margin - 1e-10,
            "swing {swing}: {claim:?}"
        );
        let at_the_ends = 0.8 + 2.0 * 0.207 * swing.cos();
        assert!(
            widest - at_the_ends > 2e-4,
            "the ends alone would not see it"
        );
    }
}

#[test]
fn wild_headings_end_in_a_bound_and_not_in_a_loop() {
    let left = [0.0, 9e5].map(|h| Pose::new(2.0, 2.4, h));
    let right = [0.0, -7e5].map(|h| Pose::new(2.0, 1.6, h));
    assert!(!claim(&one_step(left, right, 1.0), "net_reach").holds);
}

#[test]
fn the_hull_of_a_step_counts_and_not_its_waypoints() {
    // Robots in motion along x; a disc between the two lines of a step, touching neither.
    let mut case = straight();
    case.scene.obstacles.push(Obstacle::Circle {
        center: Point::new(1.06, 2.0),
        radius: 0.01,
    });
    let claim = claim(&case, "net_encloses_no_obstacle");
    assert!(!claim.holds && claim.step == Some(1), "{claim:?}");
}

#[test]
fn a_path_between_waypoints_counts_and_not_its_waypoints() {
    // A long step past a post: both waypoints are far from it.
    let left = [1.0, 3.0].map(|x| Pose::new(x, 2.4, 0.0));
    let right = [1.0, 3.0].map(|x| Pose::new(x, 1.6, 0.0));
    let mut case = one_step(left, right, 2.0);
    case.scene.obstacles.push(Obstacle::Circle {
        center: Point::new(2.0, 2.65),
        radius: 0.05,
    });
    case.scene.objects.push(Object {
        position: Point::new(2.0, 1.9),
        footprint: Footprint::Disc(0.1),
        mass: 0.1,
        leave: false,
    });
    assert!((claim(&case, "robot_clearance").margin - (0.2 - 0.24)).abs() < 1e-12);
    assert!((claim(&case, "robots_miss_objects").margin - (0.3 - 0.1 - 0.24)).abs() < 1e-12);
}

#[test]
fn an_object_between_two_lines_is_covered_also_when_the_pair_pivots() {
    // The left robot stands, the right one swings: lines fan out.
    let left = [Pose::new(1.0, 2.0, 0.0); 2];
    let right = [Pose::new(1.0, 1.0, 0.0), Pose::new(1.3, 1.0, 0.0)];
    let mut case = one_step(left, right, 2.0);
    for (x, y, covered) in [
        (1.1, 1.5, true),
        (1.01, 1.9, true),
        (1.2, 1.5, false),
        (0.99, 1.5, false),
        (1.1, 0.99, false),
    ] {
        case.scene.objects = vec![cube(x, y)];
        assert_eq!(
            claim(&case, "every_object_covered").holds,
            covered,
            "({x}, {y})"
        );
    }
}

#[test]
fn cells_of_a_turned_map_are_squares_and_its_outside_is_blocked() {
    for yaw in [0.0, 0.5, 2.5] {
        let (columns, rows) = (80, 40);
        let mut map = OccupancyMap {
            origin: Pose::new(0.3, -0.7, yaw),
            resolution: 0.1,
            columns,
            rows,
            blocked: vec![false; columns * rows],
        };
        let mut case = straight();
        // The drive of `straight`, in the map's frame; cells are 0.1 m.
        let turned = |p: Pose| Pose::at(map.from_cells(p.position() * 10.0), p.heading + yaw);
        for poses in [&mut case.trajectory.left, &mut case.trajectory.right] {
            poses.iter_mut().for_each(|p| *p = turned(*p));
        }
        // Everything blocked from y = 2.8 on, and one cell ahead of the net.
        (0..columns * rows).for_each(|i| map.blocked[i] = i / columns >= 28);
        map.blocked[20 * columns + 17] = true;
        case.scene.map = Some(map.clone());
        let clearance = claim(&case, "robot_clearance");
        assert!(
            (clearance.margin - (0.4 - 0.24)).abs() < 1e-9,
            "yaw {yaw}: {clearance:?}"
        );
        let net = claim(&case, "net_encloses_no_obstacle");
        // The last line stands at x = 1.4, the cell begins at x = 1.7.
        assert!(
            (net.margin - 0.3).abs() < 1e-9 && net.detail.contains("column 17, row 20"),
            "yaw {yaw}: {net:?}"
        );

        map.blocked[20 * columns + 12] = true;
        case.scene.map = Some(map.clone());
        let net = claim(&case, "net_encloses_no_obstacle");
        assert!(!net.holds && net.margin < -0.009, "yaw {yaw}: {net:?}");

        // A map that ends at y = 2.5: the left robot is 0.1 m from its edge.
        map.rows = 25;
        map.blocked = vec![false; 25 * columns];
        case.scene.map = Some(map);
        let clearance = claim(&case, "robot_clearance");
        assert!(
            (clearance.margin - (0.1 - 0.24)).abs() < 1e-9,
            "yaw {yaw}: {clearance:?}"
        );
        assert!(clearance.detail.contains("outside of the map"));
    }
}

#[test]
fn a_line_on_the_border_of_two_blocked_cells_is_in_an_obstacle() {
    let mut case = straight();
    let (columns, rows) = (40, 40);
    let mut map = OccupancyMap {
        origin: Pose::default(),
        resolution: 0.2,
        columns,
        rows,
        blocked: vec![false; columns * rows],
    };
    // Two cells each: columns 4 and 5 of row 10 meet on x = 1.0, rows 9 and 10 of column 5 on y = 2.0.
    let upright = (
        [10 * columns + 4, 10 * columns + 5],
        [(1.0, 2.4), (1.0, 1.6)],
    );
    let level = (
        [9 * columns + 5, 10 * columns + 5],
        [(0.6, 2.0), (1.4, 2.0)],
    );
    for (cells, [left, right]) in [upright, level] {
        map.blocked.fill(false);
        cells.iter().for_each(|&i| map.blocked[i] = true);
        case.scene.map = Some(map.clone());
        // The pair stands with its line on that border.
        case.trajectory.left.fill(Pose::new(left.0, left.1, 0.0));
        case.trajectory.right.fill(Pose::new(right.0, right.1, 0.0));
        assert!(!claim(&case, "net_encloses_no_obstacle").holds, "{cells:?}");
    }
}

#[test]
fn robots_stay_in_the_area_on_every_side() {
    let mut case = straight();
    let area = case.scene.area;
    assert!(claim(&case, "inside_area").holds);
    let sides: [(&str, Point, Point); 4] = [
        ("left", Point::new(1.1, 0.0), area.max),
        ("lower", Point::new(0.0, 1.7), area.max),
        ("right", area.min, Point::new(1.3, 4.0)),
        ("upper", area.min, Point::new(8.0, 2.3)),
    ];
    for (side, min, max) in sides {
        (case.scene.area.min, case.scene.area.max) = (min, max);
        let claim = claim(&case, "inside_area");
        assert!(
            !claim.holds && (claim.margin + 0.1).abs() < 1e-12 && claim.detail.contains(side),
            "{claim:?}"
        );
    }
}

#[test]
fn headings_are_compared_modulo_a_turn_at_the_ends_and_are_continuous_along_the_way() {
    let mut case = straight();
    for poses in [&mut case.trajectory.left, &mut case.trajectory.right] {
        poses
            .iter_mut()
            .for_each(|p| p.heading += 3.0 * std::f64::consts::TAU);
    }
    assert!(certify(&case.scene, case.net_length, &case.trajectory, None).is_valid());
    case.trajectory.left[4].heading -= std::f64::consts::TAU;
    assert!(!claim(&case, "turn").holds);
}
