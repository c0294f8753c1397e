//! Generated scenes written and read again.

use pairtrawl::files;
use pairtrawl::generate::{Kind, generate, scene_toml};

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
