//! The page: one HTML document that needs nothing else.

mod certificate;
mod data;
mod failed;
mod making;
mod outcome;
pub(crate) mod table;

pub use failed::failed_html;

use crate::map::{self, Layer, Projection, View};
use crate::svg::{Rounded, Writer, escape};
use crate::words;
use pairtrawl_geometry::Point;
use pairtrawl_model::Summary;

pub(crate) const STYLE: &str = include_str!("../assets/page.css");
/// The styles of pages with a map.
const STYLES: [&str; 2] = [map::STYLE, STYLE];
const SCRIPTS: [&str; 4] = [
    include_str!("../assets/data.js"),
    include_str!("../assets/player.js"),
    include_str!("../assets/map.js"),
    include_str!("../assets/plots.js"),
];

/// One self-contained HTML page about a plan and what became of it, failures first, light or dark as the reader prefers, without any external resource: the
/// map in motion, curves over time, certificate, cost and everything else in the summary. The fragment `#t=12.5` opens
/// it at a time, `#t=12.5&show=rehearsal` shows the rehearsal there (or `run`).
pub fn report_html(summary: &Summary) -> String {
    let mut w = Writer::default();
    w.raw("<!DOCTYPE html>\n");
    w.open("html", &[("lang", &"en")]);
    head(&mut w, &summary.title, &STYLES);
    w.open("body", &[]);
    header(&mut w, summary);
    w.open("main", &[]);
    outcome::failures(&mut w, summary);
    warnings(&mut w, summary);
    player(&mut w, summary);
    map_section(&mut w, summary);
    left_out(&mut w, summary);
    outcome::trials(&mut w, summary);
    w.open(
        "section",
        &[("id", &"plots"), ("aria-label", &"Curves over time")],
    );
    w.close();
    w.open("div", &[("class", &"columns")]);
    certificate::card(&mut w, summary);
    w.open("div", &[]);
    making::cost(&mut w, summary);
    making::card(&mut w, summary);
    w.close();
    w.close();
    outcome::events(&mut w, summary);
    w.close();
    w.raw("<script type=\"application/json\" id=\"data\">");
    w.raw(&data::embedded(summary));
    w.raw("</script>\n<script>\n");
    // The scripts are ours and hold no closing tag.
    for script in SCRIPTS {
        w.raw(script);
    }
    w.raw("</script>\n");
    w.finish()
}

/// The head of a page with its styles; [`STYLE`] is that of every page.
pub(crate) fn head(w: &mut Writer, title: &str, styles: &[&str]) {
    w.open("head", &[]);
    w.raw("<meta charset=\"utf-8\">\n");
    w.raw("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
    w.raw("<meta name=\"color-scheme\" content=\"light dark\">\n");
    // An empty icon keeps browsers from asking a server for one.
    w.raw("<link rel=\"icon\" href=\"data:,\">\n");
    w.text("title", &[], &format!("{title} \u{b7} Pairtrawl"));
    w.raw("<style>\n");
    for style in styles {
        w.raw(style);
    }
    w.raw("</style>\n");
    w.close();
}

fn header(w: &mut Writer, summary: &Summary) {
    w.open("header", &[]);
    w.text("h1", &[], &summary.title);
    w.text("p", &[("class", &"facts")], &words::facts(summary));
    outcome::badges(w, summary);
    w.close();
}

/// The objects that are left where they are, each with its reason.
fn left_out(w: &mut Writer, summary: &Summary) {
    if summary.left_out.is_empty() {
        return;
    }
    table::open_card(w, "left", "Left where they lie");
    table::open_table(w, &["object", "why", "reason"]);
    for left in &summary.left_out {
        let object = left.object.to_string();
        table::row(w, &object, &[left.why.describe(), &left.text]);
    }
    table::close_table(w);
    w.close();
}

fn warnings(w: &mut Writer, summary: &Summary) {
    if summary.warnings.is_empty() {
        return;
    }
    table::open_card(w, "warnings", "Warnings");
    w.open("ul", &[]);
    for warning in &summary.warnings {
        w.text("li", &[], &warning.to_string());
    }
    w.close();
    w.close();
}

fn player(w: &mut Writer, summary: &Summary) {
    w.open(
        "div",
        &[
            ("id", &"player"),
            ("role", &"group"),
            ("aria-label", &"Playback"),
        ],
    );
    for (id, label, sign) in [
        (
            "first",
            "To the start (Home)",
            "M3 2h2v12h-2zM14 2v12l-8-6z",
        ),
        ("back", "One step back (left arrow)", "M11 3v10l-7-5z"),
        ("play", "Play or pause (space)", "M4 2l9 6-9 6z"),
        ("forward", "One step forward (right arrow)", "M5 3v10l7-5z"),
        ("last", "To the end (End)", "M11 2h2v12h-2zM2 2v12l8-6z"),
    ] {
        w.raw(&format!(
            "<button type=\"button\" id=\"{id}\" title=\"{label}\" aria-label=\"{label}\">\
             <svg viewBox=\"0 0 16 16\" width=\"16\" height=\"16\" aria-hidden=\"true\"><path d=\"{sign}\"/></svg></button>\n"
        ));
    }
    let end = Rounded(summary.duration, 4);
    w.raw(&format!(
        "<input type=\"range\" id=\"time\" min=\"0\" max=\"{end}\" step=\"any\" value=\"0\" aria-label=\"Time\">\n"
    ));
    w.text("output", &[("id", &"readout"), ("for", &"time")], "0.0 s");
    w.open("label", &[("title", &"Playback speed")]);
    w.text("span", &[], "speed");
    w.open("select", &[("id", &"speed")]);
    for (value, label) in [
        ("0.25", "\u{bc}\u{d7}"),
        ("0.5", "\u{bd}\u{d7}"),
        ("1", "1\u{d7}"),
        ("2", "2\u{d7}"),
        ("5", "5\u{d7}"),
        ("10", "10\u{d7}"),
        ("20", "20\u{d7}"),
    ] {
        match value {
            "5" => w.text(
                "option",
                &[("value", &value), ("selected", &"selected")],
                label,
            ),
            _ => w.text("option", &[("value", &value)], label),
        }
    }
    w.close();
    w.close();
    let mut sources = vec!["plan"];
    sources.extend(summary.frames.as_ref().map(|_| "rehearsal"));
    let run = summary.execution.as_ref().and_then(|e| e.frames.as_ref());
    sources.extend(run.map(|_| "run"));
    if sources.len() > 1 {
        w.open("label", &[("title", &"What moves on the map")]);
        w.text("span", &[], "show");
        w.open("select", &[("id", &"source")]);
        for source in sources {
            w.text("option", &[("value", &source)], source);
        }
        w.close();
        w.close();
    }
    w.close();
}

/// Width of the map before the script has measured the window, px.
const WIDTH: f64 = 960.0;

fn map_section(w: &mut Writer, summary: &Summary) {
    let view = View::of(&summary.outline);
    w.open(
        "section",
        &[
            ("id", &"map-card"),
            ("class", &"card"),
            ("aria-label", &"Map"),
        ],
    );
    w.open("div", &[("id", &"map-box")]);
    let scale = WIDTH / view.width();
    let height = scale * view.height();
    let size = format!("0 0 {} {}", Rounded(WIDTH, 1), Rounded(height, 1));
    let label = format!(
        "Map of {}: scene, trajectories and the moving pair. Plus and minus zoom, arrow keys move a zoomed map, 0 shows everything.",
        summary.title
    );
    w.open(
        "svg",
        &[
            ("id", &"map"),
            ("viewBox", &size),
            ("role", &"img"),
            ("tabindex", &"0"),
            ("aria-label", &label),
        ],
    );
    w.open("g", &[("id", &"map-axes")]);
    w.close();
    w.open(
        "svg",
        &[
            ("id", &"map-window"),
            ("width", &"100%"),
            ("height", &"100%"),
        ],
    );
    let corner = Point::new(-scale * view.min.x, scale * view.max.y);
    let transform = format!(
        "matrix({0} 0 0 -{0} {1} {2})",
        Rounded(scale, 4),
        Rounded(corner.x, 2),
        Rounded(corner.y, 2)
    );
    w.open("g", &[("id", &"world"), ("transform", &transform)]);
    for layer in Layer::ALL {
        if layer.is_present(summary) {
            w.open("g", &[("id", &format_args!("layer-{}", layer.key()))]);
            layer.draw(
                w,
                summary,
                &Projection::meters(summary.outline.robot.radius),
            );
            w.close();
        }
    }
    w.open("g", &[("id", &"duo")]);
    w.close();
    w.close();
    labels(w, summary, &view, scale);
    w.close();
    w.close();
    w.open(
        "div",
        &[("id", &"zoom"), ("role", &"group"), ("aria-label", &"Zoom")],
    );
    for (id, label, sign) in [
        ("zoom-in", "Zoom in (wheel, or + on the map)", "+"),
        ("zoom-out", "Zoom out (wheel, or - on the map)", "\u{2212}"),
        (
            "zoom-fit",
            "Show everything (double click, or 0 on the map)",
            "\u{2922}",
        ),
    ] {
        let attributes: crate::svg::Attributes = &[
            ("type", &"button"),
            ("id", &id),
            ("title", &label),
            ("aria-label", &label),
        ];
        w.text("button", attributes, sign);
    }
    w.close();
    w.close();
    toggles(w, summary);
    w.raw("<noscript><p>The map moves and the curves appear when scripts are allowed; the numbers below are complete without.</p></noscript>\n");
    w.close();
}

/// One group a layer; the script moves the labels when the map is zoomed.
fn labels(w: &mut Writer, summary: &Summary, view: &View, scale: f64) {
    w.open("g", &[("id", &"labels")]);
    let labels = map::labels(summary, view, scale);
    for layer in Layer::ALL {
        let mut own = labels.iter().filter(|l| l.layer == layer).peekable();
        if own.peek().is_none() {
            continue;
        }
        w.open("g", &[("id", &format_args!("labels-{}", layer.key()))]);
        for label in own {
            let x = scale * (label.anchor.x - view.min.x) + label.offset.x;
            let y = scale * (view.max.y - label.anchor.y) + label.offset.y;
            let attributes: crate::svg::Attributes = &[
                ("class", &label.class),
                ("x", &Rounded(x, 1)),
                ("y", &Rounded(y, 1)),
                ("data-x", &label.anchor.x),
                ("data-y", &label.anchor.y),
                ("data-dx", &Rounded(label.offset.x, 1)),
                ("data-dy", &Rounded(label.offset.y, 1)),
            ];
            w.text("text", attributes, &label.text);
        }
        w.close();
    }
    w.close();
}

/// One check box a layer, with its sign: the map's legend.
fn toggles(w: &mut Writer, summary: &Summary) {
    w.raw("<fieldset id=\"layers\"><legend>Show</legend>\n");
    for layer in Layer::ALL.into_iter().filter(|l| l.is_present(summary)) {
        // The baseline is a matter of debugging: there, but not in the way.
        let checked = if layer == Layer::Baseline {
            ""
        } else {
            " checked"
        };
        let key = layer.key();
        w.raw(&format!(
            "<label><input type=\"checkbox\" data-layer=\"layer-{key}\"{checked}>"
        ));
        w.raw("<svg width=\"30\" height=\"14\" aria-hidden=\"true\">");
        for (class, sign, x, y, width) in layer.signs() {
            map::sign(w, class, *sign, *x, *y, *width);
        }
        let label = match layer {
            Layer::Objects if !summary.left_out.is_empty() => "objects by number, hollow: left",
            _ => layer.label(),
        };
        w.raw(&format!("</svg>{}</label>\n", escape(label)));
    }
    w.raw("</fieldset>\n");
}
