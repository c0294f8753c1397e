//! Scenes in other units, and the way back.

use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Area, Circle, Footprint, NetSpec, Object, Obstacle, OccupancyMap, PairPose, PairTrajectory,
    PhysicsParameters, PlannerParameters, Robot, RobotSize, Scales, Scene, Units,
};

fn scene() -> Scene {
    let pair = |y: f64| PairPose {
        left: Pose::new(0.7, y, 1.5),
        right: Pose::new(1.3, y, 1.5),
    };
    Scene {
        name: "scene".to_owned(),
        area: Area {
            min: Point::new(-1.0, 0.0),
            max: Point::new(4.0, 5.0),
            resolution: 0.05,
        },
        obstacles: vec![
            Obstacle::Box {
                min: Point::new(2.0, 2.0),
                max: Point::new(3.0, 2.5),
            },
            Obstacle::Polygon(vec![
                Point::new(0.0, 3.0),
                Point::new(0.3, 3.0),
                Point::new(0.0, 3.3),
            ]),
            Obstacle::Circle {
                center: Point::new(3.0, 4.0),
                radius: 0.2,
            },
        ],
        map: Some(OccupancyMap {
            origin: Pose::new(-1.0, -0.5, 0.3),
            resolution: 0.05,
            columns: 1,
            rows: 2,
            blocked: vec![true, false],
        }),
        objects: vec![
            Object {
                position: Point::new(1.0, 2.0),
                footprint: Footprint::Box(0.05, 0.07),
                mass: 0.025,
                leave: false,
            },
            Object {
                position: Point::new(1.0, 3.0),
                footprint: Footprint::Disc(0.03),
                mass: 0.025,
                leave: false,
            },
        ],
        start: pair(0.37),
        end: pair(4.41),
        robot: Robot::default(),
        net: NetSpec {
            length: Some(2.3),
            start: Some(vec![Point::new(0.7, 0.2), Point::new(1.3, 0.2)]),
        },
        planner: PlannerParameters {
            circle_margin: Some(0.3),
            ..PlannerParameters::default()
        },
        physics: PhysicsParameters::default(),
    }
}

/// The scene in units whose inverse gives it back.
fn there_and_back(scene: &Scene, units: Units) -> Scene {
    let inverse = Units {
        length: 1.0 / units.length,
        time: 1.0 / units.time,
        mass: 1.0 / units.mass,
    };
    inverse.scene(&units.scene(scene))
}

#[test]
fn powers_of_two_lose_nothing_there_and_back() {
    let units = Units {
        length: 8.0,
        time: 0.25,
        mass: 32.0,
    };
    assert_eq!(there_and_back(&scene(), units), scene());
    assert_ne!(units.scene(&scene()), scene());
}

#[test]
fn every_number_is_scaled_by_its_unit() {
    let units = Units {
        length: 2.0,
        time: 4.0,
        mass: 16.0,
    };
    let (scaled, si) = (units.scene(&scene()), scene());
    let Scene {
        area,
        obstacles,
        map,
        objects,
        start,
        end,
        robot,
        net,
        planner: p,
        physics: f,
        ..
    } = &scaled;
    assert_eq!(
        (area.min, area.max, area.resolution),
        (si.area.min / 2.0, si.area.max / 2.0, 0.025)
    );
    assert_eq!(
        obstacles[0],
        Obstacle::Box {
            min: Point::new(1.0, 1.0),
            max: Point::new(1.5, 1.25)
        }
    );
    assert!(matches!(&obstacles[1], Obstacle::Polygon(v) if v[2] == Point::new(0.0, 1.65)));
    assert!(matches!(obstacles[2], Obstacle::Circle { radius, .. } if radius == 0.1));
    let map = map.as_ref().expect("the map stays");
    assert_eq!(
        (map.origin, map.resolution),
        (Pose::new(-0.5, -0.25, 0.3), 0.025)
    );
    assert_eq!(objects[0].footprint, Footprint::Box(0.025, 0.035));
    assert_eq!(objects[1].footprint, Footprint::Disc(0.015));
    assert_eq!(
        (objects[0].position, objects[0].mass),
        (Point::new(0.5, 1.0), 0.025 / 16.0)
    );
    assert_eq!(start.left, Pose::new(0.35, 0.185, 1.5));
    assert_eq!(end.right, Pose::new(0.65, 2.205, 1.5));
    assert_eq!(
        (robot.radius, robot.hitch, robot.half_track),
        (0.12, 0.1035, 0.072)
    );
    assert_eq!(
        (robot.v_max, robot.omega_max),
        (0.52, 7.28),
        "m/s and rad/s"
    );
    assert_eq!(
        (net.length, net.start.as_ref().map(|p| p[1])),
        (Some(1.15), Some(Point::new(0.65, 0.1)))
    );
    assert_eq!(
        (p.max_step, p.max_turn, p.max_skew, p.clearance),
        (0.025, 0.1, 1.0, 0.025)
    );
    assert_eq!(
        (p.cruise, p.half_separation, p.circle_margin),
        (0.44, 0.15, Some(0.15))
    );
    assert_eq!((p.k1, p.k2, p.k3), (1e7, 1e7 / 4.0, 1e7), "1, m^2, 1");
    assert_eq!(
        (p.t1, p.t2, p.kd1, p.kd2),
        (600.0, 10.0, 20.0, 60.0),
        "1/m, 1/rad, 1, 1/m^2"
    );
    assert_eq!(
        (p.b1, p.b2, p.b3),
        (440.0, 440.0, 1.0),
        "1/m^2, 1/m^2, 1/rad^2"
    );
    assert_eq!(
        (f.gravity, f.robot_mass),
        (9.81 * 8.0, 1.43 / 16.0),
        "m/s^2, kg"
    );
    assert_eq!(f.robot_inertia, 0.0146 / 64.0, "kg m^2");
    assert_eq!((f.max_torque, f.tension_limit), (3.0 / 4.0, 5.0), "N m, N");
    assert_eq!(
        (f.net_mass, f.hinge_damping),
        (0.02 / 8.0, 1e-3 / 16.0),
        "kg/m, N m s/rad"
    );
    assert_eq!((f.center_of_mass, f.wheel_radius), (0.01, 0.0165));
    assert_eq!(
        (f.net_link, f.net_thickness, f.net_height),
        (0.05, 0.005, 0.04)
    );
}

#[test]
fn the_default_machine_has_scale_one_and_its_scene_keeps_its_bits() {
    let scene = scene();
    let scales = Scales::of(&scene);
    assert_eq!(scales.length, 1.0);
    assert_eq!(scales.scene(&scene), scene);
}

#[test]
fn a_large_machine_looks_like_the_default_one() {
    let tenfold = Units {
        length: 0.1,
        ..Units::SI
    }
    .scene(&scene());
    let scales = Scales::of(&tenfold);
    assert!((scales.length - 10.0).abs() < 1e-12);
    let back = scales.scene(&tenfold);
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs();
    assert!(near(back.end.left.y, 4.41) && near(back.net.length.unwrap_or(0.0), 2.3));
    assert!(near(back.planner.t1, 300.0) && near(back.planner.b1, 110.0));
    let mut broken = tenfold;
    broken.robot.radius = 0.0;
    assert_eq!(Scales::of(&broken).length, 1.0);
}

#[test]
fn ends_come_back_as_the_scenes_own() {
    let mut scene = scene();
    scene.robot.radius = 0.77;
    let scales = Scales::of(&scene);
    let small = scales.scene(&scene);
    let between = Pose::new(0.1, 0.2, 0.3);
    let turned = |pose: Pose| Pose::new(pose.x, pose.y, pose.heading + std::f64::consts::TAU);
    let scaled = PairTrajectory {
        left: vec![small.start.left, between, turned(small.end.left)],
        right: vec![small.start.right, between, between],
        step_time: 0.25,
    };
    let back = scales.trajectory(&scene, &scaled);
    assert_eq!(back.left[0], scene.start.left);
    assert_eq!(
        back.left[2],
        turned(scene.end.left),
        "the heading goes on continuously"
    );
    assert_eq!(back.left[1], scales.pose(between));
    assert_eq!(back.right[2], scales.pose(between), "it ends elsewhere");
    assert_eq!(back.step_time, 0.25);
    let again = scales.scaled_trajectory(&back);
    let off = again.left[1].position().distance(between.position());
    assert!(off < 1e-13, "{off}");
    assert_eq!(
        scales.trajectory(&scene, &PairTrajectory::default()),
        PairTrajectory::default()
    );
    let circle = scales.circle(&Circle {
        center: Point::new(0.24, 0.48),
        radius: 0.12,
        objects: vec![3],
    });
    assert!((circle.radius - 0.385).abs() < 1e-15 && circle.objects == [3]);
    assert!((circle.center.y - 1.54).abs() < 1e-15);
    assert!((scales.meters(scales.scaled(2.0)) - 2.0).abs() < 1e-13);
}

#[test]
fn defaults_follow_from_the_size_of_the_robot() {
    let robot = |radius: f64, v_max: f64| Robot {
        radius,
        v_max,
        ..Robot::default()
    };
    for radius in [0.17, 0.22, 0.24, 0.3, 0.339] {
        let robot = robot(radius, 0.26);
        let size = RobotSize::of(&robot);
        assert_eq!(size.planner(&robot), PlannerParameters::default());
        assert_eq!(size.physics(), PhysicsParameters::default());
    }
    let tractor = robot(0.96, 2.6);
    let size = RobotSize::of(&tractor);
    assert_eq!(size.times, 4.0);
    let (planner, physics) = (size.planner(&tractor), size.physics());
    assert_eq!(
        (planner.max_step, planner.clearance, planner.half_separation),
        (0.2, 0.2, 1.2)
    );
    assert_eq!(
        (planner.max_turn, planner.waypoints, planner.kd1),
        (0.1, None, 20.0)
    );
    assert_eq!(
        (planner.t1, planner.b1, planner.kd2, planner.k2),
        (75.0, 110.0 / 16.0, 15.0 / 16.0, 16e7)
    );
    assert!((planner.cruise - 2.2).abs() < 1e-12);
    assert_eq!((physics.gravity, physics.robot_mass), (9.81, 1.43 * 64.0));
    assert_eq!(
        (physics.robot_inertia, physics.max_torque),
        (0.0146 * 1024.0, 3.0 * 256.0)
    );
    assert_eq!(
        (physics.net_mass, physics.net_link, physics.tension_limit),
        (0.32, 0.4, 640.0)
    );
    assert_eq!(physics.hinge_damping, 1e-3 * 512.0);
    assert_eq!((size.length(0.05), size.mass(0.025)), (0.2, 1.6));
    for (radius, times) in [
        (0.16, 0.5),
        (0.35, 2.0),
        (240.0, 1024.0),
        (0.0048, 1.0 / 64.0),
        (0.0, 1.0),
    ] {
        assert_eq!(RobotSize::of(&robot(radius, 0.26)).times, times, "{radius}");
    }
}
