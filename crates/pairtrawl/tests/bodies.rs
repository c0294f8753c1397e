//! Robots that are contained in circles: how a scene says so, what is refused, and plans for them.

use pairtrawl::files::{LoadedScene, parse_scene, read_scene};
use pairtrawl::geometry::{Point, Pose};
use pairtrawl::model::{
    Body, BodyCircle, ClaimId, Obstacle, PairTrajectory, PhysicsParameters, Preset, Robot, Scene,
    Warning,
};
use pairtrawl::{PlanOptions, Planned, RehearsalMode, plan};

const HALL: &str = r#"format = "pairtrawl-scene/1"
[area]
min = [0, 0]
max = [6, 4]
[[objects]]
position = [3.0, 2.0]
radius = 0.03
[start]
left = [1.0, 2.5]
right = [1.0, 1.5]
heading = 0
[end]
left = [5.0, 2.5]
right = [5.0, 1.5]
heading = 0
"#;

fn hall(robot: &str) -> LoadedScene {
    parse_scene(&format!("{HALL}[robot]\n{robot}\n"), "hall.toml").unwrap()
}

fn refusal(text: &str) -> String {
    let text = parse_scene(text, "hall.toml").unwrap_err().to_string();
    assert!(!text.contains('\n'), "{text}");
    text
}

fn circle(x: f64, y: f64, radius: f64) -> BodyCircle {
    BodyCircle {
        center: Point::new(x, y),
        radius,
    }
}

fn planned(scene: &Scene, loaded: &LoadedScene, options: &PlanOptions) -> Planned {
    plan(scene, &loaded.reference, options, &mut ()).expect("there is a plan")
}

fn quick() -> PlanOptions {
    PlanOptions {
        rehearsal: RehearsalMode::Skip,
        explore: false,
        ..PlanOptions::default()
    }
}

fn witness(name: &str) -> LoadedScene {
    let path = format!(
        "{}/../../scenes/{name}/scene.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    read_scene(path.as_ref()).expect("the scene is good")
}

#[test]
fn a_body_is_read_and_tells_the_size() {
    let loaded = hall("body = [[0.1, 0, 0.2], [-0.15, 0.01, 0.18]]\nhitch = 0.3");
    let robot = loaded.scene.robot;
    let circles = [circle(0.1, 0.0, 0.2), circle(-0.15, 0.01, 0.18)];
    assert_eq!(robot.circles().circles(), circles);
    assert_eq!(robot.radius, robot.circles().reach());
    assert_eq!(robot.hitch, 0.3);
    assert!(loaded.warnings.is_empty());
}

#[test]
fn without_a_body_a_robot_is_its_disc_and_its_scene_has_the_same_hash() {
    let robot = hall("radius = 0.2").scene.robot;
    assert_eq!(robot.body, None);
    assert_eq!(robot.circles().circles(), [circle(0.0, 0.0, 0.2)]);
    assert_eq!(robot.circles().inner_radius(), 0.2);
    // As it was before robots had bodies.
    assert_eq!(
        parse_scene(HALL, "hall.toml")
            .unwrap()
            .reference
            .content_sha256,
        hall("radius = 0.24").reference.content_sha256
    );
}

#[test]
fn presets_set_what_is_not_given() {
    let waffle = hall("preset = \"waffle-pi\"").scene;
    assert_eq!(waffle.robot.radius, Robot::default().radius);
    assert_eq!(
        waffle.robot.circles().circles(),
        [circle(-0.064, 0.0, 0.19)]
    );
    assert_eq!(waffle.physics, PhysicsParameters::default());

    let text =
        format!("{HALL}[robot]\npreset = \"burger\"\nv_max = 0.1\n[physics]\nrobot_mass = 2\n");
    let burger = parse_scene(&text, "hall.toml").unwrap().scene;
    let expected = Robot {
        v_max: 0.1,
        ..Preset::Burger.robot()
    };
    assert_eq!(burger.robot, expected);
    let expected = PhysicsParameters {
        robot_mass: 2.0,
        ..Preset::Burger.physics()
    };
    assert_eq!(burger.physics, expected);

    let own = hall("preset = \"waffle-pi\"\nbody = [[0, 0, 0.3]]").scene;
    assert_eq!(own.robot.circles().circles(), [circle(0.0, 0.0, 0.3)]);
}

#[test]
fn a_radius_beside_a_body_is_said_to_be_unused() {
    let unused = |instead| Warning::Unused {
        key: "robot.radius",
        instead,
    };
    let with_body = hall("radius = 0.5\nbody = [[0, 0, 0.2]]");
    assert_eq!(with_body.scene.robot.radius, 0.2);
    assert_eq!(with_body.warnings, [unused("robot.body")]);
    let with_preset = hall("radius = 0.5\npreset = \"waffle-pi\"");
    assert_eq!(with_preset.scene.robot.radius, 0.24);
    assert_eq!(with_preset.warnings, [unused("the body of robot.preset")]);
}

#[test]
fn bodies_that_make_no_machine_are_refused() {
    for (robot, words) in [
        (
            "body = []",
            "robot.body is an array of 0, it must be an array of 1 to 16",
        ),
        (
            "body = [[0, 0]]",
            "robot.body[0] is an array of 2, it must be a circle, [x, y, radius]",
        ),
        (
            "body = [0, 0, 0.2]",
            "robot.body[0] is 0, it must be a circle, [x, y, radius]",
        ),
        ("body = 0.2", "robot.body is 0.2, it must be an array"),
        (
            "body = [[0, 0, 0]]",
            "robot.body[0][2] is 0, it must be a number, above zero",
        ),
        ("body = [[0, 0, -0.1]]", "robot.body[0][2] is -0.1"),
        ("body = [[0, 0, nan]]", "robot.body[0][2] is nan"),
        ("body = [[\"x\", 0, 1]]", "robot.body[0][0] is \"x\""),
        (
            "body = [[0.5, 0, 0.2]]",
            "no circle contains the reference point",
        ),
        (
            "body = [[0, 0, 0.2], [1, 0, 0.2]]",
            "circle 1 is not joined",
        ),
        (
            "preset = \"waffle\"",
            "robot.preset is \"waffle\", it must be \"waffle-pi\" or \"burger\"",
        ),
        ("preset = 3", "robot.preset is 3, it must be a string"),
        (
            "bodies = []",
            "unknown key robot.bodies: did you mean robot.body?",
        ),
    ] {
        let text = refusal(&format!("{HALL}[robot]\n{robot}\n"));
        assert!(text.contains(words), "{robot}: {text}");
    }
    let many = vec!["[0, 0, 0.1]"; 17].join(", ");
    let text = refusal(&format!("{HALL}[robot]\nbody = [{many}]\n"));
    assert!(text.contains("an array of 17"), "{text}");
}

#[test]
fn ends_are_judged_by_the_body() {
    let waffle = "[robot]\npreset = \"waffle-pi\"\n";
    // Two discs of 0.24 m overlap, two Waffles do not.
    let close = HALL.replace("left = [1.0, 2.5]", "left = [1.0, 1.92]");
    assert!(refusal(&close).contains("two robots of radius 0.24 m"));
    assert!(parse_scene(&format!("{close}{waffle}"), "hall.toml").is_ok());
    let closer = HALL.replace("left = [1.0, 2.5]", "left = [1.0, 1.85]");
    let text = refusal(&format!("{closer}{waffle}"));
    assert!(
        text.contains("circles of robot.body overlap by 0.0300 m"),
        "{text}"
    );
    // Ahead of the axle the Waffle is short, behind it is long.
    for (x, fits) in [(1.13_f64, true), (1.12, false), (0.75, false), (0.74, true)] {
        let far = if x < 1.0 { x - 0.1 } else { x + 0.1 };
        let wall = format!(
            "[[obstacles]]\nbox = [{}, 2.4, {}, 2.6]\n",
            x.min(far),
            x.max(far)
        );
        let scene = parse_scene(&format!("{HALL}{wall}{waffle}"), "hall.toml");
        let gap = (x - 0.936_f64).abs() - 0.19;
        assert_eq!(scene.is_ok(), gap > 0.0, "{x}");
        assert_eq!(scene.is_ok(), fits, "{x}");
        if let Err(error) = scene {
            assert!(
                error.to_string().contains("circle 0 of its body"),
                "{error}"
            );
        }
    }
}

#[test]
fn a_body_of_one_disc_is_planned_as_the_disc() {
    let loaded = witness("witness-9");
    let body = Body::circle(BodyCircle::around_reference(loaded.scene.robot.radius));
    let mut with_body = loaded.scene.clone();
    with_body.robot = with_body.robot.with_body(body);
    let disc = planned(&loaded.scene, &loaded, &quick()).plan;
    let same = planned(&with_body, &loaded, &quick()).plan;
    assert!(same.certificate.is_valid());
    let claims = |plan: &pairtrawl::model::Plan| plan.certificate.claims.len();
    assert_eq!(claims(&same), claims(&disc) + 1);
    assert!((same.cost.total() - disc.cost.total()).abs() < 1e-3 * disc.cost.total());
}

/// The least gap of a circle of either robot to a box, among dense samples.
fn least_gap(scene: &Scene, trajectory: &PairTrajectory) -> f64 {
    let mut least = f64::INFINITY;
    let boxes = scene.obstacles.iter().filter_map(|o| match o {
        Obstacle::Box { min, max } => Some((*min, *max)),
        _ => None,
    });
    let boxes: Vec<_> = boxes.collect();
    for poses in [&trajectory.left, &trajectory.right] {
        for pair in poses.windows(2) {
            for k in 0..16 {
                let pose: Pose = pair[0].lerp(pair[1], f64::from(k) / 16.0);
                let (forward, body) = (pose.forward(), scene.robot.circles());
                for c in body.circles() {
                    let center = pose.position()
                        + forward * c.center.x
                        + Point::new(-forward.y, forward.x) * c.center.y;
                    for (min, max) in &boxes {
                        let dx = (min.x - center.x).max(center.x - max.x).max(0.0);
                        let dy = (min.y - center.y).max(center.y - max.y).max(0.0);
                        least = least.min(Point::new(dx, dy).norm() - c.radius);
                    }
                }
            }
        }
    }
    least
}

#[test]
fn boats_are_planned_around_corners() {
    // Longer than wide, as a boat is; the axle is in the middle.
    let body = "body = [[0.25, 0, 0.12], [0, 0, 0.15], [-0.25, 0, 0.12]]\nhitch = 0.38";
    let walls =
        "[[obstacles]]\nbox = [2.0, 3.2, 2.2, 4.0]\n[[obstacles]]\nbox = [3.6, 0.0, 3.8, 0.95]\n";
    let text = format!("{HALL}{walls}[robot]\n{body}\n");
    let loaded = parse_scene(&text, "boats.toml").unwrap();
    let made = planned(
        &loaded.scene,
        &loaded,
        &PlanOptions {
            rehearsal: RehearsalMode::Skip,
            ..PlanOptions::default()
        },
    );
    let certificate = &made.plan.certificate;
    assert!(certificate.is_valid());
    let claim = |id| certificate.claims.iter().find(|c| c.id == id).unwrap();
    assert!(claim(ClaimId::RobotsApart).holds);
    let sampled = least_gap(&loaded.scene, &made.plan.trajectory);
    let margin = claim(ClaimId::RobotClearance).margin;
    assert!(
        margin <= sampled + 1e-9 && margin > sampled - 5e-3,
        "{margin} {sampled}"
    );
}
