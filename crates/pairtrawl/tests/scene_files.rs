//! Scene files: what is read, and that bad ones are refused with a message that names the field and the bound.

use pairtrawl::files::{FileError, Problem, parse_scene, read_scene};
use pairtrawl_model::{Footprint, Leave, Obstacle, PhysicsParameters, PlannerParameters, Robot};
use std::path::{Path, PathBuf};

const HALL: &str = r#"format = "pairtrawl-scene/1"
name = "hall"
[area]
min = [0.0, 0.0]
max = [6.0, 5]
resolution = 0.05
[[obstacles]]
box = [2.0, 2.0, 3.0, 3.0]
[[obstacles]]
polygon = [[4.0, 4.0], [5.0, 4.0], [4.0, 4.9]]
[[obstacles]]
circle = [5.0, 1.0, 0.2]
[[objects]]
position = [1.5, 3.5]
size = [0.05, 0.06]
[[objects]]
position = [3.5, 1.5]
radius = 0.035
mass = 0.1
[start]
left = [0.7, 0.5]
right = [1.3, 0.5]
heading = 1.5
[end]
left = [4.7, 2.5]
right = [4.7, 1.9]
left_heading = 0.1
right_heading = -0.1
"#;

fn scenes_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

fn refusal(text: &str) -> FileError {
    parse_scene(text, "hall.toml").expect_err("must be refused")
}

/// The hall with a piece of text replaced; it must be there.
fn hall(from: &str, to: &str) -> String {
    assert!(HALL.contains(from), "{from}");
    HALL.replacen(from, to, 1)
}

#[test]
fn every_field_arrives() {
    let loaded = parse_scene(HALL, "hall.toml").unwrap();
    let scene = &loaded.scene;
    assert_eq!(
        (scene.name.as_str(), loaded.reference.name.as_str()),
        ("hall", "hall")
    );
    assert_eq!(
        (
            scene.area.min.x,
            scene.area.max.x,
            scene.area.max.y,
            scene.area.resolution
        ),
        (0.0, 6.0, 5.0, 0.05)
    );
    assert!(
        matches!(&scene.obstacles[0], Obstacle::Box { min, max } if min.x == 2.0 && max.y == 3.0)
    );
    assert!(matches!(&scene.obstacles[1], Obstacle::Polygon(v) if v.len() == 3 && v[2].y == 4.9));
    assert!(
        matches!(&scene.obstacles[2], Obstacle::Circle { center, radius } if center.x == 5.0 && *radius == 0.2)
    );
    assert_eq!(scene.objects[0].footprint, Footprint::Box(0.05, 0.06));
    assert_eq!(
        (scene.objects[1].footprint, scene.objects[1].mass),
        (Footprint::Disc(0.035), 0.1)
    );
    assert_eq!(
        (scene.start.left.heading, scene.start.right.heading),
        (1.5, 1.5)
    );
    assert_eq!(
        (
            scene.end.left.heading,
            scene.end.right.heading,
            scene.end.right.y
        ),
        (0.1, -0.1, 1.9)
    );
    assert_eq!(
        (scene.robot, scene.planner, scene.physics),
        Default::default()
    );
    assert_eq!((scene.net.length, &scene.net.start), (None, &None));
    assert!(loaded.warnings.is_empty());
    assert_eq!(loaded.reference.sha256.len(), 64);
}

#[test]
fn every_parameter_can_be_set() {
    let text = format!(
        "{HALL}[robot]\nradius = 0.2\nhitch = 0\nv_max = 0.3\nomega_max = 2.0\nhalf_track = 0.1\n\
         [net]\nlength = 1.5\nstart = [[0.7, 0.5], [1.0, 0.2], [1.3, 0.5]]\n\
         [planner]\nmax_step = 0.04\nmax_turn = 0.2\nmax_skew = 0.9\nclearance = 0\ncruise = 0.1\nhalf_separation = 0.4\n\
         circle_margin = 0.3\nwaypoints = 99\nalternations = 3\nmin_ratio = 0.2\nrest_ratio = 0.5\nk1 = 1\nk2 = 2\nk3 = 3\n\
         t1 = 4\nt2 = 5\nkd1 = 6\nkd2 = 7\nb1 = 8\nb2 = 9\nb3 = 10\na1 = 11\na2 = 12\na3 = 13\na4 = 14\nexpansion_per = \"meter\"\nleave = \"unreachable\"\n\
         [physics]\ngravity = 1.6\nrobot_mass = 2\nrobot_inertia = 0.1\ncenter_of_mass = 0.01\nwheel_radius = 0.04\nmax_torque = 2\n\
         wheel_friction = 0.7\nnet_mass = 0.03\nnet_link = 0.2\nnet_thickness = 0.02\nnet_height = 0.1\nhinge_damping = 0.002\n\
         net_friction = 0.3\nobject_friction = 0.4\ncontact_friction = 0.5\ntension_limit = 20\n"
    );
    let scene = parse_scene(&text, "hall.toml").unwrap().scene;
    assert_eq!(
        scene.robot,
        Robot {
            radius: 0.2,
            hitch: 0.0,
            v_max: 0.3,
            omega_max: 2.0,
            half_track: 0.1,
            body: None,
        }
    );
    assert_eq!(
        (scene.net.length, scene.net.start.unwrap().len()),
        (Some(1.5), 3)
    );
    let planner = PlannerParameters {
        max_step: 0.04,
        max_turn: 0.2,
        max_skew: 0.9,
        clearance: 0.0,
        cruise: 0.1,
        half_separation: 0.4,
        circle_margin: Some(0.3),
        waypoints: Some(99),
        alternations: 3,
        min_ratio: 0.2,
        rest_ratio: 0.5,
        k1: 1.0,
        k2: 2.0,
        k3: 3.0,
        t1: 4.0,
        t2: 5.0,
        kd1: 6.0,
        kd2: 7.0,
        b1: 8.0,
        b2: 9.0,
        b3: 10.0,
        a1: 11.0,
        a2: 12.0,
        a3: 13.0,
        a4: 14.0,
        expansion_per: pairtrawl::model::ExpansionPer::Meter,
        leave: Leave::Unreachable,
    };
    assert_eq!(scene.planner, planner);
    let physics = PhysicsParameters {
        gravity: 1.6,
        robot_mass: 2.0,
        robot_inertia: 0.1,
        center_of_mass: 0.01,
        wheel_radius: 0.04,
        max_torque: 2.0,
        wheel_friction: 0.7,
        net_mass: 0.03,
        net_link: 0.2,
        net_thickness: 0.02,
        net_height: 0.1,
        hinge_damping: 0.002,
        net_friction: 0.3,
        object_friction: 0.4,
        contact_friction: 0.5,
        tension_limit: 20.0,
    };
    assert_eq!(scene.physics, physics);
}

#[test]
fn unknown_keys_name_what_was_meant() {
    let cases = [
        (hall("[start]", "[strat]"), "strat: did you mean start?"),
        (
            hall("resolution", "resolutoin"),
            "area.resolutoin: did you mean area.resolution?",
        ),
        (
            hall("position", "pos"),
            "objects[0].pos: did you mean objects[0].position?",
        ),
        (
            hall("mass", "weight"),
            "objects[1].weight: known here are position, size, radius, mass",
        ),
        (
            hall("left_heading", "left_headign"),
            "end.left_headign: did you mean end.left_heading?",
        ),
        (
            format!("{HALL}[planner]\nmaxstep = 0.1\n"),
            "planner.maxstep: did you mean planner.max_step?",
        ),
        (
            format!("{HALL}[planner]\nMax_Step = 0.1\n"),
            "planner.Max_Step: did you mean planner.max_step?",
        ),
        (
            format!("{HALL}[robot]\nraduis = 0.1\n"),
            "robot.raduis: did you mean robot.radius?",
        ),
        (
            format!("{HALL}[net]\nlenght = 2\n"),
            "net.lenght: did you mean net.length?",
        ),
        (
            format!("{HALL}[physics]\ngravitation = 2\n"),
            "physics.gravitation: did you mean physics.gravity?",
        ),
        (
            hall("box", "boxes"),
            "obstacles[0].boxes: did you mean obstacles[0].box?",
        ),
    ];
    for (text, expected) in cases {
        let error = refusal(&text);
        assert!(
            error
                .to_string()
                .contains(&format!("unknown key {expected}")),
            "{error}"
        );
        assert!(!error.is_from_system());
    }
}

#[test]
fn messages_name_line_field_value_and_bound() {
    let error = refusal(&hall("size = [0.05, 0.06]", "size = [0.05, -0.06]"));
    assert_eq!(
        error.to_string(),
        "hall.toml:15: objects[0].size[1] is -0.06, it must be a number, above zero and at most 1e6"
    );
}

#[test]
fn bad_scenes_are_refused() {
    let start = "left = [0.7, 0.5]\nright = [1.3, 0.5]\nheading = 1.5";
    let cases = [
        (
            hall("scene/1", "scene/2"),
            "format is \"pairtrawl-scene/2\"",
        ),
        (
            hall("format = \"pairtrawl-scene/1\"", ""),
            "format is missing",
        ),
        (
            hall("format = \"pairtrawl-scene/1\"", "format = 1"),
            "format is 1",
        ),
        (
            hall("min = [0.0, 0.0]", "min = [nan, 0.0]"),
            "area.min[0] is nan",
        ),
        (
            hall("max = [6.0, 5]", "max = [inf, 5]"),
            "area.max[0] is inf",
        ),
        (
            hall("max = [6.0, 5]", "max = [1e308, 1e308]"),
            "area.max[0] is 1e308",
        ),
        (hall("max = [6.0, 5]", "max = [1e999, 5]"), "1e999"),
        (hall("max = [6.0, 5]", "max = [9e5, 9e5]"), "3.240e14 cells"),
        (hall("max = [6.0, 5]", "max = [-1.0, 5]"), "area.max"),
        (
            hall("max = [6.0, 5]", "max = [6.0]"),
            "an array of 2 numbers",
        ),
        (hall("min = [0.0, 0.0]\n", ""), "area.min is missing"),
        (
            hall("resolution = 0.05", "resolution = 0"),
            "area.resolution is 0",
        ),
        (
            hall("resolution = 0.05", "resolution = -1"),
            "area.resolution is -1",
        ),
        (hall("resolution = 0.05", "resolution = 1e-9"), "cells"),
        (
            hall("resolution = 0.05", "unknown = \"free\""),
            "only a map has unknown cells",
        ),
        (
            hall("[2.0, 2.0, 3.0, 3.0]", "[3.0, 2.0, 2.0, 3.0]"),
            "xmin < xmax",
        ),
        (
            hall("[2.0, 2.0, 3.0, 3.0]", "[2.0, 2.0, 3.0, 2.0]"),
            "ymin < ymax",
        ),
        (
            hall("[5.0, 1.0, 0.2]", "[5.0, 1.0, -0.2]"),
            "obstacles[2].circle[2] is -0.2",
        ),
        (
            hall(
                "[[4.0, 4.0], [5.0, 4.0], [4.0, 4.9]]",
                "[[4, 4], [5, 5], [5, 4], [4, 5]]",
            ),
            "edges 0 and 2 meet",
        ),
        (
            hall(
                "[[4.0, 4.0], [5.0, 4.0], [4.0, 4.9]]",
                "[[4, 4], [5, 4], [4.5, 4]]",
            ),
            "touches itself",
        ),
        (
            hall("[[4.0, 4.0], [5.0, 4.0], [4.0, 4.9]]", "[[4, 4], [5, 4]]"),
            "an array of 3 to",
        ),
        (
            hall(
                "[[4.0, 4.0], [5.0, 4.0], [4.0, 4.9]]",
                "[[4, 4], [4, 4], [5, 4]]",
            ),
            "are the same point",
        ),
        (
            hall("box = [2.0, 2.0, 3.0, 3.0]", ""),
            "an obstacle is one of",
        ),
        (
            hall(
                "circle = [5.0, 1.0, 0.2]",
                "circle = [5.0, 1.0, 0.2]\nbox = [1, 2, 3, 4]",
            ),
            "exactly one of",
        ),
        (
            hall("radius = 0.035", "radius = 0.035\nsize = [0.1, 0.1]"),
            "not both",
        ),
        (hall("radius = 0.035", ""), "objects[1].size is missing"),
        (hall("mass = 0.1", "mass = 0"), "objects[1].mass is 0"),
        (
            hall("position = [1.5, 3.5]", "position = [2.5, 2.5]"),
            "overlaps obstacles[0]",
        ),
        (
            hall("position = [1.5, 3.5]", "position = [1.99, 2.5]"),
            "overlaps obstacles[0]",
        ),
        (
            hall("position = [1.5, 3.5]", "position = [4.2, 4.2]"),
            "overlaps obstacles[1]",
        ),
        (
            hall("position = [1.5, 3.5]", "position = [-1.5, 3.5]"),
            "outside of the area",
        ),
        (
            hall(
                start,
                "left = [1.0, 0.5]\nright = [1.3, 0.5]\nheading = 1.5",
            ),
            "0.3000 m apart",
        ),
        (
            hall(
                start,
                "left = [0.7, 0.5]\nright = [2.5, 1.9]\nheading = 1.5",
            ),
            "start.right: the robot at (2.5, 1.9) collides with obstacles[0]",
        ),
        (
            hall(
                start,
                "left = [-0.1, 0.5]\nright = [1.3, 0.5]\nheading = 1.5",
            ),
            "outside of the area",
        ),
        (
            hall(
                start,
                "left = [0.7, 0.5]\nright = [1.5, 3.4]\nheading = 1.5",
            ),
            "stands on objects[0]",
        ),
        (hall("heading = 1.5\n", ""), "start.heading is missing"),
        (
            hall("heading = 1.5\n", "heading = 1.5\nleft_heading = 1\n"),
            "start.heading",
        ),
        (
            hall("right_heading = -0.1\n", ""),
            "end.right_heading is missing",
        ),
        (
            hall("heading = 1.5\n", "heading = nan\n"),
            "start.heading is nan",
        ),
        (
            hall("left = [4.7, 2.5]", "left = [4.7, 2.3]"),
            "0.4000 m apart",
        ),
        (format!("{HALL}[net]\nlength = 0\n"), "net.length is 0"),
        (format!("{HALL}[net]\nlength = -2\n"), "net.length is -2"),
        (
            format!("{HALL}[net]\nlength = \"2\"\n"),
            "net.length is \"2\"",
        ),
        (
            format!("{HALL}[net]\nstart = [[9, 9], [1, 1]]\n"),
            "from the hitch at",
        ),
        (format!("{HALL}[robot]\nradius = 0\n"), "robot.radius is 0"),
        (
            format!("{HALL}[robot]\nradius = 10\n"),
            "collides with obstacles[0]",
        ),
        (
            format!("{HALL}[planner]\nwaypoints = 2\n"),
            "a whole number from 3",
        ),
        (
            format!("{HALL}[planner]\nwaypoints = 3.5\n"),
            "planner.waypoints is 3.5",
        ),
        (
            format!("{HALL}[planner]\nwaypoints = 99999999999999999999\n"),
            "99999999999999999999",
        ),
        (
            format!("{HALL}[planner]\nmin_ratio = 0.7\n"),
            "planner.min_ratio is 0.7, it must be below rest_ratio",
        ),
        (
            format!("{HALL}[planner]\nrest_ratio = 1\n"),
            "planner.rest_ratio is 1, it must be below 1",
        ),
        (
            format!("{HALL}[planner]\nmax_turn = 4\n"),
            "planner.max_turn is 4",
        ),
        (hall("[area]", "area = 1\n[other]"), "unknown key other"),
        (hall("[[objects]]", "[[objects]"), "hall.toml:13"),
        (
            format!("objects = 3\n{}", &HALL[..HALL.find("[[obj").unwrap()]),
            "objects is 3",
        ),
        (
            hall("name = \"hall\"", "name = \"hall\"\nname = \"again\""),
            "duplicate key",
        ),
        (
            hall("resolution = 0.05", "map = \"hall.yaml\""),
            "area.min: stands beside map",
        ),
    ];
    for (text, expected) in cases {
        let error = refusal(&text);
        assert!(
            error.to_string().contains(expected),
            "expected {expected:?} in {error}"
        );
        assert!(!error.is_from_system(), "{error}");
        assert!(!error.to_string().contains('\n'), "one line: {error}");
    }
}

#[test]
fn an_embedded_scene_has_no_map_file() {
    let text = hall(
        "min = [0.0, 0.0]\nmax = [6.0, 5]\nresolution = 0.05",
        "map = \"hall.yaml\"",
    );
    assert!(matches!(refusal(&text).problem, Problem::Missing));
}

#[test]
fn a_net_shorter_than_the_start_is_no_bad_input() {
    assert!(parse_scene(&format!("{HALL}[net]\nlength = 0.5\n"), "hall.toml").is_ok());
}

#[test]
fn swapped_sides_are_refused() {
    for (key, from, to) in [
        (
            "start",
            "left = [0.7, 0.5]\nright = [1.3, 0.5]",
            "left = [1.3, 0.5]\nright = [0.7, 0.5]",
        ),
        ("start", "heading = 1.5", "heading = -1.5"),
    ] {
        let message = refusal(&hall(from, to)).to_string();
        let expected = format!("{key}.left lies to the right of {key}.right");
        assert!(
            message.contains(&expected) && message.contains("swapped?"),
            "{message}"
        );
    }
}

#[test]
fn degrees_are_refused() {
    let message = refusal(&hall("heading = 1.5", "heading = 90")).to_string();
    assert!(
        message.contains("start.heading is 90, it must be a number, an angle between -2 pi and 2 pi (rad): degrees?"),
        "{message}"
    );
    assert!(parse_scene(&hall("heading = 1.5", "heading = -4.7"), "hall.toml").is_ok());
}

#[test]
fn a_slow_cruise_speed_is_warned_about() {
    let warnings = |cruise: f64| {
        let text = format!("{HALL}[planner]\ncruise = {cruise}\n");
        parse_scene(&text, "hall.toml").unwrap().warnings
    };
    assert!(warnings(0.06).is_empty());
    let slow: Vec<_> = warnings(0.02).iter().map(ToString::to_string).collect();
    assert!(
        slow.len() == 1 && slow[0].contains("planner.cruise") && slow[0].contains("13 times"),
        "{slow:?}"
    );
}

/// The hall with all its lengths `factor` times as large and a robot to suit.
fn large_hall(factor: f64) -> String {
    format!(
        "format = \"pairtrawl-scene/1\"\n[area]\nmin = [0, 0]\nmax = [{}, {}]\n\
         [start]\nleft = [{}, {}]\nright = [{}, {}]\nheading = 1.5\n\
         [end]\nleft = [{}, {}]\nright = [{}, {}]\nheading = 1.5\n\
         [[objects]]\nposition = [{}, {}]\nradius = {}\n[robot]\nradius = {}\nv_max = {}\n",
        6.0 * factor,
        5.0 * factor,
        0.7 * factor,
        0.5 * factor,
        1.3 * factor,
        0.5 * factor,
        2.7 * factor,
        4.0 * factor,
        3.3 * factor,
        4.0 * factor,
        2.0 * factor,
        2.0 * factor,
        0.035 * factor,
        0.24 * factor,
        0.26 * factor,
    )
}

#[test]
fn defaults_follow_from_the_robot() {
    let scene = |factor: f64| {
        let text = large_hall(factor);
        parse_scene(&text, "hall.toml")
            .unwrap_or_else(|error| panic!("{error}"))
            .scene
    };
    let paper = scene(1.0);
    assert_eq!(paper.planner, PlannerParameters::default());
    assert_eq!(paper.physics, PhysicsParameters::default());
    assert_eq!(
        (paper.area.resolution, paper.objects[0].mass),
        (0.05, 0.025)
    );
    let large = scene(4.0);
    assert_eq!((large.planner.max_step, large.planner.t1), (0.2, 75.0));
    assert!((large.planner.cruise - 0.88).abs() < 1e-12);
    assert_eq!((large.area.resolution, large.objects[0].mass), (0.2, 1.6));
    assert_eq!(large.physics.robot_mass, 1.43 * 64.0);
    for factor in [0.02, 0.1, 10.0, 100.0, 1000.0] {
        let scene = scene(factor);
        let steps = scene.planner.max_step / scene.robot.radius;
        assert!(
            (0.7..1.5).contains(&(steps / (0.05 / 0.24))),
            "{factor}: {steps}"
        );
    }
}

#[test]
fn a_step_is_no_leap() {
    let text = format!("{}[planner]\nmax_step = 51\n", large_hall(1000.0));
    assert_eq!(
        parse_scene(&text, "hall.toml")
            .unwrap()
            .scene
            .planner
            .max_step,
        51.0
    );
    let text = format!("{HALL}[planner]\nmax_step = 1.5\n");
    assert!(
        refusal(&text)
            .to_string()
            .contains("planner.max_step is 1.5")
    );
}

#[test]
fn hundred_thousand_brackets_do_not_overflow_the_stack() {
    for (open, close) in [("[", "]"), ("{a=", "}")] {
        let text = format!("format = {}{}", open.repeat(100_000), close.repeat(100_000));
        assert!(!refusal(&text).is_from_system());
    }
    assert!(!refusal(&format!("{}format = 1", "a.".repeat(100_000))).is_from_system());
}

#[test]
fn every_scene_of_the_library_is_read() {
    let mut count = 0;
    for entry in std::fs::read_dir(scenes_folder()).unwrap() {
        let path = entry.unwrap().path().join("scene.toml");
        if path.exists() {
            let loaded = read_scene(&path).unwrap_or_else(|e| panic!("{e}"));
            assert!(!loaded.scene.objects.is_empty(), "{}", path.display());
            assert!(loaded.warnings.is_empty(), "{:?}", loaded.warnings);
            count += 1;
        }
    }
    assert!(count >= 12, "{count} scenes");
}

#[test]
fn the_hash_is_that_of_the_file() {
    let path = scenes_folder().join("witness-1/scene.toml");
    let bytes = std::fs::read(&path).unwrap();
    assert_eq!(
        read_scene(&path).unwrap().reference.sha256,
        pairtrawl::files::sha256_hex(&[&bytes])
    );
}
