//! Robots with a body touch with its circles.

mod scenes;

use pairtrawl_geometry::Point;
use pairtrawl_model::{Body, BodyCircle, Preset, Scene, Side};
use pairtrawl_simulation::{Options, Part, RobotDrive, Simulation, export};
use scenes::{block, empty, straight};

fn with_body(circles: &[[f64; 3]]) -> Scene {
    let circle = |[x, y, radius]: [f64; 3]| BodyCircle {
        center: Point::new(x, y),
        radius,
    };
    let circles: Vec<_> = circles.iter().copied().map(circle).collect();
    let mut scene = empty();
    scene.robot.body = Body::of(&circles);
    scene
}

/// Drives straight on for some time, s, at 0.2 m/s.
fn drive(simulation: &mut Simulation, time: f64) {
    while simulation.time() < time {
        let ahead = RobotDrive::Velocity {
            forward: 0.2,
            turn_rate: 0.0,
        };
        simulation.step([ahead, ahead]).unwrap();
    }
}

fn left_touches(simulation: &Simulation) -> bool {
    let contacts = simulation.contacts();
    contacts
        .iter()
        .any(|c| (c.first, c.second) == (Part::Obstacle(Some(0)), Part::Robot(Side::Left)))
}

#[test]
fn the_circles_touch_and_nothing_else_does() {
    // The front is at y = 0.4, to the left it reaches to x = -0.55.
    let circles = [[0.3, 0.0, 0.1], [0.0, 0.05, 0.2]];
    for (wall, touches) in [
        (block(-0.5, 0.45, -0.1, 0.5), true),
        // Between the circles, where a hull of them would touch.
        (block(-0.5, 0.33, -0.43, 0.35), false),
        (block(-0.6, 0.05, -0.54, 0.15), true),
        (block(-0.7, -0.2, -0.56, 0.5), false),
    ] {
        let mut scene = with_body(&circles);
        scene.obstacles = vec![wall.clone()];
        let mut simulation = Simulation::new(&scene, 1.2, &Options::default()).unwrap();
        let mut touched = false;
        for k in 1..=20 {
            drive(&mut simulation, 0.025 * f64::from(k));
            touched |= left_touches(&simulation);
        }
        assert_eq!(touched, touches, "{wall:?}");
    }
}

#[test]
fn the_net_trails_a_waffle_as_it_trails_its_base() {
    let mut scene = empty();
    scene.robot = Preset::WafflePi.robot();
    let mut simulation = Simulation::new(&scene, 1.2, &Options::default()).unwrap();
    assert!(simulation.warnings().is_empty());
    let mut base = Simulation::new(&empty(), 1.2, &Options::default()).unwrap();
    for simulation in [&mut simulation, &mut base] {
        drive(simulation, 4.0);
        assert!(simulation.contacts().is_empty());
    }
    let nets = (simulation.net(), base.net());
    for (a, b) in nets.0.iter().zip(&nets.1) {
        assert!(a.distance(*b) < 1e-3, "{a:?} {b:?}");
    }
}

#[test]
fn a_hitch_deep_inside_a_body_holds_the_net_without_touch() {
    // The hitch is at the center of a circle of 0.25 m: three links lie within.
    let scene = with_body(&[[-0.1, 0.0, 0.2], [-0.207, 0.0, 0.25]]);
    let mut simulation = Simulation::new(&scene, 1.8, &Options::default()).unwrap();
    assert_eq!(simulation.parameters().links_within_body(), 3);
    assert!(simulation.warnings().is_empty());
    drive(&mut simulation, 3.0);
    assert!(
        simulation.contacts().is_empty(),
        "{:?}",
        simulation.contacts()
    );
    for robot in simulation.robots() {
        assert!((robot.forward - 0.2).abs() < 5e-3, "{robot:?}");
    }
}

#[test]
fn exports_have_the_circles() {
    let scene = with_body(&[[-0.1, 0.0, 0.2], [-0.207, 0.0, 0.25]]);
    let path = straight(&scene, 1.0);
    let mjcf = export::mjcf(&scene, 1.8, &path).unwrap();
    assert_eq!(mjcf.matches("type=\"cylinder\" pos=\"-0.1 0").count(), 2);
    assert_eq!(mjcf.matches("<exclude ").count(), 5);
    let sdf = export::sdf(&scene, 1.8, &path).unwrap();
    assert_eq!(sdf.matches("<collision name=\"collision_1\">").count(), 2);
    assert_eq!(sdf.matches("<collide_bitmask>1<").count(), 6);
    // Those of robots without a body are as they were.
    let plain = export::sdf(&empty(), 1.8, &path).unwrap();
    assert!(!plain.contains("collide_bitmask"));
    let plain = export::mjcf(&empty(), 1.8, &path).unwrap();
    assert_eq!(plain.matches("<exclude ").count(), 1);
}
