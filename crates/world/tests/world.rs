//! The world of a scene against brute force over the scene itself.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use pairtrawl_geometry::{Convex, Point, Pose};
use pairtrawl_model::{
    Area, Footprint, NetSpec, Object, Obstacle, OccupancyMap, PairPose, PhysicsParameters,
    PlannerParameters, Robot, Scene,
};
use pairtrawl_world::{Cell, World, WorldError, minimum_bounding_circle, overlap, signed_distance};
use proptest::prelude::*;

fn scene(obstacles: Vec<Obstacle>) -> Scene {
    let pair = PairPose {
        left: Pose::new(0.5, 0.8, 0.0),
        right: Pose::new(0.5, 0.2, 0.0),
    };
    Scene {
        name: "test".to_owned(),
        area: Area {
            min: Point::new(-0.5, 0.25),
            max: Point::new(3.5, 3.25),
            resolution: 0.05,
        },
        obstacles,
        map: None,
        objects: Vec::new(),
        start: pair,
        end: pair,
        robot: Robot::default(),
        net: NetSpec::default(),
        planner: PlannerParameters::default(),
        physics: PhysicsParameters::default(),
    }
}

fn object(x: f64, y: f64) -> Object {
    Object {
        position: Point::new(x, y),
        footprint: Footprint::Box(0.05, 0.05),
        mass: 0.025,
        leave: false,
    }
}

fn boxed(x: f64, y: f64, w: f64, h: f64) -> Obstacle {
    Obstacle::Box {
        min: Point::new(x, y),
        max: Point::new(x + w, y + h),
    }
}

fn shapes() -> impl Strategy<Value = Vec<Obstacle>> {
    let at = || (0.0..3.0_f64, 0.5..2.8_f64);
    let shape = prop_oneof![
        (at(), 0.01..1.0_f64, 0.01..1.0_f64).prop_map(|((x, y), w, h)| boxed(x, y, w, h)),
        (at(), 0.02..0.6_f64).prop_map(|((x, y), radius)| Obstacle::Circle {
            center: Point::new(x, y),
            radius
        }),
        (at(), prop::collection::vec(0.1..0.9_f64, 3..9)).prop_map(|((x, y), radii)| {
            let step = std::f64::consts::TAU / radii.len() as f64;
            let vertex =
                |(i, r): (usize, &f64)| Point::new(x, y) + Point::unit(i as f64 * step) * *r;
            Obstacle::Polygon(radii.iter().enumerate().map(vertex).collect())
        }),
    ];
    prop::collection::vec(shape, 1..7)
}

/// Distance from the boundary of a polygon, and the even-odd rule: neither uses convex pieces.
fn obstacle_distance(obstacle: &Obstacle, p: Point) -> f64 {
    let outline = match obstacle {
        Obstacle::Circle { center, radius } => return (p - *center).norm() - radius,
        Obstacle::Box { min, max } => vec![
            *min,
            Point::new(max.x, min.y),
            *max,
            Point::new(min.x, max.y),
        ],
        Obstacle::Polygon(outline) => outline.clone(),
    };
    let mut inside = false;
    let mut nearest = f64::INFINITY;
    for i in 0..outline.len() {
        let (a, b) = (outline[i], outline[(i + 1) % outline.len()]);
        inside ^= (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
        let t = ((p - a).dot(b - a) / (b - a).norm_squared()).clamp(0.0, 1.0);
        nearest = nearest.min(p.distance(a.lerp(b, t)));
    }
    if inside { -nearest } else { nearest }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Outside the samples are exact. Between them the interpolation never claims a fifth of a cell more than there is, and
    /// lacks up to half a cell at ridges half way between obstacles.
    #[test]
    fn the_field_is_the_distance_from_the_nearest_obstacle(obstacles in shapes(), probes in prop::collection::vec((-0.4..3.4_f64, 0.3..3.2_f64), 60)) {
        let world = World::new(&scene(obstacles.clone()), None).unwrap();
        let true_distance = |p: Point| obstacles.iter().map(|o| obstacle_distance(o, p)).fold(f64::INFINITY, f64::min);
        for (x, y) in probes {
            let p = Point::new(x, y);
            let (column, row) = world.grid.locate(p).unwrap();
            let node = world.grid.center(column, row);
            let (sample, truth) = (world.field.distance(node), true_distance(node));
            if truth > 0.0 {
                prop_assert!((sample - truth).abs() < 1e-9, "sample {} truth {} at {:?}", sample, truth, node);
            } else {
                prop_assert!(sample <= 0.0, "inside, sample {}", sample);
            }
            let (d, truth) = (world.field.distance(p), true_distance(p));
            if truth > 0.1 {
                prop_assert!(d - truth < 0.2 * 0.05 && truth - d < 0.5 * 0.05, "{} {}", d, truth);
            }
            if truth < -0.05 {
                prop_assert!(d < 0.0, "{} {}", d, truth);
            }
        }
    }

    #[test]
    fn the_gradient_is_that_of_the_interpolation_and_continuous(
        obstacles in shapes(), probes in prop::collection::vec((-3.0..6.0_f64, -3.0..6.0_f64), 40), heading in -3.0..3.0_f64,
    ) {
        let mut turned = scene(obstacles);
        let blocked = (0..24 * 18).map(|i| i % 7 == 0 && i % 5 != 1).collect();
        turned.map = Some(OccupancyMap { origin: Pose::new(0.3, -0.2, heading), resolution: 0.1, columns: 24, rows: 18, blocked });
        let field = World::new(&turned, None).unwrap().field;
        let h = 1e-6;
        for (x, y) in probes {
            let p = Point::new(x, y);
            let (value, gradient) = field.distance_and_gradient(p);
            prop_assert_eq!(value, field.distance(p));
            let along = |d: Point| (field.distance(p + d) - field.distance(p - d)) / (2.0 * h);
            prop_assert!((gradient.x - along(Point::new(h, 0.0))).abs() < 1e-4);
            prop_assert!((gradient.y - along(Point::new(0.0, h))).abs() < 1e-4);
        }
        // Across the lines between cells, where the cubics join, inside the grid, at its border and beyond.
        let (sin, cos) = heading.sin_cos();
        for k in 0..60 {
            let c = Point::new(-1.3 + 0.05 * f64::from(k), 0.37 + 0.031 * f64::from(k));
            let corner = Point::new(0.3, -0.2);
            let p = corner + Point::new(cos * c.x - sin * c.y, sin * c.x + cos * c.y);
            let step = Point::new(cos, sin) * 1e-9;
            let (before, after) = (field.distance_and_gradient(p - step), field.distance_and_gradient(p + step));
            prop_assert!((before.0 - after.0).abs() < 1e-7);
            prop_assert!((before.1 - after.1).norm() < 1e-5, "{:?} {:?}", before, after);
        }
    }

    #[test]
    fn map_cells_are_obstacles_wherever_they_lie(heading in -3.0..3.0_f64, noise in prop::collection::vec(any::<bool>(), 120), probes in prop::collection::vec((-1.0..2.5_f64, -1.0..2.5_f64), 60)) {
        let map = OccupancyMap { origin: Pose::new(0.2, 0.1, heading), resolution: 0.1, columns: 12, rows: 10, blocked: noise };
        let mut with_map = scene(Vec::new());
        with_map.map = Some(map.clone());
        let world = World::new(&with_map, None).unwrap();
        for (x, y) in probes {
            let p = Point::new(x, y);
            let c = map.to_cells(p);
            // Distance from the nearest blocked cell, cells outside included, by looking at all cells around.
            let mut truth = f64::INFINITY;
            for row in -40..50_i64 {
                for column in -40..50_i64 {
                    if map.is_blocked(column, row) {
                        let dx = (column as f64 - c.x).max(c.x - column as f64 - 1.0).max(0.0);
                        let dy = (row as f64 - c.y).max(c.y - row as f64 - 1.0).max(0.0);
                        truth = truth.min(0.1 * dx.hypot(dy));
                    }
                }
            }
            let by_pieces = world.pieces.iter().map(|piece| signed_distance(piece, p)).fold(f64::INFINITY, f64::min);
            if truth > 1e-9 {
                prop_assert!((by_pieces - truth).abs() < 1e-9, "{} {}", by_pieces, truth);
                prop_assert!(world.grid.cell_at(p) != Cell::Obstacle);
            } else if truth == 0.0 {
                prop_assert_eq!(world.grid.cell_at(p), Cell::Obstacle);
            }
        }
    }

    #[test]
    fn merged_circles_obey_the_rule(raw in prop::collection::vec((0.0..2.0_f64, 0.4..2.4_f64), 1..14), length in prop::option::of(0.6..3.0_f64)) {
        let mut with_objects = scene(Vec::new());
        with_objects.objects = raw.iter().map(|&(x, y)| object(x, y)).collect();
        let world = World::new(&with_objects, length).unwrap();
        let gamma = with_objects.robot.radius;
        let limit = { let d = length.unwrap_or(2.0); (d * with_objects.planner.rest_ratio).min(0.8 * d) };
        let bounding = |objects: &[usize]| {
            let corners: Vec<Point> = objects.iter().flat_map(|&i| {
                let p = with_objects.objects[i].position;
                [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(a, b)| Point::new(p.x + 0.025 * a, p.y + 0.025 * b))
            }).collect();
            let (center, radius) = minimum_bounding_circle(&corners);
            (center, radius + gamma)
        };
        // Every object is in one circle, and its footprint with gamma around it is inside.
        let mut seen: Vec<usize> = world.circles.iter().flat_map(|c| c.objects.clone()).collect();
        seen.sort_unstable();
        prop_assert_eq!(seen, (0..raw.len()).collect::<Vec<_>>());
        prop_assert!(world.circles.windows(2).all(|w| w[0].objects[0] < w[1].objects[0]));
        for circle in &world.circles {
            let (center, radius) = bounding(&circle.objects);
            prop_assert!(circle.center.distance(center) < 1e-9 && (circle.radius - radius).abs() < 1e-9);
            prop_assert!(circle.objects.len() == 1 || 2.0 * circle.radius <= limit);
        }
        // No two circles are left that may be merged.
        for (i, a) in world.circles.iter().enumerate() {
            for b in &world.circles[..i] {
                let union = [a.objects.clone(), b.objects.clone()].concat();
                prop_assert!(a.center.distance(b.center) >= 2.0 * gamma || 2.0 * bounding(&union).1 > limit);
            }
        }
    }

    #[test]
    fn overlapping_shapes_are_told_from_separate_ones(obstacles in shapes()) {
        let pieces = World::new(&scene(obstacles), None).unwrap().pieces;
        for (i, a) in pieces.iter().enumerate() {
            for b in &pieces[..i] {
                // A dense grid finds a shared point deeper than its spacing.
                let shared = (0..10_000).map(|k| Point::new(-1.0 + 0.05 * f64::from(k % 100), -0.5 + 0.05 * f64::from(k / 100)))
                    .map(|p| signed_distance(a, p).max(signed_distance(b, p)))
                    .fold(f64::INFINITY, f64::min);
                if shared < -1e-9 { prop_assert!(overlap(a, b, 1e-9)); }
                if shared > 0.05 { prop_assert!(!overlap(a, b, 1e-9)); }
            }
        }
    }
}

#[test]
fn one_object_has_the_circle_of_its_footprint_and_gamma() {
    let mut s = scene(Vec::new());
    s.objects = vec![
        object(1.0, 1.0),
        Object {
            footprint: Footprint::Disc(0.1),
            ..object(2.0, 2.0)
        },
    ];
    let world = World::new(&s, Some(1.5)).unwrap();
    assert!((world.object_circles[0].radius - (0.025 * 2.0_f64.sqrt() + 0.24)).abs() < 1e-12);
    assert_eq!(
        (
            world.object_circles[1].radius,
            world.object_circles[1].center
        ),
        (0.1 + 0.24, Point::new(2.0, 2.0))
    );
    s.planner.circle_margin = Some(0.3);
    assert_eq!(
        World::new(&s, Some(1.5)).unwrap().object_circles[1].radius,
        0.4
    );
}

#[test]
fn close_discs_share_a_circle_that_contains_them() {
    let mut s = scene(Vec::new());
    let disc = |x: f64| Object {
        footprint: Footprint::Disc(0.05),
        ..object(x, 1.0)
    };
    s.objects = vec![disc(1.0), disc(1.3)];
    let circles = World::new(&s, Some(2.0)).unwrap().circles;
    assert_eq!(circles.len(), 1);
    assert!(circles[0].radius >= 0.2 + 0.24 && circles[0].radius < 0.2001 + 0.24);
    // A short net keeps them apart: the merged diameter 0.88 exceeds 2/pi of it.
    assert_eq!(World::new(&s, Some(1.2)).unwrap().circles.len(), 2);
}

#[test]
fn the_grid_tells_obstacles_objects_and_the_area() {
    let mut s = scene(vec![
        boxed(1.0, 1.0, 0.5, 0.5),
        boxed(2.0, 1.0, 0.001, 0.5),
        boxed(3.6, 1.0, 0.2, 0.2),
    ]);
    s.objects = vec![object(2.5, 2.5)];
    let world = World::new(&s, None).unwrap();
    let cell = |x, y| world.grid.cell_at(Point::new(x, y));
    assert_eq!(
        (cell(1.25, 1.25), cell(2.5, 2.5), cell(0.0, 0.5)),
        (Cell::Obstacle, Cell::Object, Cell::Free)
    );
    // A wall a millimeter thick, and one outside the area that the net could touch.
    assert_eq!(
        (cell(2.0005, 1.2), cell(3.7, 1.1), cell(900.0, 0.0)),
        (Cell::Obstacle, Cell::Obstacle, Cell::Free)
    );
    assert!(
        world.grid.is_inside_area(Point::new(-0.5, 3.25))
            && !world.grid.is_inside_area(Point::new(-0.51, 1.0))
    );
    // A box on cell borders fills 10 x 10 cells and not one more.
    let alone = World::new(&scene(vec![boxed(1.0, 1.0, 0.5, 0.5)]), None).unwrap();
    assert_eq!(
        alone
            .grid
            .cells
            .iter()
            .filter(|&&c| c == Cell::Obstacle)
            .count(),
        100
    );
    assert_eq!((alone.grid.columns, alone.grid.rows), (80 + 40, 60 + 40));
}

#[test]
fn far_points_and_empty_scenes_have_distances() {
    let field = World::new(&scene(Vec::new()), None).unwrap().field;
    let (d, g) = field.distance_and_gradient(Point::new(1.0, 1.0));
    assert!(d > 5.0 && g.norm() < 1e-9);
    let field = World::new(&scene(vec![boxed(1.0, 1.0, 1.0, 1.0)]), None)
        .unwrap()
        .field;
    for p in [
        Point::new(1e3, -1e3),
        Point::new(1e6, 1.5),
        Point::new(-1e300, 1e300),
    ] {
        let d = field.distance(p);
        assert!(d > 0.0, "{d} at {p:?}");
    }
    assert!((field.distance(Point::new(102.0, 1.5)) - 100.0).abs() < 1.0);
    assert!(field.distance(Point::new(f64::NAN, 0.0)).is_nan());
}

#[test]
fn what_cannot_be_built_is_said() {
    let mut s = scene(Vec::new());
    s.area.resolution = 1e-9;
    assert!(matches!(
        World::new(&s, None),
        Err(WorldError::TooManyCells { .. })
    ));
    s.area.resolution = 0.0;
    assert!(matches!(
        World::new(&s, None),
        Err(WorldError::NotPositive { .. })
    ));
    s = scene(vec![Obstacle::Polygon(vec![
        Point::ZERO,
        Point::new(1.0, 1.0),
        Point::new(2.0, 2.0),
    ])]);
    assert_eq!(
        World::new(&s, None).unwrap_err(),
        WorldError::FlatPolygon { index: 0 }
    );
    s = scene(vec![boxed(f64::NAN, 0.0, 1.0, 1.0)]);
    assert!(matches!(
        World::new(&s, None),
        Err(WorldError::NotFinite { .. })
    ));
    s = scene(Vec::new());
    s.area.max.x = f64::INFINITY;
    assert!(World::new(&s, None).is_err());
    assert!(World::new(&scene(Vec::new()), Some(f64::NAN)).is_err());
}

#[test]
fn pieces_of_simple_shapes_are_the_shapes() {
    let l = [
        (0.0, 1.0),
        (2.0, 1.0),
        (2.0, 2.0),
        (1.0, 2.0),
        (1.0, 3.0),
        (0.0, 3.0),
    ]
    .map(|(x, y)| Point::new(x, y))
    .to_vec();
    let obstacles = vec![
        boxed(2.5, 1.0, 0.5, 0.5),
        Obstacle::Circle {
            center: Point::new(3.0, 3.0),
            radius: 0.2,
        },
        Obstacle::Polygon(l),
    ];
    let pieces = World::new(&scene(obstacles), None).unwrap().pieces;
    assert!(matches!(&pieces[0], Convex::Polygon(v) if v.len() == 4));
    assert_eq!(
        pieces[1],
        Convex::Circle {
            center: Point::new(3.0, 3.0),
            radius: 0.2
        }
    );
    assert_eq!(pieces.len(), 4);
}
