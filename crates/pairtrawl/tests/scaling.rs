//! A scene multiplied by any factor is planned the same, multiplied by it.

use pairtrawl::files::{LoadedScene, parse_scene, read_scene};
use pairtrawl::generate::{Kind, generate, scene_toml};
use pairtrawl::model::{PairTrajectory, Plan, Units};
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

fn scales(loaded: &LoadedScene, options: &PlanOptions) {
    let options = PlanOptions {
        rehearsal: RehearsalMode::Skip,
        ..options.clone()
    };
    let t = std::time::Instant::now();
    let as_it_is = planned(loaded, 1.0, &options);
    println!("{} {:?}", loaded.scene.name, t.elapsed());
    for factor in FACTORS {
        let t = std::time::Instant::now();
        let units = Units {
            length: 1.0 / factor,
            ..Units::SI
        };
        let plan = match plan(
            &units.scene(&loaded.scene),
            &loaded.reference,
            &options,
            &mut (),
        ) {
            Ok(p) => p.plan,
            Err(e) => {
                println!("  {factor} {e}");
                continue;
            }
        };
        let (far, turned) = difference(&plan.trajectory, &as_it_is.trajectory, factor);
        println!(
            "  {factor} {:?} it {} vs {} far {far:.2e} turned {turned:.2e} valid {} cost {} {}",
            t.elapsed(),
            plan.solver.iterations,
            as_it_is.solver.iterations,
            plan.certificate.is_valid(),
            plan.cost.total(),
            as_it_is.cost.total()
        );
    }
}

#[test]
fn shipped_scenes_scale() {
    let full = PlanOptions::default();
    let quick = PlanOptions {
        explore: false,
        ..PlanOptions::default()
    };
    for name in std::env::var("SCENES")
        .unwrap_or("witness-1 witness-9 paper-experiment".into())
        .split(' ')
    {
        scales(
            &scene(name),
            if std::env::var("FULL").is_ok() {
                &full
            } else {
                &quick
            },
        );
    }
}

#[test]
fn generated_scenes_scale() {
    let generated = generate(Kind::Witness, 4, 8, 200).expect("a scene");
    let text = scene_toml(&generated.scene).expect("a scene that can be written");
    scales(
        &parse_scene(&text, "generated").expect("a scene that can be read"),
        &PlanOptions::default(),
    );
}
