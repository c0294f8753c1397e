use crate::frame::{self, Frame};
use crate::svg::{Rounded, Writer};
use crate::words;
use pairtrawl_model::numbers::{self, LengthUnit};
use pairtrawl_model::{Cost, LengthCurve};

const STYLE: &str = include_str!("../assets/length.css");

/// Name, class and value of the curves, in the order of the legend.
type Term = (&'static str, &'static str, fn(&Cost) -> f64);
const TERMS: [Term; 5] = [
    ("J, total", "total", |c| c.total()),
    ("distance and turning", "distance", |c| c.distance),
    ("expansion of the net", "expansion", |c| c.expansion),
    ("smoothness", "smoothness", |c| c.smoothness),
    ("obstacles and objects", "obstacles", |c| c.obstacle),
];

/// A standalone picture of J and its terms over the net length, with the minimum marked; net lengths without a plan
/// stand as crosses below the curves, with the reason as a tooltip.
pub fn length_svg(curve: &LengthCurve) -> String {
    let plot = frame_of(curve);
    let (width, height) = (plot.right() + 24.0, plot.bottom() + 120.0);
    let mut w = Writer::default();
    let title = format!("{}: cost over net length", curve.title);
    let styles = [frame::STYLE, STYLE];
    frame::open_picture(&mut w, width, height, &title, &styles);
    let n = |v: f64| Rounded(v, 1);
    let name = frame::fit(&title, plot.width, 18.0);
    w.text(
        "text",
        &[("class", &"head"), ("x", &plot.left), ("y", &"28")],
        &name,
    );
    let solved = curve.points.iter().filter(|p| p.outcome.is_ok()).count();
    let words = match &curve.minimum {
        Some((length, cost)) => format!(
            "least J {} at {} \u{b7} {solved} of {} lengths have a plan",
            words::cost(cost.total()),
            numbers::length(*length),
            curve.points.len()
        ),
        None => format!("{solved} of {} lengths have a plan", curve.points.len()),
    };
    w.text(
        "text",
        &[("class", &"quiet"), ("x", &plot.left), ("y", &"48")],
        &words,
    );

    let (left, top) = (n(plot.left), n(plot.top));
    let (pane_width, pane_height) = (n(plot.width), n(plot.height));
    w.empty(
        "rect",
        &[
            ("class", &"pane"),
            ("x", &left),
            ("y", &top),
            ("width", &pane_width),
            ("height", &pane_height),
        ],
    );
    let unit = LengthUnit::of(plot.x.1);
    let axes = Frame {
        x: (unit.per_meter * plot.x.0, unit.per_meter * plot.x.1),
        ..plot
    };
    let name = format!("net length d_max ({})", unit.name);
    axes.draw_axes(&mut w, &name, "cost J");
    for (_, class, term) in TERMS.iter().rev() {
        draw_curve(&mut w, curve, &plot, class, *term);
    }
    draw_missing(&mut w, curve, &plot);
    if let Some((length, cost)) = &curve.minimum {
        let (x, y) = (plot.px(*length), plot.py(cost.total()));
        let d = format!("M{} {}V{}", n(x), n(y), n(plot.bottom()));
        w.empty("path", &[("class", &"minimum"), ("d", &d)]);
        w.empty(
            "circle",
            &[
                ("class", &"minimum"),
                ("cx", &n(x)),
                ("cy", &n(y)),
                ("r", &"6"),
            ],
        );
    }
    legend(&mut w, curve, &plot);
    w.finish()
}

/// The frame that holds all curves, J from zero up: the shares of the terms are told by their heights.
fn frame_of(curve: &LengthCurve) -> Frame {
    let minimum = curve
        .minimum
        .iter()
        .map(|(length, cost)| (*length, cost.total()));
    let solved = curve
        .points
        .iter()
        .filter_map(|p| Some((p.net_length, p.outcome.as_ref().ok()?.total())));
    let highest = minimum.clone().chain(solved).map(|(_, j)| j);
    let highest = highest.filter(|j| j.is_finite()).fold(0.0, f64::max);
    let lengths = || {
        let points = curve.points.iter().map(|p| p.net_length);
        points
            .chain(minimum.clone().map(|(l, _)| l))
            .filter(|l| l.is_finite())
    };
    let (low, high) = (
        lengths().fold(f64::INFINITY, f64::min),
        lengths().fold(f64::NEG_INFINITY, f64::max),
    );
    let pad = match high > low {
        true => 0.03 * (high - low),
        false => 0.5 * high.abs(),
    };
    let x = if low <= high {
        (low - pad, high + pad)
    } else {
        (0.0, 1.0)
    };
    let y = (0.0, if highest > 0.0 { 1.06 * highest } else { 1.0 });
    Frame {
        left: 84.0,
        top: 62.0,
        width: 660.0,
        height: 380.0,
        x,
        y,
    }
}

fn draw_curve(
    w: &mut Writer,
    curve: &LengthCurve,
    plot: &Frame,
    class: &str,
    term: fn(&Cost) -> f64,
) {
    let n = |v: f64| Rounded(v, 1);
    // A net length without a plan interrupts the curve: nothing is known there.
    let runs = curve.points.split(|p| p.outcome.is_err());
    let mut d = String::new();
    for run in runs {
        let known = run
            .iter()
            .filter_map(|p| Some((p.net_length, p.outcome.as_ref().ok()?)));
        for (i, (length, cost)) in known.enumerate() {
            d.push(if i == 0 { 'M' } else { 'L' });
            d.push_str(&format!(
                "{} {}",
                n(plot.px(length)),
                n(plot.py(term(cost)))
            ));
        }
    }
    if d.is_empty() {
        return;
    }
    let name = format!("curve {class}");
    w.empty("path", &[("class", &name), ("d", &d)]);
    for p in &curve.points {
        if let Ok(cost) = &p.outcome {
            let (x, y) = (n(plot.px(p.net_length)), n(plot.py(term(cost))));
            let name = format!("point {class}");
            w.empty(
                "circle",
                &[("class", &name), ("cx", &x), ("cy", &y), ("r", &"2.5")],
            );
        }
    }
}

/// Crosses on the axis where there is no plan.
fn draw_missing(w: &mut Writer, curve: &LengthCurve, plot: &Frame) {
    for p in &curve.points {
        if let Err(reason) = &p.outcome {
            let d = format!(
                "M{} {}l8 8m0-8l-8 8",
                Rounded(plot.px(p.net_length) - 4.0, 1),
                Rounded(plot.bottom() - 12.0, 1)
            );
            w.open("g", &[("class", &"missing")]);
            w.text(
                "title",
                &[],
                &format!("{}: {reason}", numbers::length(p.net_length)),
            );
            w.empty("path", &[("d", &d)]);
            w.close();
        }
    }
}

fn legend(w: &mut Writer, curve: &LengthCurve, plot: &Frame) {
    let n = |v: f64| Rounded(v, 1);
    let place = |i: usize| {
        let (column, row) = (i % 3, i / 3);
        (
            plot.left + 215.0 * column as f64,
            plot.bottom() + 62.0 + 24.0 * row as f64,
        )
    };
    for (i, (label, class, _)) in TERMS.iter().enumerate() {
        let (x, y) = place(i);
        let d = format!("M{} {}h26", n(x), n(y));
        w.empty(
            "path",
            &[("class", &format_args!("curve {class}")), ("d", &d)],
        );
        w.text("text", &[("x", &n(x + 34.0)), ("y", &n(y + 4.5))], label);
    }
    if curve.points.iter().any(|p| p.outcome.is_err()) {
        let (x, y) = place(TERMS.len());
        let d = format!("M{} {}l8 8m0-8l-8 8", n(x + 9.0), n(y - 4.0));
        w.open("g", &[("class", &"missing")]);
        w.empty("path", &[("d", &d)]);
        w.close();
        w.text(
            "text",
            &[("x", &n(x + 34.0)), ("y", &n(y + 4.5))],
            "no plan",
        );
    }
}
