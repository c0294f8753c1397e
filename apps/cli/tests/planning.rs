//! From a scene file to certified plans, through the program.

mod program;

use program::{SMALL, files_below, folder_with, json, library_scene, run, stderr, stdout, text};
use serde_json::Value;
use std::path::Path;

fn plan_in(folder: &Path, scene: &Path, more: &[&str]) -> Value {
    let mut arguments = vec!["plan", text(scene), "-o", text(folder), "--json"];
    arguments.extend(more);
    let ended = run(&arguments);
    assert_eq!(
        ended.status.code(),
        Some(0),
        "{} {more:?}: {}",
        scene.display(),
        stderr(&ended)
    );
    serde_json::from_str(&stdout(&ended)).expect("JSON")
}

/// Plans and checks a scene; its summary.
fn certified(scene: &Path, more: &[&str]) -> Value {
    let folder = tempfile::tempdir().expect("a folder");
    let summary = plan_in(folder.path(), scene, more);
    let plan = folder.path().join("plan.json");
    let checked = run(&["check", text(scene), text(&plan)]);
    assert_eq!(checked.status.code(), Some(0), "{}", stdout(&checked));
    summary
}

fn certified_scene(name: &str, more: &[&str]) -> Value {
    let mut arguments = vec!["--no-rehearsal"];
    arguments.extend(more);
    certified(&library_scene(name), &arguments)
}

#[test]
fn all_files_are_written_and_no_other() {
    let (folder, scene) = folder_with(SMALL);
    let out = folder.path().join("out");
    let summary = plan_in(&out, &scene, &["--no-rehearsal"]);
    let expected = [
        "left.tum",
        "plan.csv",
        "plan.json",
        "plan.svg",
        "report.html",
        "right.tum",
    ];
    assert_eq!(files_below(&out), expected);
    let mut listed: Vec<_> = summary["files"]
        .as_array()
        .expect("files")
        .iter()
        .map(|f| f.as_str().expect("text").to_owned())
        .collect();
    listed.sort();
    assert_eq!(
        listed,
        expected.map(|name| out.join(name).display().to_string())
    );
    let csv = std::fs::read_to_string(out.join("plan.csv")).expect("plan.csv");
    let header = csv.lines().next().expect("a header");
    // Columns are added at the end only.
    assert_eq!(
        header.strip_prefix("t,left_x,left_y,left_heading,right_x,right_y,right_heading"),
        Some(",left_v,left_omega,right_v,right_omega")
    );
    let waypoints = summary["waypoints"].as_u64().expect("a number");
    assert_eq!(csv.lines().count() as u64, waypoints + 1);
}

#[test]
fn two_runs_give_the_same_plan_apart_from_seconds() {
    let (folder, scene) = folder_with(SMALL);
    let read = |name: &str| {
        let out = folder.path().join(name);
        plan_in(&out, &scene, &[]);
        let text = std::fs::read_to_string(out.join("plan.json")).expect("plan.json");
        let lines: Vec<String> = text
            .split(',')
            .filter(|part| !part.contains("\"seconds\""))
            .map(str::to_owned)
            .collect();
        assert!(lines.len() > 100);
        lines
    };
    assert_eq!(read("first"), read("second"));
}

#[test]
fn check_refuses_a_plan_of_another_scene_and_a_changed_one() {
    let (folder, scene) = folder_with(SMALL);
    let out = folder.path().join("out");
    plan_in(&out, &scene, &["--no-rehearsal"]);
    let path = out.join("plan.json");
    let mut plan = json(&path);

    let (_other_folder, other) = folder_with(SMALL.replace("name = \"small\"", "name = \"other\""));
    let ended = run(&["check", text(&other), text(&path)]);
    assert_eq!(ended.status.code(), Some(6));
    assert!(
        stdout(&ended)
            .lines()
            .any(|line| line.trim_start().starts_with("scene") && line.contains("FAILS")),
        "{}",
        stdout(&ended)
    );

    // A comment changes the bytes of the scene, not what it says.
    let (_commented_folder, commented) = folder_with(format!("# mine\n{SMALL}"));
    let ended = run(&["check", text(&commented), text(&path)]);
    assert_eq!(ended.status.code(), Some(0), "{}", stdout(&ended));
    assert!(
        stdout(&ended).contains("bytes of its files differ"),
        "{}",
        stdout(&ended)
    );

    let x = plan["left"][5][0].as_f64().expect("a number");
    plan["left"][5][0] = (x + 0.5).into();
    std::fs::write(&path, plan.to_string()).expect("written");
    let ended = run(&["check", text(&scene), text(&path), "--json"]);
    assert_eq!(ended.status.code(), Some(6));
    let verdict: Value = serde_json::from_str(&stdout(&ended)).expect("JSON");
    assert_eq!(verdict["valid"], false);
    let step = verdict["claims"]
        .as_array()
        .expect("claims")
        .iter()
        .find(|claim| claim["name"] == "step")
        .expect("step");
    assert_eq!(step["holds"], false);
}

#[test]
fn a_plan_from_elsewhere_needs_four_fields() {
    let (folder, scene) = folder_with(SMALL);
    let out = folder.path().join("out");
    plan_in(&out, &scene, &["--no-rehearsal"]);
    let path = out.join("plan.json");
    let plan = json(&path);
    let mut bare = serde_json::Map::new();
    for field in ["format", "net_length", "left", "right", "step_time"] {
        bare.insert(field.to_owned(), plan[field].clone());
    }
    bare.insert("unheard_of".to_owned(), Value::Null);
    std::fs::write(&path, Value::Object(bare).to_string()).expect("written");
    let ended = run(&["check", text(&scene), text(&path)]);
    assert_eq!(ended.status.code(), Some(0), "{}", stdout(&ended));
}

#[test]
fn an_overridden_net_length_stands_in_the_plan() {
    let (folder, scene) = folder_with(SMALL);
    let out = folder.path().join("out");
    plan_in(&out, &scene, &["--no-rehearsal", "--net-length", "1.0"]);
    let plan = json(&out.join("plan.json"));
    assert_eq!(plan["net_length"], 1.0);
    assert_eq!(plan["overrides"]["net_length"], 1.0);
    let chosen = plan_in(&out, &scene, &["--no-rehearsal", "--net-length", "auto"]);
    assert_eq!(chosen["net_length_chosen"], true);
    let ended = run(&["check", text(&scene), text(&out.join("plan.json"))]);
    assert_eq!(ended.status.code(), Some(0), "{}", stdout(&ended));
}

#[test]
fn generated_scenes_and_their_witnesses_pass_check() {
    let folder = tempfile::tempdir().expect("a folder");
    for (kind, difficulty) in [("witness", "1"), ("witness", "10"), ("serpentine", "5")] {
        let out = folder.path().join(kind).join(difficulty);
        let made = run(&[
            "generate",
            "--kind",
            kind,
            "--difficulty",
            difficulty,
            "--seed",
            "7",
            "-o",
            text(&out),
        ]);
        assert_eq!(made.status.code(), Some(0), "{}", stderr(&made));
        let ended = run(&[
            "check",
            text(&out.join("scene.toml")),
            text(&out.join("witness.json")),
        ]);
        assert_eq!(
            ended.status.code(),
            Some(0),
            "{kind} {difficulty}: {}",
            stdout(&ended)
        );
    }
}

#[test]
fn a_random_centerline_depends_on_its_seed_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = library_scene("paper-experiment");
    let centerline = |seed: &str, name: &str| {
        let out = folder.path().join(name);
        let how = ["--centerline", "rrt-star", "--seed", seed];
        plan_in(
            &out,
            &scene,
            &[&["--no-rehearsal", "--no-explore"], &how[..]].concat(),
        );
        json(&out.join("plan.json"))["centerline"].to_string()
    };
    let first = centerline("1", "a");
    assert_eq!(first, centerline("1", "b"), "the same seed");
    assert_ne!(first, centerline("2", "c"), "another seed");
}

#[test]
fn the_joint_method_is_within_a_thousandth_of_algorithm_1_or_better() {
    for method in ["alternating", "alternating-bounded"] {
        let cost = |method: &str| {
            let summary = certified_scene("paper-experiment", &["--method", method]);
            summary["cost"]["total"].as_f64().expect("a number")
        };
        let (joint, alternating) = (cost("joint"), cost(method));
        assert!(
            joint <= 1.001 * alternating,
            "J {joint} joint, {alternating} {method}"
        );
    }
}

#[test]
fn a_failed_rehearsal_warns_or_refuses() {
    // No drag is below this bound, so every rehearsal ends with a snag.
    let (folder, scene) = folder_with(format!("{SMALL}\n[physics]\ntension_limit = 1e-6\n"));
    let out = folder.path().join("out");
    let ended = run(&["plan", text(&scene), "-o", text(&out)]);
    assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
    assert!(stdout(&ended).contains("warning: the plan is certified, but its rehearsal fails"));
    let plan = json(&out.join("plan.json"));
    assert_eq!(plan["rehearsal"]["status"], "failed");
    let ended = run(&[
        "rehearse",
        text(&scene),
        text(&out.join("plan.json")),
        "--quick",
    ]);
    assert_eq!(ended.status.code(), Some(7));

    let strict = folder.path().join("strict");
    let ended = run(&[
        "plan",
        text(&scene),
        "-o",
        text(&strict),
        "--require-rehearsal",
    ]);
    assert_eq!(ended.status.code(), Some(5), "{}", stderr(&ended));
    assert!(stderr(&ended).contains("rehearsal"));
    assert_eq!(files_below(&strict), ["failed.html", "failed.svg"]);
}

#[test]
fn time_runs_out_with_5_and_no_plan() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let scene = library_scene("paper-simulation");
    let ended = run(&[
        "plan",
        text(&scene),
        "-o",
        text(&out),
        "--time-limit",
        "0.001",
    ]);
    assert_eq!(ended.status.code(), Some(5), "{}", stderr(&ended));
    assert!(stderr(&ended).contains("0.001"));
    assert_eq!(files_below(&out), ["failed.html", "failed.svg"]);
}

#[test]
fn the_papers_experiment() {
    let summary = certified_scene("paper-experiment", &["--waypoints", "328"]);
    let cost = summary["cost"]["total"].as_f64().expect("a number");
    assert!(cost <= 5600.0, "J is {cost}");
}

#[test]
fn the_papers_simulation() {
    certified_scene("paper-simulation", &[]);
}

#[test]
fn witness_scenes() {
    for index in 1..=9 {
        certified_scene(&format!("witness-{index}"), &[]);
    }
}

#[test]
fn every_scene_and_length() {
    for length in ["1.5", "2.0", "2.5", "3.0"] {
        certified_scene("paper-simulation", &["--net-length", length]);
    }
    for name in [
        "paper-simulation",
        "paper-experiment",
        "authors-simulation",
        "turtlebot3-world",
        "nav2-sandbox",
    ] {
        certified_scene(name, &[]);
        certified_scene(name, &["--net-length", "auto"]);
    }
    for index in 1..=9 {
        certified_scene(&format!("witness-{index}"), &["--net-length", "auto"]);
    }
}

#[test]
fn the_authors_simulation_is_shorter_than_theirs() {
    let summary = certified_scene(
        "authors-simulation",
        &["--net-length", "2.0", "--waypoints", "673"],
    );
    let length = summary["left_length"].as_f64().expect("a number")
        + summary["right_length"].as_f64().expect("a number");
    assert!(length <= 47.5, "both paths are {length} m");
}
