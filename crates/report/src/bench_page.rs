//! The page about a folder of scenes that were planned.

use crate::page::table::{close_table, number, open_card, open_table_of};
use crate::page::{STYLE as PAGE, head};
use crate::svg::{Writer, escape};
use pairtrawl_model::numbers::{cost, duration, memory};
use pairtrawl_model::{Bench, BenchGroup, BenchScene};

/// What is particular to this page.
const STYLE: &str = include_str!("../assets/bench.css");

/// One HTML page without any external resource but the pages and pictures of the scenes beside it: figures of each group,
/// scenes without a plan with what the planner says of them, all scenes.
pub fn bench_html(bench: &Bench) -> String {
    let mut w = Writer::default();
    w.raw("<!DOCTYPE html>\n");
    w.open("html", &[("lang", &"en")]);
    head(&mut w, &bench.folder, &[PAGE, STYLE]);
    w.open("body", &[]);
    header(&mut w, bench);
    w.open("main", &[]);
    groups(&mut w, bench);
    failures(&mut w, bench);
    scenes(&mut w, bench);
    w.finish()
}

fn header(w: &mut Writer, bench: &Bench) {
    let total = &bench.total;
    w.open("header", &[]);
    w.text("h1", &[], &bench.folder);
    let facts = format!(
        "{} of {} scenes, {} at once, threads of each: {}; pairtrawl plan {}",
        bench.scenes.len(),
        bench.wanted,
        bench.jobs,
        bench.threads,
        bench.arguments.join(" ")
    );
    w.text("p", &[("class", &"facts")], &facts);
    w.open("div", &[("class", &"badges")]);
    let mut badge = |good: bool, text: String| {
        let class = if good { "badge good" } else { "badge bad" };
        w.text("span", &[("class", &class)], &text);
    };
    let all = total.planned == total.scenes;
    badge(
        all,
        format!("{} of {} planned", total.planned, total.scenes),
    );
    let gathered = format!("{} of {} objects gathered", total.gathered, total.objects);
    badge(total.left_not_found == 0 && all, gathered);
    badge(total.invalid == 0, format!("{} invalid", total.invalid));
    if total.rehearsed > 0 {
        let passed = format!("{} of {} rehearsals passed", total.passed, total.rehearsed);
        badge(total.passed == total.rehearsed, passed);
    }
    if bench.interrupted {
        badge(false, "interrupted".to_owned());
    }
    w.close();
    w.close();
}

fn groups(w: &mut Writer, bench: &Bench) {
    open_card(w, "groups", "Groups");
    let heads = [
        ("group", false),
        ("planned", true),
        ("gathered", true),
        ("left, proven", true),
        ("left, not found", true),
        ("iterations p50 / 90 % / most", true),
        ("time p50 / 90 % / most", true),
        ("memory", true),
        ("no plan", false),
    ];
    open_table_of(w, &heads);
    for group in bench.groups.iter().chain([&bench.total]) {
        let class = if std::ptr::eq(group, &bench.total) {
            "total"
        } else {
            ""
        };
        w.open("tr", &[("class", &class)]);
        group_cells(w, group);
        w.close();
    }
    close_table(w);
    w.close();
}

fn group_cells(w: &mut Writer, group: &BenchGroup) {
    w.text("th", &[("scope", &"row")], &group.name);
    number(w, &format!("{} / {}", group.planned, group.scenes));
    number(w, &format!("{} / {}", group.gathered, group.objects));
    number(w, &group.left_proven.to_string());
    number(w, &group.left_not_found.to_string());
    let iterations = group.iterations.map(|all| all.map(|n| n.to_string()));
    number(
        w,
        &iterations.map_or_else(String::new, |all| all.join(" / ")),
    );
    let times = group.seconds.map(|all| all.map(duration));
    number(w, &times.map_or_else(String::new, |all| all.join(" / ")));
    number(w, &group.memory.map_or_else(String::new, memory));
    let ends: Vec<String> = (group.failures.iter())
        .map(|f| format!("{} \u{d7} {}", f.scenes, end(f.exit_code)))
        .collect();
    w.text("td", &[], &ends.join(", "));
}

fn failures(w: &mut Writer, bench: &Bench) {
    let mut failed = bench.scenes.iter().filter(|s| !s.is_planned()).peekable();
    if failed.peek().is_none() {
        return;
    }
    open_card(w, "no-plan", "Scenes without a plan");
    w.open("div", &[("class", &"pictures")]);
    for scene in failed {
        w.open("figure", &[]);
        if let Some(picture) = &scene.picture {
            w.empty(
                "img",
                &[
                    ("src", &address(picture)),
                    ("loading", &"lazy"),
                    ("alt", &format_args!("The best attempt at {}", scene.name)),
                ],
            );
        }
        w.open("figcaption", &[]);
        name(w, scene);
        let message = scene.message.as_deref().unwrap_or_default();
        let message = format!("{}: {message}", end(scene.exit_code));
        w.text("span", &[("class", &"meaning")], &message);
        w.close();
        w.close();
    }
    w.close();
    w.close();
}

fn scenes(w: &mut Writer, bench: &Bench) {
    open_card(w, "scenes", "All scenes");
    let heads = [
        ("scene", false),
        ("ended", false),
        ("gathered", true),
        ("left, proven", true),
        ("left, not found", true),
        ("rehearsal", false),
        ("J", true),
        ("iterations", true),
        ("time", true),
        ("memory", true),
    ];
    open_table_of(w, &heads);
    for scene in &bench.scenes {
        w.open("tr", &[]);
        w.open("th", &[("scope", &"row")]);
        name(w, scene);
        w.close();
        let ended = match scene.valid {
            Some(false) => "INVALID".to_owned(),
            Some(true) => "valid".to_owned(),
            None => end(scene.exit_code),
        };
        w.text("td", &[], &ended);
        let objects = scene.objects.map_or("?".to_owned(), |n| n.to_string());
        number(w, &format!("{} / {objects}", scene.gathered));
        number(w, &scene.left_proven.to_string());
        number(w, &scene.left_not_found.to_string());
        w.text("td", &[], scene.rehearsal.as_deref().unwrap_or_default());
        number(w, &scene.cost.map_or_else(String::new, cost));
        let iterations = scene.iterations.map(|n| n.to_string());
        number(w, &iterations.unwrap_or_default());
        number(w, &duration(scene.seconds));
        number(w, &scene.memory.map_or_else(String::new, memory));
        w.close();
    }
    close_table(w);
    w.close();
}

/// The scene's name, a link where it has a page.
fn name(w: &mut Writer, scene: &BenchScene) {
    match &scene.page {
        Some(page) => {
            w.raw(&format!("<a href=\"{}\">", escape(&address(page))));
            w.raw(&escape(&scene.name));
            w.raw("</a>\n");
        }
        None => w.text("span", &[], &scene.name),
    }
}

/// A relative path as an address: bytes that mean something in addresses are written as numbers.
fn address(path: &str) -> String {
    let mut out = String::with_capacity(path.len());
    for byte in path.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'/' | b'.' | b'-' | b'_' => {
                out.push(char::from(byte));
            }
            _ => out.push_str(&format!("%{byte:02X}")),
        }
    }
    out
}

fn end(exit_code: Option<i32>) -> String {
    exit_code.map_or("ended from outside".to_owned(), |code| {
        format!("exit {code}")
    })
}
