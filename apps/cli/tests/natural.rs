//! Scenes as litter lies, and planning a folder of scenes.

mod program;

use program::{SMALL, files_below, folder_with, json, program, run, stderr, stdout, text};
use serde_json::Value;
use std::path::Path;
use std::process::Stdio;

/// A room of 5 m x 4 m with walls of a cell, as a PGM image and its YAML.
fn write_map(folder: &Path) -> std::path::PathBuf {
    let (columns, rows) = (50, 40);
    let mut image = format!("P5\n{columns} {rows}\n255\n").into_bytes();
    for row in 0..rows {
        for column in 0..columns {
            let is_wall = row == 0 || row == rows - 1 || column == 0 || column == columns - 1;
            image.push(if is_wall { 0 } else { 254 });
        }
    }
    let pictures = folder.join("pictures");
    std::fs::create_dir_all(&pictures).expect("a folder");
    std::fs::write(pictures.join("the room.pgm"), image).expect("the image is written");
    let yaml = folder.join("room.yaml");
    let text = "image: pictures/the room.pgm\nresolution: 0.1\norigin: [-2.5, 1.0, 0.3]\nnegate: 0\n\
                occupied_thresh: 0.65\nfree_thresh: 0.196\n";
    std::fs::write(&yaml, text).expect("the map is written");
    yaml
}

#[test]
fn litter_on_a_map_is_a_scene_that_moves_with_its_folder() {
    let folder = tempfile::tempdir().expect("a folder");
    let map = write_map(folder.path());
    let out = folder.path().join("made");
    let make = |seed: &str, out: &Path| {
        let ended = run(&[
            "generate",
            "--kind",
            "litter",
            "--map",
            text(&map),
            "--objects",
            "5",
            "--near",
            "0.7",
            "--seed",
            seed,
            "-o",
            text(out),
        ]);
        assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
    };
    make("3", &out);
    assert_eq!(files_below(&out), ["map.pgm", "map.yaml", "scene.toml"]);
    // Somewhere else, without the map that it came from.
    let moved = folder.path().join("moved");
    std::fs::rename(&out, &moved).expect("the folder moves");
    let again = folder.path().join("again");
    make("3", &again);
    make("4", &out);
    std::fs::remove_file(&map).expect("the map goes");
    let read = |folder: &Path| std::fs::read(folder.join("scene.toml")).expect("a scene");
    assert_eq!(read(&moved), read(&again), "a seed is a scene");
    assert_ne!(read(&moved), read(&out));

    let plan = folder.path().join("plan");
    let scene = moved.join("scene.toml");
    let ended = run(&[
        "plan",
        text(&scene),
        "--no-rehearsal",
        "--json",
        "-o",
        text(&plan),
    ]);
    // Whether it can be done nobody knows beforehand; that it is a scene is what counts.
    let code = ended.status.code();
    assert!(matches!(code, Some(0 | 4 | 5)), "{}", stderr(&ended));
}

#[test]
fn generate_says_what_is_wrong() {
    let folder = tempfile::tempdir().expect("a folder");
    let map = write_map(folder.path());
    let (map, out) = (text(&map), folder.path().join("out"));
    let cases: [(&[&str], i32, &str); 8] = [
        (&["--kind", "litter"], 2, "--map"),
        (
            &["--kind", "litter", "--map", "missing.yaml"],
            3,
            "missing.yaml",
        ),
        (
            &["--kind", "litter", "--map", map, "--near", "3"],
            2,
            "only 0 of 12 objects",
        ),
        (
            &["--kind", "litter", "--map", map, "--near=-1"],
            2,
            "--near",
        ),
        (
            &["--kind", "litter", "--map", map, "--difficulty", "3"],
            2,
            "--difficulty means nothing for --kind litter",
        ),
        (
            &["--kind", "hall", "--map", map],
            2,
            "--map means nothing for --kind hall",
        ),
        (&["--kind", "hall", "--size", "15"], 2, "15x10"),
        (
            &["--objects", "3"],
            2,
            "--objects means nothing for --kind witness",
        ),
    ];
    for (arguments, code, says) in cases {
        let line = [&["generate", "-o", text(&out)], arguments].concat();
        let ended = run(&line);
        assert_eq!(ended.status.code(), Some(code), "{arguments:?}");
        assert!(stderr(&ended).contains(says), "{}", stderr(&ended));
        assert!(!out.exists(), "{arguments:?} left a folder behind");
    }
}

#[test]
fn a_folder_of_scenes_is_planned_and_counted() {
    let (folder, _) = folder_with(SMALL);
    let put = |name: &str, scene: &str| {
        let file = folder.path().join(name);
        std::fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
        std::fs::write(file, scene).expect("a scene is written");
    };
    put(
        "rooms/a/scene.toml",
        &SMALL.replace("\"small\"", "\"room-1\""),
    );
    // A wall from side to side.
    let cut = SMALL
        .replace("\"small\"", "\"room-2\"")
        .replace("box = [1.8, 0.0, 2.2, 0.4]", "box = [1.2, -2.0, 1.6, 6.0]");
    put("rooms/b.toml", &cut);
    put("notes.toml", "this = \"is no scene\"");
    put("notes.txt", "nor is this");

    let out = tempfile::tempdir().expect("a folder");
    let ended = run(&[
        "bench-plan",
        text(folder.path()),
        "--no-rehearsal",
        "--jobs",
        "2",
        "--json",
        "-o",
        text(out.path()),
    ]);
    assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
    let said: Value = serde_json::from_str(&stdout(&ended)).expect("JSON");
    let kept = json(&out.path().join("bench.json"));
    assert_eq!(said["scenes"], kept["scenes"]);

    let of = |name: &str| {
        let all = kept["scenes"].as_array().expect("scenes");
        let found = all.iter().find(|scene| scene["name"] == name);
        found.unwrap_or_else(|| panic!("{name} in {kept}")).clone()
    };
    assert_eq!(kept["scenes"].as_array().map(Vec::len), Some(4));
    for name in ["rooms/a", "scene"] {
        let scene = of(name);
        assert_eq!(scene["exit_code"], 0, "{scene}");
        assert_eq!(
            (&scene["objects"], &scene["gathered"]),
            (&1.into(), &1.into())
        );
        assert_eq!(scene["valid"], true);
        assert!(scene["iterations"].as_u64() > Some(3), "{scene}");
        let page = scene["page"].as_str().expect("a page");
        assert!(out.path().join(page).is_file(), "{page}");
    }
    assert_eq!(of("rooms/b")["exit_code"], 4);
    assert!(of("rooms/b")["message"].to_string().contains("proven"));
    assert_eq!(of("notes")["exit_code"], 3);
    assert_eq!(of("notes")["group"], "unreadable");
    let groups: Vec<(&str, u64, u64)> = (kept["groups"].as_array().expect("groups").iter())
        .map(|group| {
            let count = |key: &str| group[key].as_u64().expect("a count");
            let name = group["name"].as_str().expect("a name");
            (name, count("planned"), count("scenes"))
        })
        .collect();
    assert_eq!(
        groups,
        [("room", 1, 2), ("small", 1, 1), ("unreadable", 0, 1)]
    );
    assert_eq!(kept["total"]["gathered"], 2);
    assert_eq!(kept["total"]["objects"], 3);
    if cfg!(target_os = "linux") {
        assert!(kept["total"]["memory"].as_u64() > Some(1_000_000), "{kept}");
    }
    let page = std::fs::read_to_string(out.path().join("bench.html")).expect("bench.html");
    assert!(page.contains("scenes/rooms/a/report.html") && page.contains("4 scenes"));
    assert!(
        !page.contains("http"),
        "the page needs nothing from elsewhere"
    );
}

#[test]
fn a_bench_without_scenes_is_bad_input() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    for (where_, says) in [
        (text(folder.path()), "no .toml file"),
        ("missing", "cannot be read"),
    ] {
        let ended = run(&["bench-plan", where_, "-o", text(&out)]);
        assert_eq!(ended.status.code(), Some(3));
        assert!(stderr(&ended).contains(says), "{}", stderr(&ended));
    }
}

#[cfg(unix)]
#[test]
fn an_interrupted_bench_keeps_what_is_done() {
    let (folder, _) = folder_with(SMALL);
    // The second one, by name, takes long: many objects, rehearsed.
    let made = folder.path().join("zzz");
    let ended = run(&[
        "generate",
        "--kind",
        "hall",
        "--size",
        "40x40",
        "--objects",
        "400",
        "-o",
        text(&made),
    ]);
    assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
    let out = folder.path().join("out");
    let child = program(&[
        "bench-plan",
        text(folder.path()),
        "--jobs",
        "1",
        "--no-rehearsal",
        "--json",
        "-o",
        text(&out),
    ])
    .stdout(Stdio::piped())
    .stderr(Stdio::piped())
    .spawn()
    .expect("the program starts");
    let first = out.join("scenes/scene/plan.json");
    while !first.is_file() {
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    // The folder of the second one is made when it is begun.
    while !out.join("scenes/zzz").exists() {
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    program::interrupt(&child);
    let ended = child.wait_with_output().expect("the program ends");
    assert_eq!(ended.status.code(), Some(130), "{}", stderr(&ended));
    let kept = json(&out.join("bench.json"));
    assert_eq!(kept["interrupted"], true);
    assert_eq!(kept["wanted"], 2);
    let names: Vec<_> = (kept["scenes"].as_array().expect("scenes").iter())
        .map(|scene| scene["name"].as_str().expect("a name"))
        .collect();
    assert_eq!(names, ["scene"]);
}
