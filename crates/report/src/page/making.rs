//! How a plan came about: what it costs, its route, its solver, the time that it took.

use super::table::{close_table, named, number, open_card, open_table, row};
use crate::svg::Writer;
use crate::words;
use pairtrawl_model::{Summary, numbers};

/// The terms of J.
pub(super) fn cost(w: &mut Writer, summary: &Summary) {
    open_card(w, "cost", "Cost");
    open_table(w, &["term", "value", "share"]);
    let total = summary.cost.total();
    let terms = words::terms(&summary.cost);
    for (symbol, name, value) in terms.into_iter().chain([("J", "total", total)]) {
        let class = if symbol == "J" { "total" } else { "" };
        w.open("tr", &[("class", &class)]);
        named(w, symbol, name);
        number(w, &words::cost(value));
        let share = match total > 0.0 {
            true => format!("{:.1} %", 100.0 * value / total),
            false => "\u{2013}".to_owned(),
        };
        number(w, &share);
        w.close();
    }
    close_table(w);
    w.close();
}

/// Route, solver, stages.
pub(super) fn card(w: &mut Writer, summary: &Summary) {
    open_card(w, "making", "How it was planned");
    let chosen = match summary.net_length_chosen {
        true => "chosen by the planner",
        false => "given",
    };
    let rows = [
        (
            "net length",
            format!("{}, {chosen}", numbers::length(summary.net_length)),
        ),
        ("waypoints", summary.trajectory.len().to_string()),
        ("visiting order", words::visits(summary)),
        ("solver", words::solver(&summary.solver)),
        ("rehearsal", words::rehearsal(summary)),
    ];
    open_table(w, &["fact", "what"]);
    for (name, value) in rows.iter().filter(|(_, value)| !value.is_empty()) {
        row(w, name, &[value]);
    }
    close_table(w);
    if !summary.stages.is_empty() {
        open_table(w, &["stage", "time"]);
        for stage in &summary.stages {
            row(w, &stage.name, &[&numbers::duration(stage.seconds)]);
        }
        let total = summary.stages.iter().map(|s| s.seconds).sum();
        row(w, "together", &[&numbers::duration(total)]);
        close_table(w);
    }
    w.close();
}
