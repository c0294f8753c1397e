//! A scene multiplied by any factor is planned the same, multiplied by it.

use pairtrawl::files::{LoadedScene, parse_scene, read_scene};
use pairtrawl::generate::{Kind, generate, scene_toml};
use pairtrawl::geometry::Point;
use pairtrawl::model::{
    Body, BodyCircle, PairTrajectory, Plan, Preset, RehearsalFrame, Robot, Units,
};
use pairtrawl::{PlanOptions, RehearsalMode, plan};

/// What lengths are multiplied by; from robots of 5 mm to robots of half a kilometer.
const FACTORS: [f64; 6] = [0.02, 0.1, 4.0, 10.0, 100.0, 1000.0];

fn scene(name: &str) -> LoadedScene {
    let path = format!(
        "{}/../../scenes/{name}/scene.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    read_scene(path.as_ref()).expect("the scene is good")
}

fn planned(loaded: &LoadedScene, factor: f64, options: &PlanOptions) -> Plan {
    // In units of 1 / factor m, every number is that of a scene `factor` times as large.
    let units = Units {
        length: 1.0 / factor,
        ..Units::SI
    };
    plan(
        &units.scene(&loaded.scene),
        &loaded.reference,
        options,
        &mut (),
    )
    .unwrap_or_else(|error| panic!("factor {factor}: {error}"))
    .plan
}

/// Greatest distance of the poses of both robots, m, and greatest difference of their headings, rad.
fn difference(a: &PairTrajectory, b: &PairTrajectory, factor: f64) -> (f64, f64) {
    assert_eq!(a.len(), b.len());
    let pairs = a
        .left
        .iter()
        .zip(&b.left)
        .chain(a.right.iter().zip(&b.right));
    pairs.fold((0.0, 0.0), |(far, turned), (a, b)| {
        (
            f64::max(far, (a.position() / factor).distance(b.position())),
            f64::max(turned, (a.heading - b.heading).abs()),
        )
    })
}

/// Plans a scene at every size, and compares with the plan of the scene as it is.
fn scales(loaded: &LoadedScene, options: &PlanOptions) {
    let options = PlanOptions {
        rehearsal: RehearsalMode::Skip,
        ..options.clone()
    };
    let as_it_is = planned(loaded, 1.0, &options);
    for factor in FACTORS {
        let plan = planned(loaded, factor, &options);
        let name = format!("{} times {factor}", loaded.scene.name);
        assert!(plan.certificate.is_valid(), "{name}");
        assert_eq!(
            plan.solver.iterations, as_it_is.solver.iterations,
            "{name}: iterations"
        );
        let (far, turned) = difference(&plan.trajectory, &as_it_is.trajectory, factor);
        assert!(far < 1e-6 && turned < 1e-6, "{name}: {far}, {turned} rad");
        let length = plan.net_length / factor - as_it_is.net_length;
        assert!(length.abs() < 1e-6, "{name}: net {length}");
        let ratio = plan.cost.total() / as_it_is.cost.total();
        assert!((ratio - 1.0).abs() < 1e-9, "{name}: cost {ratio}");
        assert_eq!(plan.order, as_it_is.order, "{name}");
        assert!((plan.trajectory.step_time / as_it_is.trajectory.step_time - 1.0).abs() < 1e-12);
    }
}

/// One start only.
fn one_start() -> PlanOptions {
    PlanOptions {
        explore: false,
        ..PlanOptions::default()
    }
}

#[test]
fn scenes_from_files_scale() {
    for name in ["witness-1", "witness-5", "paper-simulation"] {
        scales(&scene(name), &one_start());
    }
}

#[test]
fn maps_scale() {
    scales(&scene("turtlebot3-world"), &one_start());
}

#[test]
fn so_do_all_choices_between_starts() {
    for name in ["witness-9", "paper-experiment"] {
        scales(&scene(name), &PlanOptions::default());
    }
}

#[test]
fn generated_scenes_scale() {
    let generated = generate(Kind::Witness, 4, 8, 200).expect("a scene");
    let text = scene_toml(&generated.scene).expect("a scene that can be written");
    let loaded = parse_scene(&text, "generated").expect("a scene that can be read");
    scales(&loaded, &one_start());
}

#[test]
fn the_net_length_that_was_asked_for_comes_back() {
    let loaded = scene("witness-9");
    let units = Units {
        length: 1.0 / 7.3,
        ..Units::SI
    };
    let large = units.scene(&loaded.scene);
    let asked = 7.3 * 1.9;
    let options = PlanOptions {
        net_length: Some(pairtrawl::NetLength::Fixed(asked)),
        rehearsal: RehearsalMode::Skip,
        ..one_start()
    };
    let plan = plan(&large, &loaded.reference, &options, &mut ())
        .expect("a plan")
        .plan;
    assert_eq!(plan.net_length, asked);
    assert_eq!(plan.trajectory.left[0], large.start.left);
    let last = plan.trajectory.len() - 1;
    let end = plan.trajectory.right[last];
    assert_eq!(end.position(), large.end.right.position());
}

/// Times what everything else is multiplied where gravity stays: times by the root, masses by the cube.
fn under_gravity(factor: f64) -> Units {
    Units {
        length: 1.0 / factor,
        time: 1.0 / factor.sqrt(),
        mass: 1.0 / (factor * factor * factor),
    }
}

/// Greatest distance of the nets in two frames, m in the second.
fn net_difference(a: &RehearsalFrame, b: &RehearsalFrame, factor: f64) -> f64 {
    let pairs = a.net.iter().zip(&b.net);
    pairs
        .map(|(a, b)| (*a / factor).distance(*b))
        .fold(0.0, f64::max)
}

#[test]
fn rehearsals_scale() {
    let options = PlanOptions {
        rehearsal_rounds: 0,
        ..one_start()
    };
    for name in ["witness-9", "witness-7"] {
        let loaded = scene(name);
        let rehearsed = |factor: f64| {
            let scaled = under_gravity(factor).scene(&loaded.scene);
            plan(&scaled, &loaded.reference, &options, &mut ())
                .expect("a plan")
                .rehearsal
                .expect("a rehearsal")
        };
        let as_it_is = rehearsed(1.0);
        for factor in [0.02, 10.0, 1000.0] {
            let record = rehearsed(factor);
            let name = format!("{name} times {factor}");
            let verdict = std::mem::discriminant(&record.verdict);
            assert_eq!(verdict, std::mem::discriminant(&as_it_is.verdict), "{name}");
            assert_eq!(record.gathered, as_it_is.gathered, "{name}");
            assert_eq!(record.frames.len(), as_it_is.frames.len(), "{name}");
            let duration = record.duration / factor.sqrt();
            assert!((duration - as_it_is.duration).abs() < 1e-9, "{name}");
            // Contacts and dry friction make much of the least rounding, so nets part in the end, by less than an object;
            // at first they do not.
            let difference =
                |i: usize| net_difference(&record.frames[i], &as_it_is.frames[i], factor);
            let (first, last) = (difference(10), difference(record.frames.len() - 1));
            assert!(first < 1e-9 && last < 0.02, "{name}: {first}, {last}");
            // The mean force, since the greatest is that of one jolt.
            let force = record.mean_drive_force[0] / (factor * factor * factor);
            let ratio = force / as_it_is.mean_drive_force[0];
            assert!((ratio - 1.0).abs() < 0.01, "{name}: {ratio}");
        }
    }
}

#[test]
fn scenes_of_robots_with_bodies_scale() {
    for robot in [Preset::WafflePi.robot(), boat()] {
        let mut loaded = scene("witness-9");
        loaded.scene.robot = robot;
        scales(&loaded, &one_start());
    }
}

/// Two circles behind each other.
fn boat() -> Robot {
    let circle = |x: f64, radius: f64| BodyCircle {
        center: Point::new(x, 0.0),
        radius,
    };
    let body = Body::of(&[circle(0.06, 0.14), circle(-0.08, 0.15)]);
    Robot::default().with_body(body.expect("two circles"))
}
