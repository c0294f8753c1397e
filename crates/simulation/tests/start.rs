//! How the net lies at the start, what is refused, and what is exported.

mod scenes;

use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::Side;
use pairtrawl_simulation::{Options, Simulation, SimulationError};
use scenes::{block, cube, empty, straight};
use std::f64::consts::FRAC_PI_2;

#[test]
fn the_net_starts_as_a_symmetric_u_of_its_length() {
    for length in [0.7, 1.0, 1.45, 2.3, 3.0] {
        let simulation = Simulation::new(&empty(), length, &Options::default()).unwrap();
        let net = simulation.net();
        let total: f64 = net.windows(2).map(|s| s[0].distance(s[1])).sum();
        assert!(
            (total - length).abs() < 1e-9,
            "{total} m, expected {length} m"
        );
        assert!(simulation.joint_gap() < 1e-9);
        assert!(net[0].distance(Point::new(-0.3, -0.207)) < 1e-9);
        for (a, b) in net.iter().zip(net.iter().rev()) {
            assert!((a.x + b.x).abs() < 1e-9 && (a.y - b.y).abs() < 1e-9);
        }
        assert!(net.iter().all(|p| p.y < -0.207 + 1e-9));
        assert!(simulation.warnings().is_empty());
    }
}

#[test]
fn the_scene_may_say_how_the_net_lies() {
    let mut scene = empty();
    let outline = [
        [-0.3, -0.207],
        [-0.3, -0.5],
        [0.6, -0.5],
        [0.6, -0.207],
        [0.3, -0.207],
    ];
    scene.net.start = Some(outline.map(Point::from).to_vec());
    let length = 0.293 + 0.9 + 0.293 + 0.3;
    let simulation = Simulation::new(&scene, length, &Options::default()).unwrap();
    assert!(
        simulation.warnings().is_empty(),
        "{:?}",
        simulation.warnings()
    );
    assert!(simulation.joint_gap() < 1e-9);
    assert!(
        simulation.net().iter().any(|p| p.x > 0.5),
        "{:?}",
        simulation.net()
    );
    scene.net.start = Some(vec![Point::new(-0.3, -0.207), Point::new(0.3, -0.5)]);
    let error = Simulation::new(&scene, length, &Options::default()).err();
    assert!(
        matches!(
            error,
            Some(SimulationError::NetStart {
                side: Side::Right,
                ..
            })
        ),
        "{error:?}"
    );
}

#[test]
fn what_cannot_be_simulated_is_named() {
    let scene = empty();
    let error = Simulation::new(&scene, 0.5, &Options::default())
        .err()
        .unwrap();
    assert_eq!(
        error,
        SimulationError::NetTooShort {
            gap: 0.6,
            length: 0.5
        }
    );
    let mut heavy = empty();
    heavy.objects = vec![cube(0.0, 1.0)];
    heavy.objects[0].mass = -1.0;
    assert!(matches!(
        Simulation::new(&heavy, 1.5, &Options::default()),
        Err(SimulationError::Parameter { .. })
    ));
    let mut path = straight(&scene, 1.0);
    path.left[3] = Pose::new(f64::NAN, 0.0, FRAC_PI_2);
    let error = pairtrawl_simulation::export::mjcf(&scene, 1.5, &path).unwrap_err();
    assert!(matches!(error, SimulationError::Trajectory { .. }));
    let coarse = Options {
        time_step: 0.1,
        ..Options::default()
    };
    assert!(matches!(
        Simulation::new(&scene, 1.5, &coarse),
        Err(SimulationError::Option {
            name: "time_step",
            ..
        })
    ));
    assert!(Simulation::new(&scene, f64::NAN, &Options::default()).is_err());
}

#[test]
fn exports_hold_every_part() {
    let mut scene = empty();
    scene.objects = vec![cube(0.0, 0.5), cube(0.1, 0.9)];
    scene.obstacles.push(block(2.0, 0.0, 3.0, 1.0));
    let path = straight(&scene, 1.0);
    let mjcf = pairtrawl_simulation::export::mjcf(&scene, 1.5, &path).unwrap();
    assert_eq!(mjcf.matches("<body name=\"link_").count(), 15);
    assert_eq!(mjcf.matches("<body name=\"object_").count(), 2);
    assert_eq!(mjcf.matches("<geom name=\"obstacle_").count(), 1);
    // Per robot 3 joints, per link a hinge and two feet, per object 3 joints and four feet.
    let keyframe = mjcf
        .split("qpos=\"")
        .nth(1)
        .unwrap()
        .split('"')
        .next()
        .unwrap();
    assert_eq!(keyframe.split_whitespace().count(), 2 * 3 + 15 * 3 + 2 * 7);
    let sdf = pairtrawl_simulation::export::sdf(&scene, 1.5, &path).unwrap();
    assert_eq!(sdf.matches("<link name=\"link_").count(), 15);
    assert_eq!(sdf.matches("<model name=\"object_").count(), 2);
    assert_eq!(sdf.matches("<joint name=\"hinge_").count(), 14);
}
