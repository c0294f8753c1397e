//! `pairtrawl reproduce`, on the parts of it that are quick.

mod program;

use pairtrawl_reproduction::evidence::Evidence;
use pairtrawl_reproduction::verdict::judge;
use program::{files_below, json, run, stderr, stdout, text};
use serde_json::Value;

#[test]
fn verdicts_follow_from_the_numbers_that_are_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let ended = run(&["reproduce", "--quick", "--only", "setup", "-o", text(&out)]);
    assert_eq!(ended.status.code(), Some(0), "{}", stderr(&ended));
    // What is finished is kept while the rest is made, and no longer.
    assert_eq!(
        files_below(&out),
        ["reproduction.html", "reproduction.json"]
    );
    let file = json(&out.join("reproduction.json"));
    let verdicts = file["verdicts"].as_array().expect("a list");
    assert!(!verdicts.is_empty());
    for verdict in verdicts {
        let numbers = verdict["evidence"].as_object().expect("an object");
        let add = |all: Evidence, (name, value): (&String, &Value)| {
            all.with(name, value.as_f64().unwrap_or(f64::NAN), "")
        };
        let evidence = numbers.iter().fold(Evidence::default(), add);
        let key = verdict["key"].as_str().expect("a text");
        let judged = judge(key, &evidence);
        assert_eq!(verdict["verdict"], judged.name(), "{key}");
        assert!(stdout(&ended).contains(judged.words()), "{key}");
    }
    let page = std::fs::read_to_string(out.join("reproduction.html")).expect("a page");
    assert!(!page.contains("http://") && !page.contains("https://") && !page.contains("src="));
}

#[test]
fn what_cannot_be_reproduced_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let ended = run(&["reproduce", "--only", "figures", "-o", text(&out)]);
    assert_eq!(ended.status.code(), Some(2));
    assert!(stderr(&ended).contains("figures") && stderr(&ended).contains("net-length"));

    let data = folder.path().join("data");
    std::fs::create_dir(&data).expect("a folder");
    let with_data = ["reproduce", "--authors-data", text(&data), "-o", text(&out)];
    let ended = run(&with_data);
    assert_eq!(ended.status.code(), Some(3), "{}", stderr(&ended));
    assert!(stderr(&ended).contains("experiment_traj.csv"));

    for name in [
        "experiment_traj.csv",
        "simulation_traj.csv",
        "experiment_tracked_right.csv",
    ] {
        std::fs::write(data.join(name), "0,0,1,0\n0,nonsense\n").expect("written");
    }
    let ended = run(&with_data);
    assert_eq!(ended.status.code(), Some(3), "{}", stderr(&ended));
    assert!(stderr(&ended).contains("line 2"), "{}", stderr(&ended));
    assert!(!out.exists());
}
