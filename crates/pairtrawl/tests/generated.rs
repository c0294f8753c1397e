//! Generated scenes: written and read again, and planned from one start and from several.

use pairtrawl::files;
use pairtrawl::generate::{Kind, generate, scene_toml};
use pairtrawl::{PlanOptions, RehearsalMode, plan};

#[test]
fn a_generated_scene_survives_its_file() {
    for (kind, difficulty, seed) in [
        (Kind::Witness, 1, 4),
        (Kind::Witness, 9, 5),
        (Kind::Serpentine, 4, 6),
    ] {
        let generated = generate(kind, difficulty, seed, 400).expect("a scene");
        let text = scene_toml(&generated.scene).expect("a scene that can be written");
        let read = files::parse_scene(&text, "generated").expect("a scene that can be read");
        assert_eq!(read.scene, generated.scene);
    }
}

#[test]
fn exploring_starts_finds_what_one_start_misses() {
    // Who leads where makes more than 1 % here.
    let generated = generate(Kind::Witness, 6, 8, 200).expect("a scene");
    let text = scene_toml(&generated.scene).expect("a scene that can be written");
    let loaded = files::parse_scene(&text, "generated").expect("a scene that can be read");
    let cost = |explore: bool, threads: usize| {
        let options = PlanOptions {
            explore,
            rehearsal: RehearsalMode::Skip,
            ..PlanOptions::default()
        };
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("threads");
        let planned = pool
            .install(|| plan(&loaded.scene, &loaded.reference, &options, &mut ()))
            .expect("a plan");
        planned.plan.cost.total()
    };
    let (one, several) = (cost(false, 1), cost(true, 1));
    assert!(
        several < 0.99 * one,
        "{several} from several starts, {one} from one"
    );
    assert_eq!(
        several.to_bits(),
        cost(true, 3).to_bits(),
        "whatever the threads"
    );
}
