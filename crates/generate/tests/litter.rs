//! Scenes as they are found: who lies where, and that a seed means one scene.

use pairtrawl_certificate::Clearance;
use pairtrawl_generate::{Litter, LitterError, litter, litter_hall, scene_toml, scene_toml_on_map};
use pairtrawl_geometry::{Hull, Point, Pose};
use pairtrawl_model::{Area, Footprint, Obstacle, OccupancyMap, Scene};

const RESOLUTION: f64 = 0.1;

fn about(objects: usize, near: f64, seed: u64) -> Litter {
    Litter {
        name: "test".to_owned(),
        objects,
        near,
        seed,
    }
}

/// Two rooms, 6 m x 5 m and 3 m x 5 m, a wall between them, with a door of this many cells in it.
fn two_rooms(door: usize) -> (OccupancyMap, Area) {
    let (columns, rows) = (93, 52);
    let mut map = OccupancyMap {
        origin: Pose::new(-1.0, 2.0, 0.0),
        resolution: RESOLUTION,
        columns,
        rows,
        blocked: vec![false; columns * rows],
    };
    for row in 0..rows {
        for column in 0..columns {
            let edge = row == 0 || row == rows - 1 || column == 0 || column == columns - 1;
            let wall = column == 61 && !(20..20 + door).contains(&row);
            map.blocked[row * columns + column] = edge || wall;
        }
    }
    let area = Area {
        min: map.from_cells(Point::ZERO),
        max: map.from_cells(Point::new(columns as f64, rows as f64)),
        resolution: RESOLUTION,
    };
    (map, area)
}

/// x of the wall between the rooms, m.
fn wall() -> f64 {
    two_rooms(0).0.from_cells(Point::new(61.5, 0.0)).x
}

fn lies_well(scene: &Scene, near: f64) {
    let clearance = Clearance::new(scene).expect("a scene");
    let distance = |p: Point| clearance.distance(&Hull::of(&[p])).unwrap_or(f64::INFINITY);
    for (i, object) in scene.objects.iter().enumerate() {
        let (p, rho) = (object.position, object.footprint_radius());
        assert!(distance(p) >= near, "object {i} near a wall");
        let size = match object.footprint {
            Footprint::Box(width, depth) => [width, depth],
            Footprint::Disc(radius) => [2.0 * radius; 2],
        };
        assert!(size.iter().all(|s| (0.03..=0.1).contains(s)), "{size:?}");
        assert!((0.005..0.2).contains(&object.mass), "{}", object.mass);
        for other in &scene.objects[..i] {
            assert!(other.position.distance(p) > rho + other.footprint_radius());
        }
        for pair in [scene.start, scene.end] {
            for pose in [pair.left, pair.right] {
                assert!(pose.position().distance(p) > scene.robot.radius + rho);
            }
        }
    }
    for pair in [scene.start, scene.end] {
        assert!(pair.separation() >= 2.0 * scene.robot.radius);
        for pose in [pair.left, pair.right] {
            assert!(distance(pose.position()) >= scene.robot.radius);
        }
    }
}

#[test]
fn litter_lies_off_walls_and_robots_and_one_another() {
    let (map, area) = two_rooms(12);
    for seed in 0..20 {
        let scene = litter(map.clone(), area, &about(40, 0.3, seed)).expect("a scene");
        assert_eq!(scene.objects.len(), 40);
        lies_well(&scene, 0.3);
        let hall = litter_hall([12.0, 8.0], 4, &about(60, 0.5, seed)).expect("a hall");
        assert_eq!((hall.objects.len(), hall.obstacles.len()), (60, 4));
        lies_well(&hall, 0.5);
        for object in &hall.objects {
            let Point { x, y } = object.position;
            assert!((0.5..=11.5).contains(&x) && (0.5..=7.5).contains(&y));
        }
        for (i, a) in hall.obstacles.iter().enumerate() {
            for b in &hall.obstacles[..i] {
                let (Obstacle::Box { min, max }, Obstacle::Box { min: l, max: h }) = (a, b) else {
                    panic!("a box");
                };
                assert!(min.x > h.x || l.x > max.x || min.y > h.y || l.y > max.y);
            }
        }
    }
}

#[test]
fn litter_lies_only_where_the_pair_can_come() {
    let beyond = |door: usize| {
        let (map, area) = two_rooms(door);
        (0..10)
            .flat_map(|seed| {
                let scene = litter(map.clone(), area, &about(20, 0.3, seed)).expect("a scene");
                let robots = [scene.start, scene.end].map(|pair| pair.midpoint());
                let objects = scene.objects.iter().map(|o| o.position);
                objects.chain(robots).collect::<Vec<_>>()
            })
            .filter(|p| p.x > wall())
            .count()
    };
    // A door as wide as the pair is not is no way into the smaller room; a third of the floor lies there.
    assert_eq!(beyond(6), 0);
    assert!((30..120).contains(&beyond(10)), "{}", beyond(10));
}

#[test]
fn a_seed_is_a_scene() {
    let (map, area) = two_rooms(12);
    let text = |objects, seed| {
        let scene = litter(map.clone(), area, &about(objects, 0.4, seed)).expect("a scene");
        scene_toml_on_map(&scene, "map.yaml")
    };
    assert_eq!(text(12, 5), text(12, 5));
    assert_ne!(text(12, 5), text(12, 6));
    let hall = |seed| {
        let scene = litter_hall([9.0, 7.0], 3, &about(12, 0.4, seed)).expect("a hall");
        scene_toml(&scene).expect("a scene without a map")
    };
    assert_eq!(hall(5), hall(5));
    assert_ne!(hall(5), hall(6));
}

#[test]
fn what_does_not_fit_is_said() {
    let (map, area) = two_rooms(12);
    let refused = |about: &Litter| litter(map.clone(), area, about).expect_err("no room");
    assert!(matches!(
        refused(&about(5, 2.6, 1)),
        LitterError::Full { placed: 0, .. }
    ));
    assert!(matches!(
        refused(&about(9000, 0.3, 1)),
        LitterError::Full { wanted: 9000, .. }
    ));
    let mut full = map.clone();
    full.blocked.fill(true);
    assert!(matches!(
        litter(full, area, &about(5, 0.3, 1)),
        Err(LitterError::NoFloor { .. })
    ));
    assert!(matches!(
        litter_hall([3.0, 3.0], 50, &about(5, 0.3, 1)),
        Err(LitterError::Boxes { wanted: 50, .. })
    ));
    // A corridor of 0.9 m is wide enough for the pair on its way, not for one that stands abreast with room around.
    let mut corridor = map.clone();
    for (i, blocked) in corridor.blocked.iter_mut().enumerate() {
        *blocked |= i / corridor.columns > 9;
    }
    assert!(matches!(
        litter(corridor, area, &about(5, 0.3, 1)),
        Err(LitterError::NoStand { what: "start", .. })
    ));
}
