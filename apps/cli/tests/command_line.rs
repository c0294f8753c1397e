//! The command line: help, codes, `new`, completions, machine-readable output, pipes.

mod program;

use program::{
    SMALL, files_below, folder_with, json, library_scene, program, run, stderr, stdout, text,
};
use serde_json::Value;
use std::process::Stdio;

const COMMANDS: [&str; 13] = [
    "plan",
    "check",
    "show",
    "demo",
    "rehearse",
    "run",
    "monte-carlo",
    "export",
    "length",
    "generate",
    "bench-plan",
    "new",
    "completions",
];

#[test]
fn help_explains_with_examples() {
    for command in COMMANDS {
        let ended = run(&[command, "--help"]);
        assert_eq!(ended.status.code(), Some(0));
        assert!(
            stdout(&ended).contains("Example"),
            "{command} --help has no example"
        );
    }
    let ended = run(&["--help"]);
    for command in COMMANDS {
        assert!(
            stdout(&ended).contains(command),
            "--help does not name {command}"
        );
    }
}

#[test]
fn a_bad_command_line_ends_with_2() {
    let bad: [&[&str]; 14] = [
        &[],
        &["fly"],
        &["plan"],
        &["plan", "scene.toml", "--net-length", "-1"],
        &["plan", "scene.toml", "--net-length", "nan"],
        &["plan", "scene.toml", "--waypoints", "2"],
        &["plan", "scene.toml", "--time-limit", "0"],
        &[
            "plan",
            "scene.toml",
            "--no-rehearsal",
            "--require-rehearsal",
        ],
        &["plan", "scene.toml", "--order", "random"],
        &["export", "scene.toml", "plan.json"],
        &["generate", "--difficulty", "11"],
        &["generate", "-n", "3"],
        &["run", "scene.toml", "--friction", "2:1"],
        &["length", "scene.toml", "--points", "1"],
    ];
    for arguments in bad {
        let ended = run(arguments);
        assert_eq!(
            ended.status.code(),
            Some(2),
            "{arguments:?}: {}",
            stderr(&ended)
        );
        assert_eq!(stdout(&ended), "", "{arguments:?}");
    }
}

#[test]
fn new_writes_a_scene_that_plans_and_never_overwrites() {
    let folder = tempfile::tempdir().expect("a folder");
    let hall = folder.path().join("halls/mine");
    assert_eq!(run(&["new", text(&hall)]).status.code(), Some(0));
    assert_eq!(files_below(folder.path()), ["halls/mine/scene.toml"]);

    let scene = hall.join("scene.toml");
    let out = folder.path().join("out");
    let planned = run(&["plan", text(&scene), "-o", text(&out), "--no-rehearsal"]);
    assert_eq!(planned.status.code(), Some(0), "{}", stderr(&planned));

    std::fs::write(&scene, "mine").expect("written");
    let again = run(&["new", text(&hall)]);
    assert_eq!(again.status.code(), Some(8));
    assert!(stderr(&again).contains("not overwritten"));
    assert_eq!(std::fs::read_to_string(&scene).expect("read"), "mine");
}

#[test]
fn completions_know_the_commands() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = stdout(&run(&["completions", shell]));
        assert!(script.contains("net-length"), "{shell}");
    }
}

#[test]
fn every_command_prints_one_json_object() {
    let folder = tempfile::tempdir().expect("a folder");
    let (_scene_folder, scene) = folder_with(SMALL);
    let out = folder.path().join("out");
    let plan = out.join("plan.json");
    let short = folder.path().join("short");
    let hall = folder.path().join("hall");
    let made = folder.path().join("made");
    let mjcf = folder.path().join("run.xml");
    let driven = folder.path().join("run");
    let calls: [&[&str]; 14] = [
        &[
            "plan",
            text(&scene),
            "-o",
            text(&out),
            "--no-rehearsal",
            "--json",
        ],
        &["check", text(&scene), text(&plan), "--json"],
        &["new", text(&hall), "--json"],
        &["new", text(&hall), "--json"],
        &["completions", "bash", "--json"],
        &["plan", "missing.toml", "--json"],
        &["check", text(&scene), "missing.json", "--json"],
        &[
            "plan",
            text(&scene),
            "-o",
            text(&short),
            "--net-length",
            "0.5",
            "--json",
        ],
        &["rehearse", text(&scene), text(&plan), "--quick", "--json"],
        &[
            "run",
            text(&scene),
            text(&plan),
            "--trials",
            "1",
            "--quick",
            "-o",
            text(&driven),
            "--json",
        ],
        &[
            "monte-carlo",
            text(&scene),
            text(&plan),
            "--runs",
            "2",
            "--json",
        ],
        &[
            "export",
            text(&scene),
            text(&plan),
            "--mjcf",
            text(&mjcf),
            "--json",
        ],
        &[
            "length",
            text(&scene),
            "--points",
            "3",
            "-o",
            text(&out),
            "--json",
        ],
        &[
            "generate",
            "--difficulty",
            "1",
            "-n",
            "60",
            "-o",
            text(&made),
            "--json",
        ],
    ];
    let codes = [0, 0, 0, 8, 0, 3, 3, 4, 0, 0, 0, 0, 0, 0];
    for (arguments, code) in calls.iter().zip(codes) {
        let ended = run(arguments);
        assert_eq!(
            ended.status.code(),
            Some(code),
            "{arguments:?}: {}",
            stderr(&ended)
        );
        let object: Value = serde_json::from_str(&stdout(&ended)).expect("one JSON object");
        assert_eq!(object["exit_code"], code, "{arguments:?}");
        assert_eq!(object["ok"], code == 0, "{arguments:?}");
        assert_eq!(object.get("error").is_some(), code != 0, "{arguments:?}");
    }
}

#[test]
fn studies_write_their_files_and_no_other() {
    let (folder, scene) = folder_with(SMALL);
    let plan = folder.path().join("plan/plan.json");
    let run_in = |name: &str, arguments: &[&str]| {
        let out = folder.path().join(name);
        let mut all = arguments.to_vec();
        all.extend(["-o", text(&out)]);
        let ended = run(&all);
        assert_eq!(ended.status.code(), Some(0), "{all:?}: {}", stderr(&ended));
        files_below(&out)
    };
    let (scene, plan) = (text(&scene), text(&plan));
    run_in("plan", &["plan", scene, "--no-rehearsal"]);
    assert_eq!(
        run_in("rehearsal", &["rehearse", scene, plan, "--quick"]),
        ["report.html"]
    );
    assert_eq!(
        run_in("run", &["run", scene, plan, "--trials", "1", "--quick"]),
        ["execution.json", "metadata.yaml", "report.html", "run.mcap"]
    );
    assert_eq!(
        run_in("length", &["length", scene, "--points", "2"]),
        ["length.csv", "length.json", "length.svg"]
    );
    assert_eq!(
        run_in("table", &["monte-carlo", scene, plan, "--runs", "1"]),
        ["monte-carlo.json"]
    );
    assert_eq!(
        run_in("made", &["generate", "-n", "60"]),
        ["scene.toml", "witness.json"]
    );
}

#[test]
fn nothing_but_the_summary_is_printed_into_a_pipe() {
    let (folder, scene) = folder_with(SMALL);
    let out = folder.path().join("out");
    let ended = run(&["plan", text(&scene), "-o", text(&out), "--no-rehearsal"]);
    assert_eq!(ended.status.code(), Some(0));
    assert_eq!(stderr(&ended), "", "progress is for terminals");
    let said = stdout(&ended);
    assert!(!said.contains('\u{1b}') && !said.contains('\r'), "{said:?}");
    for word in [
        "net",
        "paths",
        "drive",
        "cost J",
        "tightest claims",
        "took",
        "plan.json",
    ] {
        assert!(said.contains(word), "the summary lacks {word}: {said}");
    }
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_fault() {
    let mut child = program(&["completions", "zsh"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let ended = child.wait_with_output().expect("the program ends");
    assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
    assert_eq!(stderr(&ended), "");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_reported() {
    let full = std::fs::OpenOptions::new()
        .write(true)
        .open("/dev/full")
        .expect("/dev/full");
    let ended = program(&["completions", "bash"])
        .stdout(full)
        .output()
        .expect("the program starts");
    assert_eq!(ended.status.code(), Some(8));
}

#[test]
fn an_output_folder_that_cannot_be_made_is_reported_before_planning() {
    let (folder, scene) = folder_with(SMALL);
    let file = folder.path().join("file");
    std::fs::write(&file, "").expect("written");
    let ended = run(&[
        "plan",
        text(&scene),
        "-o",
        text(&file.join("out")),
        "--no-rehearsal",
    ]);
    assert_eq!(ended.status.code(), Some(8), "{}", stderr(&ended));
    assert!(stderr(&ended).contains(text(&file)));
}

#[cfg(unix)]
#[test]
fn control_c_ends_with_130_and_leaves_no_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    // The greatest scene of the library: still at work when the signal comes.
    let scene = library_scene("authors-simulation");
    let mut child = program(&[
        "plan",
        text(&scene),
        "-o",
        text(&out),
        "--waypoints",
        "20000",
    ])
    .stdout(Stdio::piped())
    .stderr(Stdio::piped())
    .spawn()
    .expect("the program starts");
    std::thread::sleep(std::time::Duration::from_millis(300));
    program::interrupt(&child);
    assert_eq!(child.wait().expect("the program ends").code(), Some(130));
    assert_eq!(files_below(folder.path()), Vec::<String>::new());
}

#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_cannot_be_written_to_is_reported_before_planning() {
    // Planning this ends with 4; the folder exists, but the system makes no files in it.
    let (_folder, scene) = folder_with(SMALL.replace("length = 1.2", "length = 0.5"));
    for command in ["plan", "run", "length"] {
        let ended = run(&[command, text(&scene), "-o", "/proc/self/fdinfo"]);
        assert_eq!(
            ended.status.code(),
            Some(8),
            "{command}: {}",
            stderr(&ended)
        );
        assert!(stderr(&ended).contains("/proc/self/fdinfo"), "{command}");
    }
}

#[test]
fn a_failed_plan_sets_the_earlier_one_aside_and_says_so() {
    let (folder, scene) = folder_with(SMALL);
    let out = folder.path().join("out");
    let plan = |more: &[&str]| {
        let mut arguments = vec!["plan", text(&scene), "-o", text(&out), "--no-rehearsal"];
        arguments.extend(more);
        run(&arguments)
    };
    assert_eq!(plan(&[]).status.code(), Some(0));
    let names = files_below(&out);
    std::fs::write(out.join("notes.txt"), "mine").expect("written");
    let earlier: Vec<String> = (names.iter())
        .map(|name| format!("earlier/{name}"))
        .collect();
    let mut expected = earlier.clone();
    expected.push("notes.txt".to_owned());
    let with_bad_input = expected.clone();
    // A proof comes with pictures.
    expected.extend(["failed.html", "failed.svg", "infeasible.json"].map(str::to_owned));
    expected.sort();

    let failed = plan(&["--net-length", "0.5", "--json"]);
    assert_eq!(failed.status.code(), Some(4));
    assert_eq!(files_below(&out), expected);
    let object: Value = serde_json::from_str(&stdout(&failed)).expect("JSON");
    let aside = out.join("earlier").display().to_string();
    assert_eq!(object["details"]["set_aside"], aside.as_str());
    assert!(stderr(&failed).contains(&aside), "{}", stderr(&failed));
    // A second failure has nothing to move and leaves what is there.
    assert_eq!(plan(&["--net-length", "0.5"]).status.code(), Some(4));
    assert_eq!(files_below(&out), expected);
    // A file that is not a scene fails in the same way.
    assert_eq!(plan(&[]).status.code(), Some(0));
    assert!(!out.join("failed.svg").exists(), "there is a plan now");
    std::fs::write(&scene, "nothing").expect("written");
    assert_eq!(plan(&[]).status.code(), Some(3));
    assert_eq!(files_below(&out), with_bad_input);
}

#[cfg(unix)]
#[test]
fn control_c_sets_the_earlier_plan_aside() {
    let (folder, small) = folder_with(SMALL);
    let out = folder.path().join("out");
    let ended = run(&["plan", text(&small), "-o", text(&out), "--no-rehearsal"]);
    assert_eq!(ended.status.code(), Some(0));
    let scene = library_scene("authors-simulation");
    let mut child = program(&[
        "plan",
        text(&scene),
        "-o",
        text(&out),
        "--waypoints",
        "20000",
    ])
    .stdout(Stdio::piped())
    .stderr(Stdio::piped())
    .spawn()
    .expect("the program starts");
    std::thread::sleep(std::time::Duration::from_millis(300));
    program::interrupt(&child);
    assert_eq!(child.wait().expect("the program ends").code(), Some(130));
    assert!(
        files_below(&out)
            .iter()
            .all(|name| name.starts_with("earlier/"))
    );
    assert!(out.join("earlier/plan.json").is_file());
}

#[cfg(unix)]
#[test]
fn an_interrupted_table_has_no_rows_of_nothing() {
    let (folder, scene) = folder_with(SMALL);
    let out = folder.path().join("out");
    let ended = run(&["plan", text(&scene), "-o", text(&out), "--no-rehearsal"]);
    assert_eq!(ended.status.code(), Some(0));
    let plan = out.join("plan.json");
    let child = program(&[
        "monte-carlo",
        text(&scene),
        text(&plan),
        "--runs",
        "1000000",
        "--json",
    ])
    .stdout(Stdio::piped())
    .stderr(Stdio::piped())
    .spawn()
    .expect("the program starts");
    std::thread::sleep(std::time::Duration::from_millis(500));
    program::interrupt(&child);
    let ended = child.wait_with_output().expect("the program ends");
    assert_eq!(ended.status.code(), Some(130), "{}", stderr(&ended));
    let table: Value = serde_json::from_str(&stdout(&ended)).expect("JSON");
    assert_eq!(table["interrupted"], true);
    let rows = table["rows"].as_array().expect("rows");
    // A million drives of the first law take hours: the others had none.
    assert!(rows.len() <= 1, "{rows:?}");
    assert!(
        rows.iter()
            .all(|row| row["runs"].as_u64() > Some(0) && row["rms"]["p50"].is_number())
    );
}

#[test]
fn run_refuses_a_plan_that_cannot_be_proven() {
    let (folder, scene) = folder_with(SMALL);
    let out = folder.path().join("out");
    let ended = run(&["plan", text(&scene), "-o", text(&out), "--no-rehearsal"]);
    assert_eq!(ended.status.code(), Some(0));
    let path = out.join("plan.json");
    let mut plan = json(&path);
    let longer = plan["net_length"].as_f64().expect("a number") + 0.1;
    plan["net_length"] = longer.into();
    std::fs::write(&path, plan.to_string()).expect("written");
    let driven = folder.path().join("run");
    let mut arguments = vec![
        "run",
        text(&scene),
        text(&path),
        "--trials",
        "1",
        "--quick",
        "-o",
        text(&driven),
        "--json",
    ];
    let refused = run(&arguments);
    assert_eq!(refused.status.code(), Some(6), "{}", stderr(&refused));
    let object: Value = serde_json::from_str(&stdout(&refused)).expect("JSON");
    assert_eq!(object["details"]["claim"], "net_length");
    assert_eq!(files_below(&driven), Vec::<String>::new());
    arguments.push("--unproven");
    let ended = run(&arguments);
    assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
    assert!(stdout(&ended).contains("cannot be proven"));
}

#[test]
fn lengths_that_are_proven_infeasible_end_with_4() {
    let (folder, scene) = folder_with(SMALL);
    let out = folder.path().join("out");
    let ended = run(&[
        "length",
        text(&scene),
        "--from",
        "0.4",
        "--to",
        "0.5",
        "--points",
        "2",
        "-o",
        text(&out),
        "--json",
    ]);
    assert_eq!(ended.status.code(), Some(4), "{}", stderr(&ended));
    let curve: Value = serde_json::from_str(&stdout(&ended)).expect("JSON");
    let points = curve["points"].as_array().expect("points");
    assert!(
        points.len() == 2 && points.iter().all(|point| point["proven"] == true),
        "{points:?}"
    );
    assert!(curve["minimum"]["cost"]["total"].is_null() || curve["ok"] == false);

    // The object is pinned to the obstacle, whatever the net.
    let (_pinned_folder, pinned) = folder_with(SMALL.replace("2.2, 0.4]", "2.2, 1.3]"));
    let ended = run(&[
        "length",
        text(&pinned),
        "--points",
        "2",
        "-o",
        text(&out),
        "--json",
    ]);
    assert_eq!(ended.status.code(), Some(4), "{}", stderr(&ended));
    let refused: Value = serde_json::from_str(&stdout(&ended)).expect("JSON");
    assert_eq!(refused["details"]["proof"], "object_pinned");
    assert_eq!(refused["details"]["object"], 0);
}

#[cfg(unix)]
#[test]
fn control_c_keeps_the_lengths_that_are_solved() {
    let (folder, scene) = folder_with(SMALL);
    // How fast this machine is is not known: the signal comes later and later until some lengths are solved, and not all.
    let kept = [300, 600, 1200, 2400, 4800, 9600]
        .iter()
        .find_map(|&milliseconds| {
            let out = folder.path().join(milliseconds.to_string());
            let child = program(&[
                "length",
                text(&scene),
                "--points",
                "1000",
                "-o",
                text(&out),
                "--json",
            ])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
            std::thread::sleep(std::time::Duration::from_millis(milliseconds));
            program::interrupt(&child);
            let ended = child.wait_with_output().expect("the program ends");
            assert_eq!(ended.status.code(), Some(130), "{}", stderr(&ended));
            let object: Value = serde_json::from_str(&stdout(&ended)).expect("JSON");
            let points = object["points"].as_array().map_or(0, Vec::len);
            (points > 0).then_some((out, object))
        });
    let (out, object) = kept.expect("no length was solved in time");
    assert_eq!(object["interrupted"], true);
    assert!(object["points"].as_array().expect("points").len() < 1000);
    let file = json(&out.join("length.json"));
    assert_eq!(file["points"], object["points"]);
}
