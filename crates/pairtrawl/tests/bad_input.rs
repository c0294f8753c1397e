//! Whatever lies where a scene, a map or a plan should be, the answer is one clear message.

use pairtrawl::files::{FileError, Problem, parse_plan, parse_scene, read_plan, read_scene};
use proptest::prelude::*;
use std::path::Path;

fn message(error: FileError) -> String {
    assert!(!error.is_from_system(), "{error}");
    let text = error.to_string();
    assert!(!text.contains('\n'), "{text}");
    text
}

fn write(folder: &Path, name: &str, content: &[u8]) -> std::path::PathBuf {
    let path = folder.join(name);
    std::fs::write(&path, content).unwrap();
    path
}

#[test]
fn paths_that_lead_to_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("missing.toml");
    assert!(message(read_scene(&missing).unwrap_err()).contains("no such file"));
    assert!(message(read_scene(&missing.join("below")).unwrap_err()).contains("no such file"));
    assert!(message(read_scene(folder.path()).unwrap_err()).contains("folder"));
    let empty = write(folder.path(), "empty.toml", b"");
    assert!(message(read_scene(&empty).unwrap_err()).contains("empty"));
    assert!(message(read_plan(&empty).unwrap_err()).contains("empty"));
    let binary = write(folder.path(), "binary.toml", b"format = \"\xff\xfe\"");
    assert!(message(read_scene(&binary).unwrap_err()).contains("byte 10"));
    let through_a_file = empty.join("scene.toml");
    assert!(message(read_scene(&through_a_file).unwrap_err()).contains("no such file"));
    let long = write(folder.path(), "long.toml", &vec![b'#'; (4 << 20) + 1]);
    assert!(message(read_scene(&long).unwrap_err()).contains("4194304"));
}

#[cfg(unix)]
#[test]
fn endless_devices_and_pipes_are_not_opened() {
    let folder = tempfile::tempdir().unwrap();
    let zero = folder.path().join("zero.toml");
    std::os::unix::fs::symlink("/dev/zero", &zero).unwrap();
    assert!(matches!(
        read_scene(&zero).unwrap_err().problem,
        Problem::NotRegular
    ));
    let looped = folder.path().join("looped.toml");
    std::os::unix::fs::symlink(&looped, &looped).unwrap();
    assert!(read_scene(&looped).unwrap_err().is_from_system());
}

const SCENE: &str = r#"format = "pairtrawl-scene/1"
[area]
map = "map.yaml"
[[objects]]
position = [1.0, 1.5]
size = [0.05, 0.05]
[start]
left = [0.7, 0.5]
right = [1.3, 0.5]
heading = 1.5707963
[end]
left = [0.7, 2.5]
right = [1.3, 2.5]
heading = 1.5707963
"#;
const YAML: &[u8] = b"image: map.pgm\nresolution: 0.1\norigin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

fn free_image() -> Vec<u8> {
    [b"P5\n20 30\n255\n".as_slice(), &[254; 600]].concat()
}

#[test]
fn maps_of_every_damaged_kind() {
    let folder = tempfile::tempdir().unwrap();
    let scene = write(folder.path(), "scene.toml", SCENE.as_bytes());
    assert!(message(read_scene(&scene).unwrap_err()).contains("map.yaml: there is no such file"));
    write(folder.path(), "map.yaml", YAML);
    assert!(message(read_scene(&scene).unwrap_err()).contains("map.pgm: there is no such file"));
    write(folder.path(), "map.pgm", &free_image());
    let loaded = read_scene(&scene).unwrap();
    assert_eq!(
        (
            loaded.scene.area.max.x,
            loaded.scene.area.max.y,
            loaded.scene.area.resolution
        ),
        (2.0, 3.0, 0.1)
    );
    let expected = pairtrawl::files::sha256_hex(&[SCENE.as_bytes(), YAML, &free_image()]);
    assert_eq!(loaded.reference.sha256, expected);

    let images: [(&[u8], &str); 8] = [
        (b"P5\n0 30\n255\n", "0 x 30 pixels"),
        (
            b"P5\n65536 65536\n255\n",
            "65536 x 65536 pixels, the bound is",
        ),
        (b"P5\n4000 4000\n255\n", "cut off"),
        (b"P5\n20 30\n255\n\x01\x02", "600 bytes, and 2 bytes follow"),
        (b"P39151", "starts with \"P39151\""),
        (b"P39151 7\n255\n", "starts with"),
        (b"GIF89a", "starts with \"GIF89a\""),
        (b"P5\n20", "cannot be decoded"),
    ];
    for (image, expected) in images {
        write(folder.path(), "map.pgm", image);
        let text = message(read_scene(&scene).unwrap_err());
        assert!(
            text.contains(expected) && text.contains("map.pgm"),
            "expected {expected:?} in {text}"
        );
    }
    write(folder.path(), "map.pgm", &free_image());

    for (from, to, expected) in [
        ("resolution: 0.1", "resolution: 0", "resolution is 0"),
        ("resolution: 0.1", "resolution: .nan", "resolution is NaN"),
        ("resolution: 0.1", "resolution: 1e9", "between -1e6"),
        ("resolution: 0.1", "resolution: 1e-9", "cells"),
        ("[0.0, 0.0, 0.0]", "[0.0, 0.0]", "three finite numbers"),
        ("[0.0, 0.0, 0.0]", "[0.0, 1e300, 0.0]", "1e300"),
        ("negate: 0", "negate: 2", "negate is 2"),
        ("0.196", "1.5", "free_thresh is 1.5"),
        ("0.196", "0.7", "at most occupied_thresh"),
        ("image: map.pgm", "picture: map.pgm", "image"),
        ("image: map.pgm", "image: map.pgm\nmode: fancy", "mode"),
        ("image: map.pgm", "image: [", "YAML"),
    ] {
        let yaml = String::from_utf8(YAML.to_vec()).unwrap();
        assert!(yaml.contains(from), "{from}");
        write(
            folder.path(),
            "map.yaml",
            yaml.replacen(from, to, 1).as_bytes(),
        );
        let text = message(read_scene(&scene).unwrap_err());
        assert!(
            text.contains(expected) && text.contains("map.yaml"),
            "expected {expected:?} in {text}"
        );
    }
    write(folder.path(), "map.yaml", "[".repeat(60_000).as_bytes());
    message(read_scene(&scene).unwrap_err());

    #[cfg(unix)]
    {
        write(folder.path(), "map.yaml", YAML);
        std::fs::remove_file(folder.path().join("map.pgm")).unwrap();
        std::os::unix::fs::symlink("/dev/zero", folder.path().join("map.pgm")).unwrap();
        assert!(message(read_scene(&scene).unwrap_err()).contains("device"));
    }
}

#[test]
fn blocked_and_unknown_cells_count() {
    let folder = tempfile::tempdir().unwrap();
    let scene = |unknown: &str| {
        write(
            folder.path(),
            "scene.toml",
            SCENE
                .replace("map.yaml\"", &format!("map.yaml\"\n{unknown}"))
                .as_bytes(),
        )
    };
    write(folder.path(), "map.yaml", YAML);
    let mut image = free_image();
    let first = image.len() - 600;
    // Row 14 from the top holds y = 1.5..1.6, where the object's upper edge is.
    image[first + 14 * 20..first + 15 * 20].fill(205);
    write(folder.path(), "map.pgm", &image);
    let text = message(read_scene(&scene("")).unwrap_err());
    assert!(
        text.contains("objects[0]") && text.contains("blocked cells"),
        "{text}"
    );
    assert!(read_scene(&scene("unknown = \"free\"")).is_ok());
    image[first + 15 * 20..first + 16 * 20].fill(0);
    write(folder.path(), "map.pgm", &image);
    message(read_scene(&scene("unknown = \"free\"")).unwrap_err());
}

#[test]
fn plans_that_are_none() {
    let parse = |text: &str| message(parse_plan(text, Path::new("plan.json")).unwrap_err());
    let poses = "[[0,0,0],[1,0,0]]";
    let plan = |net: &str, left: &str, right: &str| {
        format!(
            "{{\"format\": \"pairtrawl-plan/1\", \"net_length\": {net}, \"left\": {left}, \"right\": {right}}}"
        )
    };
    assert!(parse_plan(&plan("2", poses, poses), Path::new("plan.json")).is_ok());
    assert!(parse("{}").contains("format is missing"));
    assert!(parse("{\"format\": \"pairtrawl-plan/2\"}").contains("pairtrawl-plan/2"));
    assert!(
        parse("{\"format\": \"pairtrawl-plan/1\", \"left\": [], \"right\": []}")
            .contains("net_length")
    );
    assert!(parse(&plan("0", poses, poses)).contains("net_length is 0"));
    assert!(parse(&plan("NaN", poses, poses)).contains("expected value"));
    assert!(parse(&plan("1e999", poses, poses)).contains("out of range"));
    assert!(parse(&plan("2", "[[0,0,null],[1,0,0]]", poses)).contains("null"));
    assert!(parse(&plan("2", "[[0,0,0]]", poses)).contains("at least 2 poses"));
    assert!(parse(&plan("2", poses, "[[0,0,0],[1,0,0],[2,0,0]]")).contains("as long as left"));
    parse(&"[".repeat(100_000));
    parse(&format!("{{\"x\": {}", "[".repeat(100_000)));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn random_text_never_panics(text in ".{0,200}") {
        if let Err(e) = parse_scene(&text, "x.toml") { prop_assert!(!e.is_from_system()); }
        if let Err(e) = parse_plan(&text, Path::new("x.json")) { prop_assert!(!e.is_from_system()); }
    }

    /// Cuts, copies and replaces pieces of a real scene.
    #[test]
    fn mutated_scenes_never_panic(
        edits in prop::collection::vec((0.0..1.0_f64, 0_usize..12, prop::sample::select(vec![
            "", "0", "-1", "nan", "-inf", "1e308", "1e-300", "9223372036854775807", "0.05", "[", "]", "[[", "\"", "\n", "=", "{}", "[1, 2]",
            "left", "true", "1979-05-27", "#", ".", ",", "é", "\u{0}", "[start]\n", "[[objects]]\n",
        ])), 1..4),
    ) {
        let mut text = include_str!("../../../scenes/paper-experiment/scene.toml").to_owned();
        for (place, cut, insert) in edits {
            let mut from = (place * text.len() as f64) as usize;
            while !text.is_char_boundary(from) { from -= 1; }
            let mut to = (from + cut).min(text.len());
            while !text.is_char_boundary(to) { to -= 1; }
            text.replace_range(from..to, insert);
        }
        if let Err(e) = parse_scene(&text, "x.toml") {
            prop_assert!(!e.is_from_system());
            prop_assert!(!e.to_string().contains('\n'), "{}", e);
        }
    }
}
