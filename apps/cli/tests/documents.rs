//! What the documents say is what the program does.

use pairtrawl::files::{LoadedScene, parse_scene};
use std::path::Path;

fn document(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(name);
    std::fs::read_to_string(&path).expect("the document is there")
}

fn scene_with(table: &str, line: &str) -> LoadedScene {
    let text = format!(
        "format = \"pairtrawl-scene/1\"\nobjects = []\n\
         [area]\nmin = [0.0, 0.0]\nmax = [4.0, 3.0]\n\
         [start]\nleft = [0.5, 1.85]\nright = [0.5, 1.15]\nheading = 0.0\n\
         [end]\nleft = [3.5, 1.85]\nright = [3.5, 1.15]\nheading = 0.0\n\
         [{table}]\n{line}\n"
    );
    parse_scene(&text, "scene").unwrap_or_else(|error| panic!("[{table}] {line}: {error}"))
}

/// Rows (key, default) of a table of keys in NOTATION.md.
fn rows(notation: &str, table: &str) -> Vec<(String, String)> {
    let heading = format!("### `[{table}]`\n");
    let (_, rest) = notation.split_once(&heading).expect("the heading is there");
    let section = rest.split("\n### ").next().unwrap_or(rest);
    let cells = |line: &str| {
        line.split('|')
            .map(|cell| cell.trim().to_owned())
            .collect::<Vec<_>>()
    };
    section
        .lines()
        .filter(|line| line.starts_with('|'))
        .map(cells)
        .filter(|cells| cells[2].starts_with('`'))
        .map(|cells| (cells[2].trim_matches('`').to_owned(), cells[3].clone()))
        .collect()
}

#[test]
fn notation_has_every_key_of_a_scene_with_its_default() {
    let notation = document("NOTATION.md");
    let plain = scene_with("physics", "").scene;
    let fields = |debug: String| debug.matches(": ").count();
    let tables = [
        ("planner", fields(format!("{:?}", plain.planner))),
        // `preset` is no field: it sets the others.
        ("robot", fields(format!("{:?}", plain.robot)) + 1),
        ("net", fields(format!("{:?}", plain.net))),
        ("physics", fields(format!("{:?}", plain.physics))),
    ];
    for (table, count) in tables {
        let rows = rows(&notation, table);
        assert_eq!(
            rows.len(),
            count,
            "keys of [{table}] in NOTATION.md: {rows:?}"
        );
        for (key, default) in rows {
            let default = default.replace("2/pi", "0.6366197723675814");
            if default.parse::<f64>().is_err() {
                // A default in words: the key must exist and change something.
                let other = match key.as_str() {
                    "start" => "[[0.3, 1.85], [0.3, 1.15]]",
                    "expansion_per" => "\"meter\"",
                    "leave" => "\"unreachable\"",
                    "preset" => "\"burger\"",
                    "body" => "[[-0.05, 0.0, 0.2]]",
                    _ => "7",
                };
                assert_ne!(
                    scene_with(table, &format!("{key} = {other}")).scene,
                    plain,
                    "{table}.{key}"
                );
                continue;
            }
            let same = scene_with(table, &format!("{key} = {default}")).scene;
            assert_eq!(same, plain, "{default} is not the default of {table}.{key}");
        }
    }
}

#[test]
fn the_readme_has_every_command_and_its_scene_can_be_read() {
    let readme = document("README.md");
    let help = std::process::Command::new(env!("CARGO_BIN_EXE_pairtrawl"))
        .arg("--help")
        .output()
        .expect("it starts");
    let help = String::from_utf8(help.stdout).expect("UTF-8");
    let (_, commands) = help.split_once("Commands:\n").expect("a list of commands");
    let names = commands
        .lines()
        .map_while(|line| line.strip_prefix("  "))
        .filter_map(|line| line.split(' ').next());
    let names: Vec<&str> = names
        .filter(|name| !name.is_empty() && *name != "help")
        .collect();
    assert!(names.len() >= 11, "{names:?}");
    for name in names {
        assert!(
            readme.contains(&format!("`pairtrawl {name}")),
            "the README lacks {name}"
        );
    }
    let (_, rest) = readme.split_once("```toml\n").expect("a scene");
    let scene = rest.split("```").next().unwrap_or(rest);
    assert!(parse_scene(scene, "README.md").is_ok());
}
