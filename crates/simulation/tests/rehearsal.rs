//! What a rehearsal reports, and how the net lies at the start.

mod scenes;

use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    OccupancyMap, Rehearsal, RehearsalEventKind as Kind, RehearsalRecord, Scene, Side, Warning,
};
use pairtrawl_simulation::{Options, Simulation, SimulationError, rehearse};
use scenes::{block, cube, empty, straight};
use std::f64::consts::FRAC_PI_2;

fn drive(scene: &Scene, net_length: f64, distance: f64) -> RehearsalRecord {
    rehearse(
        scene,
        net_length,
        &straight(scene, distance),
        &Options::default(),
    )
    .unwrap()
}

fn has(record: &RehearsalRecord, wanted: Kind) -> bool {
    record.events.iter().any(|e| e.kind == wanted)
}

#[test]
fn a_free_drive_passes_and_brings_everything_home() {
    let mut scene = empty();
    scene.objects = vec![cube(-0.05, 0.5), cube(0.08, 0.9), cube(0.0, -0.4)];
    let record = drive(&scene, 1.5, 2.0);
    assert_eq!(record.verdict, Rehearsal::Passed, "{:?}", record.events);
    assert_eq!(record.gathered, [true; 3]);
    assert!(record.events.is_empty());
    assert!(
        record.max_deviation.iter().all(|d| *d < 5e-3),
        "{:?}",
        record.max_deviation
    );
    assert!(
        record.max_tension.iter().all(|t| (0.05..2.0).contains(t)),
        "{:?}",
        record.max_tension
    );
    let times: Vec<f64> = record.frames.iter().map(|f| f.time).collect();
    assert_eq!(times[0], 0.0);
    assert!((times[times.len() - 1] - record.duration).abs() < 1e-9);
    assert!(
        times
            .windows(2)
            .all(|t| t[1] > t[0] && t[1] - t[0] < 0.1 + 1e-9)
    );
    assert!(
        record
            .frames
            .iter()
            .all(|f| f.net.len() == 16 && f.objects.len() == 3)
    );
}

#[test]
fn an_object_that_is_left_behind_fails_the_rehearsal() {
    let mut scene = empty();
    scene.objects = vec![cube(0.0, 0.5), cube(2.0, 1.0)];
    let record = drive(&scene, 1.5, 2.0);
    assert_eq!(record.gathered, [true, false]);
    assert!(has(&record, Kind::ObjectNotGathered { object: 1 }));
    let Rehearsal::Failed { event, place, .. } = record.verdict else {
        panic!("{:?}", record.verdict)
    };
    assert!(event.contains("object 1"), "{event}");
    assert_eq!(place, Point::new(2.0, 1.0));
}

#[test]
fn a_net_on_a_post_is_a_touch_a_snag_and_a_held_robot() {
    let mut scene = empty();
    scene.obstacles.push(block(-0.05, -0.4, 0.05, -0.3));
    let record = drive(&scene, 1.6, 2.0);
    let touch = record
        .events
        .iter()
        .find(|e| e.kind == Kind::NetTouchesObstacle { obstacle: Some(0) });
    let touch = touch.expect("the net touches the post");
    assert!(
        touch.place.distance(Point::new(0.0, -0.35)) < 0.12,
        "{touch:?}"
    );
    assert!(
        has(&record, Kind::Snag { robot: Side::Left })
            && has(&record, Kind::Snag { robot: Side::Right })
    );
    assert!(has(&record, Kind::RobotCaught { robot: Side::Left }));
    assert!(record.events.windows(2).all(|e| e[0].time <= e[1].time));
    assert!(matches!(record.verdict, Rehearsal::Failed { .. }));
}

#[test]
fn a_robot_that_runs_into_an_object_or_a_wall_is_reported() {
    let mut scene = empty();
    scene.objects = vec![cube(0.32, 0.6)];
    let record = drive(&scene, 1.5, 1.0);
    assert!(
        has(
            &record,
            Kind::RobotTouchesObject {
                robot: Side::Right,
                object: 0
            }
        ),
        "{:?}",
        record.events
    );
    let mut scene = empty();
    scene.obstacles.push(block(-0.5, 0.6, -0.1, 0.8));
    let record = drive(&scene, 1.5, 1.0);
    let wall = Kind::RobotTouchesObstacle {
        robot: Side::Left,
        obstacle: Some(0),
    };
    assert!(has(&record, wall), "{:?}", record.events);
}

#[test]
fn blocked_cells_of_a_map_are_obstacles() {
    // 6 m x 6 m at 0.1 m around the origin, one row of blocked cells across the way.
    let blocked = (0..60 * 60)
        .map(|i| i / 60 == 38 && (20..40).contains(&(i % 60)))
        .collect();
    let mut scene = empty();
    scene.map = Some(OccupancyMap {
        origin: Pose::new(-3.0, -3.0, 0.0),
        resolution: 0.1,
        columns: 60,
        rows: 60,
        blocked,
    });
    let record = drive(&scene, 1.5, 1.5);
    assert!(
        has(
            &record,
            Kind::RobotTouchesObstacle {
                robot: Side::Left,
                obstacle: None
            }
        ),
        "{:?}",
        record.events
    );
    let stopped = record.frames[record.frames.len() - 1].robots.left;
    assert!((stopped.y - (0.8 - 0.069)).abs() < 0.02, "{stopped:?}");
}

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
fn the_net_is_folded_where_a_wall_is_in_its_way() {
    let mut scene = empty();
    scene.obstacles.push(block(-3.0, -1.5, 3.0, -0.65));
    let simulation = Simulation::new(&scene, 2.4, &Options::default()).unwrap();
    assert!(
        simulation.warnings().contains(&Warning::NetFolded),
        "{:?}",
        simulation.warnings()
    );
    let net = simulation.net();
    assert!(net.iter().all(|p| p.y > -0.645), "{net:?}");
    assert!(simulation.joint_gap() < 1e-9);
    // It comes out of its folds without touching the wall.
    let record = drive(&scene, 2.4, 2.0);
    assert_eq!(record.verdict, Rehearsal::Passed, "{:?}", record.events);
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
        matches!(error, Some(SimulationError::NetStart { side: "right", .. })),
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
    let error = rehearse(&scene, 1.5, &path, &Options::default()).unwrap_err();
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
fn objects_sleep_out_of_reach_and_end_where_finer_steps_put_them() {
    let mut scene = empty();
    scene.objects = (0..6)
        .map(|i| cube(0.03 * f64::from(i % 3) - 0.03, 0.5 + 0.3 * f64::from(i)))
        .collect();
    let simulation = Simulation::new(&scene, 1.5, &Options::default()).unwrap();
    assert_eq!(simulation.awake_objects(), 0);
    let record = drive(&scene, 1.5, 2.5);
    assert_eq!(record.gathered, [true; 6]);
    let fine = Options {
        time_step: 5e-4,
        ..Options::default()
    };
    let again = rehearse(&scene, 1.5, &straight(&scene, 2.5), &fine).unwrap();
    let ends = |r: &RehearsalRecord| r.frames[r.frames.len() - 1].objects.clone();
    for (a, b) in ends(&record).iter().zip(ends(&again)) {
        assert!(
            a.position().distance(b.position()) < 0.01,
            "{a:?} against {b:?}"
        );
    }
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
