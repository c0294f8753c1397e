//! What a rehearsal reports.

#[path = "../../simulation/tests/scenes/mod.rs"]
mod scenes;

use pairtrawl_execution::rehearse;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    OccupancyMap, Rehearsal, RehearsalEventKind as Kind, RehearsalRecord, Scene, Side, Warning,
};
use pairtrawl_reference::Reference;
use pairtrawl_simulation::{Options, Simulation};
use scenes::{block, cube, empty, straight};

fn drive(scene: &Scene, net_length: f64, distance: f64) -> RehearsalRecord {
    rehearse_with(scene, net_length, distance, &Options::default())
}

fn rehearse_with(
    scene: &Scene,
    net_length: f64,
    distance: f64,
    options: &Options,
) -> RehearsalRecord {
    let reference = Reference::of_scene(scene, &straight(scene, distance)).unwrap();
    rehearse(scene, net_length, &reference, options).unwrap()
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
    let again = rehearse_with(&scene, 1.5, 2.5, &fine);
    let ends = |r: &RehearsalRecord| r.frames[r.frames.len() - 1].objects.clone();
    for (a, b) in ends(&record).iter().zip(ends(&again)) {
        assert!(
            a.position().distance(b.position()) < 0.01,
            "{a:?} against {b:?}"
        );
    }
}
