//! The scenes over ROS maps leave room for the pair: along a guide line both robots keep off the walls, and at every object
//! they fit on both sides of it.

use pairtrawl::files::read_scene;
use pairtrawl_geometry::Point;
use pairtrawl_model::Scene;
use pairtrawl_world::World;
use std::path::Path;

fn load(name: &str) -> (Scene, World) {
    let loaded = read_scene(
        &Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../scenes")
            .join(name)
            .join("scene.toml"),
    )
    .unwrap();
    assert!(loaded.warnings.is_empty(), "{:?}", loaded.warnings);
    let world = World::new(&loaded.scene, loaded.scene.net.length).unwrap();
    (loaded.scene, world)
}

/// Points every 2 cm along a polyline, with the direction there.
fn samples(guide: &[Point]) -> Vec<(Point, Point)> {
    guide
        .windows(2)
        .flat_map(|w| {
            let d = w[1] - w[0];
            let n = (d.norm() / 0.02).ceil() as usize;
            (0..n).map(move |k| (w[0] + d * (k as f64 / n as f64), d / d.norm()))
        })
        .collect()
}

/// The greatest separation, up to the net length, at which both robots, abreast, keep `room` beyond their radius.
fn widest(scene: &Scene, world: &World, (p, forward): (Point, Point), room: f64) -> f64 {
    let side = forward.perp() * 0.5;
    let fits = |s: f64| {
        [1.0, -1.0]
            .iter()
            .all(|k| world.field.distance(p + side * (k * s)) >= scene.robot.radius + room)
    };
    (0..200)
        .map(|k| 2.0 * scene.robot.radius + 0.01 * f64::from(k))
        .take_while(|&s| s <= scene.net.length.unwrap())
        .filter(|&s| fits(s))
        .fold(0.0, f64::max)
}

fn check(name: &str, guide: &[Point], room: f64) {
    let (scene, world) = load(name);
    assert_eq!(scene.objects.len(), 10);
    let course = samples(guide);
    for &at in &course {
        let widest = widest(&scene, &world, at, room);
        assert!(widest > 0.0, "{name}: no room at {:?}", at.0);
    }
    for object in &scene.objects {
        let nearest = (course.iter())
            .min_by(|a, b| {
                a.0.distance(object.position)
                    .total_cmp(&b.0.distance(object.position))
            })
            .unwrap();
        let off = nearest.0.distance(object.position);
        let needed = 2.0 * (off + scene.robot.radius + object.footprint_radius() + room);
        let widest = widest(&scene, &world, *nearest, room);
        assert!(
            widest >= needed,
            "{name}: object at {:?} needs {needed:.3} m, there are {widest:.3} m",
            object.position
        );
    }
}

#[test]
fn burgers_fit_into_the_lanes_of_the_turtlebot3_world() {
    let mut guide = [(-1.75, 0.55), (-1.05, 0.55), (0.0, 0.55), (1.1, 0.53)]
        .map(|(x, y)| Point::new(x, y))
        .to_vec();
    guide.extend((0..=12).map(|k| {
        Point::new(1.3, 0.0)
            + Point::unit(std::f64::consts::FRAC_PI_2 - f64::from(k) * std::f64::consts::PI / 12.0)
                * 0.52
    }));
    guide.extend(
        [(1.1, -0.53), (0.0, -0.55), (-1.05, -0.55), (-1.75, -0.55)].map(|(x, y)| Point::new(x, y)),
    );
    check("turtlebot3-world", &guide, 0.05);
}

#[test]
fn waffles_fit_into_the_bay_of_the_nav2_sandbox() {
    let guide = [
        (-1.74, -0.85),
        (-1.77, -0.6),
        (-1.81, -0.4),
        (-1.86, -0.2),
        (-1.88, 0.0),
        (-1.86, 0.2),
        (-1.81, 0.4),
        (-1.77, 0.6),
        (-1.73, 0.9),
    ];
    check("nav2-sandbox", &guide.map(|(x, y)| Point::new(x, y)), 0.02);
}
