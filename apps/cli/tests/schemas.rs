//! The JSON schemas in `docs/formats` are those of the types, what is written and printed fits them, and what the help
//! names is in them. `cargo run -- schemas docs/formats` brings them up to date.

mod program;

use jsonschema::Validator;
use program::{SMALL, files_below, folder_with, json, pinned, run, stderr, stdout, text};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn schema(name: &str) -> Value {
    json(&repository().join(format!("docs/formats/{name}.schema.json")))
}

fn validator(name: &str) -> Validator {
    jsonschema::validator_for(&schema(name)).expect("a schema")
}

fn expect_fit(name: &str, value: &Value) {
    let errors: Vec<String> = (validator(name).iter_errors(value))
        .map(|error| format!("{} at {}", error, error.instance_path()))
        .collect();
    assert!(errors.is_empty(), "{name}: {errors:#?}");
}

#[test]
fn the_schemas_in_the_repository_are_those_of_the_types() {
    let folder = tempfile::tempdir().expect("a folder");
    let ended = run(&["schemas", text(folder.path())]);
    assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
    let kept = repository().join("docs/formats");
    let names = files_below(folder.path());
    let schemas: Vec<String> = (files_below(&kept).into_iter())
        .filter(|name| name.ends_with(".schema.json"))
        .collect();
    assert_eq!(schemas, names, "the schemas of docs/formats");
    for name in names {
        let read = |folder: &Path| std::fs::read_to_string(folder.join(&name)).expect("a schema");
        assert!(
            read(&kept) == read(folder.path()),
            "docs/formats/{name} is stale: cargo run -- schemas docs/formats"
        );
    }
}

#[test]
fn what_is_printed_and_written_fits_the_schemas() {
    let (folder, scene) = folder_with(SMALL);
    let out = folder.path().join("out");
    let plan = out.join("plan.json");
    let inside = |name: &str| folder.path().join(name).display().to_string();
    let (scene, plan_path, out) = (text(&scene), text(&plan), text(&out));
    let length = ["length", scene, "--points", "3", "--compare", "-o", out];
    let run_once = [
        "run", scene, plan_path, "--trials", "1", "--quick", "-o", out,
    ];
    let (_pinned_folder, pinned) = folder_with(pinned());
    let pinned = text(&pinned);
    let (short, left) = (inside("short"), inside("left"));
    let proofs = format!("{short}/infeasible.json");
    let partly = format!("{left}/plan.json");
    let calls: [(&str, i32, &[&str]); 24] = [
        (
            "reproduce",
            0,
            &["reproduce", "--quick", "--only", "setup", "-o", out],
        ),
        ("plan", 0, &["plan", scene, "-o", out, "--no-rehearsal"]),
        ("check", 0, &["check", scene, plan_path]),
        ("rehearse", 0, &["rehearse", scene, plan_path, "--quick"]),
        ("run", 0, &run_once),
        (
            "monte-carlo",
            0,
            &["monte-carlo", scene, plan_path, "--runs", "2", "-o", out],
        ),
        (
            "export",
            0,
            &["export", scene, plan_path, "--mjcf", &inside("run.xml")],
        ),
        ("length", 0, &length),
        (
            "generate",
            0,
            &[
                "generate",
                "--difficulty",
                "1",
                "-n",
                "60",
                "-o",
                &inside("made"),
            ],
        ),
        (
            "generate",
            0,
            &["generate", "--kind", "hall", "-o", &inside("natural")],
        ),
        (
            "bench-plan",
            0,
            &[
                "bench-plan",
                &inside("natural"),
                "--no-rehearsal",
                "-o",
                &inside("bench"),
            ],
        ),
        ("new", 0, &["new", &inside("hall")]),
        ("completions", 0, &["completions", "fish"]),
        ("error", 8, &["new", &inside("hall")]),
        (
            "error",
            3,
            &["plan", "missing.toml", "-o", &inside("missing")],
        ),
        ("error", 3, &["check", scene, "missing.json"]),
        ("error", 4, &["plan", pinned, "-o", &short]),
        ("check", 0, &["check", pinned, &proofs]),
        ("show", 0, &["show", pinned, "-o", &left]),
        (
            "plan",
            0,
            &[
                "plan",
                pinned,
                "-o",
                &left,
                "--leave",
                "unreachable",
                "--no-rehearsal",
            ],
        ),
        ("check", 0, &["check", pinned, &partly]),
        (
            "error",
            5,
            &[
                "plan",
                scene,
                "-o",
                &inside("late"),
                "--time-limit",
                "0.000001",
            ],
        ),
        ("error", 2, &["plan", scene, "--waypoints", "2"]),
        (
            "error",
            2,
            &[
                "length",
                scene,
                "--from",
                "2",
                "--to",
                "1",
                "-o",
                &inside("none"),
            ],
        ),
    ];
    for (name, code, arguments) in calls {
        let mut arguments = arguments.to_vec();
        arguments.push("--json");
        let ended = run(&arguments);
        let said = stdout(&ended);
        assert_eq!(
            ended.status.code(),
            Some(code),
            "{arguments:?}: {}",
            stderr(&ended)
        );
        let object: Value = serde_json::from_str(&said).expect("one JSON object");
        expect_fit(&format!("output-{name}"), &object);
        assert_eq!(object["ok"], code == 0, "{arguments:?}");
        // The header comes first, in the same order for all.
        assert!(said.starts_with("{\"ok\":"), "{said}");
    }
    for name in ["plan", "execution", "length", "monte-carlo", "reproduction"] {
        expect_fit(name, &json(&Path::new(out).join(format!("{name}.json"))));
    }
    expect_fit("infeasible", &json(Path::new(&proofs)));
    expect_fit("plan", &json(Path::new(&partly)));
    expect_fit("plan", &json(&folder.path().join("made/witness.json")));
    expect_fit("bench", &json(&folder.path().join("bench/bench.json")));
    // Every field of the format is written.
    let properties = schema("plan")["properties"].clone();
    let written = json(&plan);
    for name in properties.as_object().expect("properties").keys() {
        // It is there only when something is left.
        let needed = name != "left_out";
        assert!(
            !needed || written.get(name).is_some(),
            "plan.json lacks {name}"
        );
    }
}

#[test]
fn a_foreign_plan_and_a_broken_one() {
    let mut plan = serde_json::json!({
        "format": "pairtrawl-plan/1", "net_length": 1.2,
        "left": [[0.0, 1.0, 0.0], [0.04, 1.0, 0.0]], "right": [[0.0, 0.3, 0.0], [0.04, 0.3, 0.0]],
    });
    expect_fit("plan", &plan);
    let validator = validator("plan");
    plan["left"][1] = serde_json::json!([0.04, 1.0]);
    assert!(!validator.is_valid(&plan), "a pose of two numbers");
    plan["left"][1] = serde_json::json!([0.04, 1.0, 0.0]);
    plan["format"] = "pairtrawl-plan/2".into();
    assert!(!validator.is_valid(&plan), "another version");
}

fn scene_value(toml: &str) -> Value {
    let table: toml::Table = toml.parse().expect("TOML");
    serde_json::to_value(table).expect("JSON")
}

#[test]
fn scenes_of_the_library_fit_and_broken_ones_do_not() {
    let validator = validator("scene");
    let mut count = 0;
    for entry in std::fs::read_dir(repository().join("scenes")).expect("the library") {
        let path = entry.expect("an entry").path().join("scene.toml");
        if let Ok(text) = std::fs::read_to_string(&path) {
            expect_fit("scene", &scene_value(&text));
            count += 1;
        }
    }
    assert!(count >= 14, "{count} scenes");
    assert!(validator.is_valid(&scene_value(SMALL)));
    for (part, instead) in [
        ("length = 1.2", "lenght = 1.2"),
        ("heading = 0.0", ""),
        ("size = [0.05, 0.05]", "size = [0.05, 0.05]\nradius = 0.1"),
        ("box = [1.8, 0.0, 2.2, 0.4]", "box = [1.8, 0.0, 2.2]"),
        ("[net]", "[planner]\nmax_stepp = 0.1\n[net]"),
        ("max = [4.0, 3.0]", ""),
        ("pairtrawl-scene/1", "pairtrawl-scene/2"),
    ] {
        let broken = scene_value(&SMALL.replace(part, instead));
        assert!(
            !validator.is_valid(&broken),
            "{instead:?} instead of {part:?} was taken"
        );
    }
}

/// Keys of an object schema, through a reference.
fn keys(root: &Value, schema: &Value) -> BTreeMap<String, Value> {
    let schema = match schema["$ref"].as_str() {
        Some(reference) => root
            .pointer(reference.trim_start_matches('#'))
            .expect("a definition"),
        None => schema,
    };
    let properties = schema["properties"]
        .as_object()
        .cloned()
        .unwrap_or_default();
    properties.into_iter().collect()
}

#[test]
fn every_json_key_that_the_help_names_is_in_the_output() {
    let help = stdout(&run(&["--help"]));
    let (_, list) = help.split_once("Commands:\n").expect("a list of commands");
    let commands = (list.lines())
        .map_while(|line| line.strip_prefix("  "))
        .filter_map(|line| line.split(' ').next())
        .filter(|name| !name.is_empty() && *name != "help");
    let mut paths = 0;
    for command in commands {
        let help = stdout(&run(&[command, "--help"]));
        for line in help.lines() {
            let Some((_, expression)) = line.split_once("jq ") else {
                continue;
            };
            let root = schema(&format!("output-{command}"));
            let mut here = root.clone();
            for key in expression.trim().trim_start_matches('.').split('.') {
                here = (keys(&root, &here).remove(key))
                    .unwrap_or_else(|| panic!("`{}`: the output has no {key}", line.trim()));
            }
            paths += 1;
        }
    }
    assert!(paths > 0, "no help names a key");
}

#[test]
fn the_schema_of_a_scene_has_the_keys_of_the_notation() {
    let notation = std::fs::read_to_string(repository().join("NOTATION.md")).expect("NOTATION.md");
    let root = schema("scene");
    for table in ["planner", "robot", "net", "physics"] {
        let (_, rest) = (notation.split_once(&format!("### `[{table}]`\n"))).expect("a table");
        let section = rest.split("\n### ").next().unwrap_or(rest);
        let mut named: Vec<String> = (section.lines())
            .filter(|line| line.starts_with('|'))
            .filter_map(|line| {
                line.split('|')
                    .map(str::trim)
                    .find(|cell| cell.starts_with('`'))
            })
            .map(|cell| cell.trim_matches('`').to_owned())
            .collect();
        named.sort();
        let known: Vec<String> = keys(&root, &root["properties"][table])
            .into_keys()
            .collect();
        assert_eq!(named, known, "[{table}]");
    }
}
