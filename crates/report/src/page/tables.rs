//! The tables of a page.

use crate::svg::Writer;
use crate::words;
use pairtrawl_geometry::Point;
use pairtrawl_model::{ClaimSummary, Event, ExecutionSummary, Summary};

/// The certificate; its places are buttons that take the map there.
pub(super) fn certificate(w: &mut Writer, summary: &Summary) {
    let claims = &summary.claims;
    section(w, "certificate", "Certificate");
    let held = claims.iter().filter(|c| c.claim.holds).count();
    let verdict = match (held, claims.len()) {
        (_, 0) => "No claim was checked.".to_owned(),
        (h, n) if h == n => {
            format!("All {n} claims hold, each proven by exact geometry over every step.")
        }
        (h, n) => format!("{} of {n} claims fail.", n - h),
    };
    w.text("p", &[], &verdict);
    open_table(w, &["claim", "holds", "margin", "tightest at"]);
    for c in claims {
        w.open(
            "tr",
            &[("class", &if c.claim.holds { "holds" } else { "fails" })],
        );
        w.open("th", &[("scope", &"row")]);
        w.text("code", &[], c.claim.id.name());
        w.text("span", &[("class", &"meaning")], c.meaning);
        w.close();
        w.text(
            "td",
            &[],
            if c.claim.holds {
                "\u{2713} yes"
            } else {
                "\u{2717} no"
            },
        );
        w.text(
            "td",
            &[("class", &"number")],
            &words::margin(c.claim.margin, c.unit),
        );
        w.open("td", &[]);
        claim_place(w, c);
        w.close();
        w.close();
    }
    close_table(w);
    w.close();
}

fn claim_place(w: &mut Writer, c: &ClaimSummary) {
    let step = c.claim.step.map(|s| format!("step {s}"));
    let time = c.time.map(|t| format!("{t:.1} s"));
    let place = c.claim.place.filter(|p| p.is_finite());
    let where_ = place.map(|p| format!("({:.2}, {:.2}) m", p.x, p.y));
    let words: Vec<String> = [step, time, where_].into_iter().flatten().collect();
    go_to(w, c.time, place, &words.join(", "));
    if !c.claim.detail.is_empty() {
        w.text("span", &[("class", &"meaning")], &c.claim.detail);
    }
}

/// A button that takes the player to a time and the map to a place, as far as both are known.
fn go_to(w: &mut Writer, time: Option<f64>, place: Option<Point>, label: &str) {
    let Some(time) = time.filter(|t| t.is_finite()) else {
        w.text("span", &[], label);
        return;
    };
    let place = place.map_or(String::new(), |p| format!("{:.3} {:.3}", p.x, p.y));
    let attributes: crate::svg::Attributes = &[
        ("type", &"button"),
        ("class", &"goto"),
        ("data-time", &format_args!("{time:.4}")),
        ("data-place", &place),
    ];
    w.text("button", attributes, label);
}

/// The terms of J.
pub(super) fn cost(w: &mut Writer, summary: &Summary) {
    section(w, "cost", "Cost");
    open_table(w, &["term", "value", "share"]);
    let total = summary.cost.total();
    for (symbol, name, value) in words::terms(&summary.cost) {
        w.open("tr", &[]);
        w.open("th", &[("scope", &"row")]);
        w.text("code", &[], symbol);
        w.text("span", &[("class", &"meaning")], name);
        w.close();
        w.text("td", &[("class", &"number")], &words::cost(value));
        let share = match total > 0.0 {
            true => format!("{:.1} %", 100.0 * value / total),
            false => "\u{2013}".to_owned(),
        };
        w.text("td", &[("class", &"number")], &share);
        w.close();
    }
    w.open("tr", &[("class", &"total")]);
    w.open("th", &[("scope", &"row")]);
    w.text("code", &[], "J");
    w.text("span", &[("class", &"meaning")], "total");
    w.close();
    w.text("td", &[("class", &"number")], &words::cost(total));
    w.text("td", &[("class", &"number")], "");
    w.close();
    close_table(w);
    w.close();
}

/// How the plan came about: route, solver, stages.
pub(super) fn making(w: &mut Writer, summary: &Summary) {
    section(w, "making", "How it was planned");
    let order: Vec<String> = summary.order.iter().map(|i| i.to_string()).collect();
    let solver = &summary.solver;
    let rows = [
        (
            "net length",
            format!(
                "{:.4} m, {}",
                summary.net_length,
                if summary.net_length_chosen {
                    "chosen by the planner"
                } else {
                    "given"
                }
            ),
        ),
        (
            "waypoints",
            format!(
                "{}, one every {:.3} s",
                summary.trajectory.len(),
                summary.trajectory.step_time
            ),
        ),
        ("circles", summary.circles.len().to_string()),
        ("visiting order", order.join(" \u{2192} ")),
        (
            "solver",
            format!(
                "{} after {} iterations, KKT error {:.1e}, {}",
                words::status(solver.status),
                solver.iterations,
                solver.kkt_error,
                words::duration(solver.seconds)
            ),
        ),
        ("rehearsal", words::rehearsal(&summary.rehearsal)),
    ];
    open_table(w, &["fact", "what"]);
    for (name, value) in rows.iter().filter(|(_, value)| !value.is_empty()) {
        row(w, name, &[value]);
    }
    close_table(w);
    if !summary.stages.is_empty() {
        open_table(w, &["stage", "time"]);
        for stage in &summary.stages {
            row(w, &stage.name, &[&words::duration(stage.seconds)]);
        }
        let total = summary.stages.iter().map(|s| s.seconds).sum();
        row(w, "together", &[&words::duration(total)]);
        close_table(w);
    }
    w.close();
}

/// Warnings, when there are any.
pub(super) fn warnings(w: &mut Writer, summary: &Summary) {
    if summary.warnings.is_empty() {
        return;
    }
    section(w, "warnings", "Warnings");
    w.open("ul", &[]);
    for warning in &summary.warnings {
        w.text("li", &[], warning);
    }
    w.close();
    w.close();
}

/// What happened in the rehearsal and in the shown trial, when something did.
pub(super) fn events(w: &mut Writer, summary: &Summary) {
    let run = summary.execution.as_ref().and_then(|e| e.frames.as_ref());
    let of = |frames: Option<&pairtrawl_model::Frames>| -> Vec<Event> {
        frames.map_or(Vec::new(), |f| f.events.clone())
    };
    let events = [("rehearsal", of(summary.frames.as_ref())), ("run", of(run))];
    if events.iter().all(|(_, e)| e.is_empty()) {
        return;
    }
    section(w, "events", "Events");
    open_table(w, &["in", "when", "what"]);
    for (source, e) in events
        .iter()
        .flat_map(|(s, list)| list.iter().map(move |e| (s, e)))
    {
        w.open("tr", &[]);
        w.text("th", &[("scope", &"row")], source);
        w.open("td", &[]);
        go_to(w, Some(e.time), Some(e.place), &format!("{:.1} s", e.time));
        w.close();
        w.text("td", &[], &e.text);
        w.close();
    }
    close_table(w);
    w.close();
}

/// The trials of an execution.
pub(super) fn trials(w: &mut Writer, summary: &Summary) {
    let Some(execution) = &summary.execution else {
        return;
    };
    let ExecutionSummary {
        controller, trials, ..
    } = execution;
    section(w, "trials", "Trials");
    let objects = summary.outline.objects.len();
    let full = trials.iter().filter(|t| t.gathered == objects).count();
    let words = format!(
        "{full} of {} trials with the {controller} controller gathered all {objects} objects.",
        trials.len()
    );
    w.text("p", &[], &words);
    open_table(
        w,
        &[
            "seed",
            "gathered",
            "left error, rms / max",
            "right error, rms / max",
            "J driven",
            "first event",
        ],
    );
    for (i, t) in trials.iter().enumerate() {
        let seed = match i == execution.shown {
            true => format!("{} (shown)", t.seed),
            false => t.seed.to_string(),
        };
        let error = |rms: f64, max: f64| format!("{:.1} / {:.1} mm", 1e3 * rms, 1e3 * max);
        let event = t
            .event
            .as_ref()
            .map_or(String::new(), |e| format!("{:.1} s: {}", e.time, e.text));
        row(
            w,
            &seed,
            &[
                &format!("{} of {objects}", t.gathered),
                &error(t.left_rms, t.left_max),
                &error(t.right_rms, t.right_max),
                &words::cost(t.cost.total()),
                &event,
            ],
        );
    }
    close_table(w);
    w.close();
}

fn section(w: &mut Writer, id: &str, heading: &str) {
    w.open("section", &[("id", &id), ("class", &"card")]);
    w.text("h2", &[], heading);
}

fn open_table(w: &mut Writer, columns: &[&str]) {
    w.open("div", &[("class", &"wide")]);
    w.open("table", &[]);
    w.open("thead", &[]);
    w.open("tr", &[]);
    for column in columns {
        // Columns of numbers are flush right, heads included.
        let class = match *column {
            "margin" | "value" | "share" => "number",
            _ => "",
        };
        w.text("th", &[("scope", &"col"), ("class", &class)], column);
    }
    w.close();
    w.close();
    w.open("tbody", &[]);
}

fn close_table(w: &mut Writer) {
    for _ in ["tbody", "table", "div"] {
        w.close();
    }
}

fn row(w: &mut Writer, head: &str, cells: &[&str]) {
    w.open("tr", &[]);
    w.text("th", &[("scope", &"row")], head);
    for cell in cells {
        w.text("td", &[], cell);
    }
    w.close();
}
