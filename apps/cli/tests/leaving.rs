//! What cannot be gathered: all of it is named and proven, or left, and drawn.

mod program;

use program::{SMALL, files_below, folder_with, json, pinned, run, stderr, stdout, text};
use serde_json::Value;
use std::path::Path;
use std::process::Output;

fn plan(scene: &Path, out: &Path, more: &[&str]) -> Output {
    run(&[&["plan", text(scene), "-o", text(out)], more].concat())
}

/// `pinned` with one more object that is too close to the edge.
fn two_of_four() -> String {
    pinned() + "\n[[objects]]\nposition = [3.0, 2.95]\nradius = 0.02\n"
}

#[test]
fn all_objects_that_cannot_be_swept_are_named_at_once() {
    let (folder, scene) = folder_with(two_of_four());
    let out = folder.path().join("out");
    let ended = plan(&scene, &out, &["--json"]);
    assert_eq!(ended.status.code(), Some(4), "{}", stderr(&ended));
    let said: Value = serde_json::from_str(&stdout(&ended)).expect("JSON");
    let message = said["message"].as_str().expect("text");
    for part in [
        "2 of 4 objects cannot be swept",
        "object 1 at",
        "object 3 at",
        "the least move that was found to help is",
    ] {
        assert!(message.contains(part), "no {part:?} in {message}");
    }
    let help = said["help"].as_str().expect("text");
    assert!(
        help.contains("--leave unreachable") && help.contains("the other 2 objects"),
        "{help}"
    );
    let proofs = said["details"]["proofs"].as_array().expect("proofs");
    let kinds: Vec<_> = (proofs.iter())
        .map(|proof| (proof["object"].as_u64(), proof["kind"].as_str()))
        .collect();
    assert_eq!(
        kinds,
        [
            (Some(1), Some("object_pinned")),
            (Some(3), Some("object_at_edge"))
        ]
    );
    assert_eq!(
        files_below(&out),
        ["failed.html", "failed.svg", "infeasible.json"]
    );
    let page = std::fs::read_to_string(out.join("failed.html")).expect("read");
    assert!(page.contains("NOT A PLAN: proven infeasible"));
    let checked = run(&["check", text(&scene), text(&out.join("infeasible.json"))]);
    assert_eq!(checked.status.code(), Some(0), "{}", stdout(&checked));
    assert!(stdout(&checked).starts_with("valid: all 2 proofs hold"));
}

#[test]
fn what_cannot_be_swept_is_left_and_the_rest_is_gathered() {
    let (folder, scene) = folder_with(two_of_four());
    let out = folder.path().join("out");
    let ended = plan(&scene, &out, &["--leave", "unreachable"]);
    assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
    let said = stdout(&ended);
    assert!(said.contains("2 of 4 objects, 2 LEFT"), "{said}");
    assert!(said.contains("proven impossible: 1, 3"), "{said}");

    let plan = json(&out.join("plan.json"));
    let left = plan["left_out"].as_array().expect("a list");
    let objects: Vec<_> = (left.iter())
        .map(|l| (l["object"].as_u64(), l["why"].as_str()))
        .collect();
    assert_eq!(
        objects,
        [(Some(1), Some("proven")), (Some(3), Some("proven"))]
    );
    assert_eq!(plan["overrides"]["leave"], "unreachable");
    assert_eq!(plan["certificate"]["valid"], true);
    assert_eq!(plan["rehearsal"]["status"], "passed");
    let in_circles: Vec<u64> = (plan["circles"].as_array().expect("circles").iter())
        .flat_map(|circle| circle["objects"].as_array().expect("objects"))
        .filter_map(Value::as_u64)
        .collect();
    assert!(!in_circles.contains(&1) && !in_circles.contains(&3));
    for name in ["plan.svg", "report.html"] {
        let picture = std::fs::read_to_string(out.join(name)).expect("read");
        assert!(picture.contains("object leave"), "{name}");
        assert!(picture.contains("gathers 2 of 4 objects, 2 left"), "{name}");
    }

    let path = out.join("plan.json");
    let checked = run(&["check", text(&scene), text(&path), "--json"]);
    assert_eq!(checked.status.code(), Some(0), "{}", stdout(&checked));
    let checked: Value = serde_json::from_str(&stdout(&checked)).expect("JSON");
    assert_eq!(checked["left_out"], plan["left_out"]);
    let rehearsed = run(&["rehearse", text(&scene), text(&path), "--quick", "--json"]);
    assert_eq!(rehearsed.status.code(), Some(0), "{}", stdout(&rehearsed));
    let rehearsed: Value = serde_json::from_str(&stdout(&rehearsed)).expect("JSON");
    assert_eq!(rehearsed["left_out"], plan["left_out"]);
}

#[test]
fn what_is_left_without_a_reason_is_refused() {
    let (folder, scene) = folder_with(two_of_four());
    let out = folder.path().join("out");
    let ended = plan(&scene, &out, &["--leave", "unreachable", "--no-rehearsal"]);
    assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
    let path = out.join("plan.json");
    let plan = json(&path);
    let refused = |change: &dyn Fn(&mut Value)| {
        let mut changed = plan.clone();
        change(&mut changed);
        std::fs::write(&path, changed.to_string()).expect("written");
        let ended = run(&["check", text(&scene), text(&path)]);
        (ended.status.code(), stdout(&ended))
    };
    assert_eq!(refused(&|_| ()).0, Some(0));
    // Nothing is left any more, so that two objects are not covered.
    let (code, said) = refused(&|plan| plan["left_out"] = Value::Array(Vec::new()));
    assert_eq!(code, Some(6), "{said}");
    // Object 0 can be swept: no proof.
    let (code, said) = refused(&|plan| plan["left_out"][0]["object"] = 0.into());
    assert_eq!(code, Some(6), "{said}");
    let (code, said) = refused(&|plan| plan["left_out"][0]["object"] = 9.into());
    assert_eq!(code, Some(6), "{said}");
    assert!(said.contains("object 9"), "{said}");
}

#[test]
fn a_scene_says_itself_that_objects_may_be_left() {
    let leave = pinned() + "\n[planner]\nleave = \"unreachable\"\n";
    let (folder, scene) = folder_with(leave);
    let out = folder.path().join("out");
    for (more, code) in [
        (&[][..], 0),
        (&["--leave", "none"], 4),
        (&["--leave", "some"], 2),
    ] {
        let more = [&["--no-rehearsal"], more].concat();
        assert_eq!(plan(&scene, &out, &more).status.code(), Some(code));
    }
    // The proof is about the one object, so there is nothing to gather.
    let one = SMALL.replace("2.2, 0.4]", "2.2, 1.3]");
    let (folder, scene) = folder_with(one);
    let out = folder.path().join("out");
    let ended = plan(&scene, &out, &["--leave", "unreachable"]);
    assert_eq!(ended.status.code(), Some(4));
    assert!(
        stderr(&ended).contains("nothing can be gathered"),
        "{}",
        stderr(&ended)
    );
}

#[test]
fn a_scene_is_drawn_before_it_is_planned() {
    let (folder, scene) = folder_with(two_of_four());
    let picture = folder.path().join("pictures/hall.svg");
    let ended = run(&["show", text(&scene), "-o", text(&picture)]);
    assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
    let said = stdout(&ended);
    assert!(
        said.contains("4 objects") && said.contains("2 of 4"),
        "{said}"
    );
    let svg = std::fs::read_to_string(&picture).expect("the picture");
    let document = is_closed(&svg);
    assert!(document && svg.contains("object leave") && svg.contains("class=\"mark\""));
    let ended = run(&["show", text(&scene), "-o", text(folder.path())]);
    assert_eq!(ended.status.code(), Some(0));
    assert!(folder.path().join("scene.svg").is_file());
}

/// As many elements are closed as are opened.
fn is_closed(svg: &str) -> bool {
    let count = |pattern: &str| svg.matches(pattern).count();
    count("<g") == count("</g>") && svg.trim_end().ends_with("</svg>")
}

#[test]
fn a_search_without_success_names_every_start_and_draws_the_best_attempt() {
    // Too few waypoints for the way around, but enough for a straight one.
    let (folder, scene) = folder_with(SMALL.replace("[2.0, 1.5]", "[2.0, 2.6]"));
    let out = folder.path().join("out");
    let ended = plan(
        &scene,
        &out,
        &["--waypoints", "64", "--no-rehearsal", "--json"],
    );
    assert_eq!(ended.status.code(), Some(5), "{}", stderr(&ended));
    let said: Value = serde_json::from_str(&stdout(&ended)).expect("JSON");
    let tried = said["details"]["tried"].as_array().expect("a list");
    assert!(!tried.is_empty());
    assert_eq!(files_below(&out), ["failed.html", "failed.svg"]);
    let svg = std::fs::read_to_string(out.join("failed.svg")).expect("read");
    assert!(svg.contains("NOT A PLAN"), "the picture says what it is");
    assert!(svg.contains("this is the best attempt"));
}

#[test]
fn what_is_shown_of_a_failure_has_the_net_of_the_command_line() {
    let (folder, scene) = folder_with(SMALL);
    let out = folder.path().join("out");
    let ended = plan(&scene, &out, &["--net-length", "0.5"]);
    assert_eq!(ended.status.code(), Some(4), "{}", stderr(&ended));
    for name in ["failed.svg", "failed.html"] {
        let shown = std::fs::read_to_string(out.join(name)).expect("read");
        assert!(shown.contains("net 0.500 m"), "{name}");
        assert!(!shown.contains("1.200 m"), "{name}");
    }
}
