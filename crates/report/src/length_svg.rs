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

/// Height of the lower frame, which shows the terms, and the space above it, px.
const TERMS_HEIGHT: f64 = 240.0;
const BETWEEN: f64 = 64.0;
/// The upper frame shows costs up to this many times the least: what is above it leaves the frame, so that the shape around
/// the least can be seen.
const HIGHEST: f64 = 1.25;

/// A standalone picture of J over the net length, with the minimum marked and an axis that follows it, and of its terms from
/// zero up below; net lengths without a plan stand as crosses below the curve, with the reason as a tooltip.
pub fn length_svg(curve: &LengthCurve) -> String {
    let (plot, terms) = frames_of(curve);
    let (width, height) = (plot.right() + 24.0, terms.bottom() + 120.0);
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

    let unit = LengthUnit::of(plot.x.1);
    let name = format!("net length d_max ({})", unit.name);
    for (frame, y_name) in [(&plot, "cost J"), (&terms, "terms of J")] {
        pane(&mut w, frame);
        let axes = Frame {
            x: (unit.per_meter * frame.x.0, unit.per_meter * frame.x.1),
            ..*frame
        };
        axes.draw_axes(&mut w, &name, y_name);
    }
    w.open("clipPath", &[("id", &"plot")]);
    pane(&mut w, &plot);
    w.close();
    let [total, others @ ..] = &TERMS;
    for (_, class, term) in others.iter().rev() {
        draw_curve(&mut w, curve, &terms, class, *term);
    }
    w.open("g", &[("clip-path", &"url(#plot)")]);
    draw_curve(&mut w, curve, &plot, total.1, total.2);
    w.close();
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
    legend(&mut w, curve, &terms);
    w.finish()
}

fn pane(w: &mut Writer, frame: &Frame) {
    let n = |v: f64| Rounded(v, 1);
    w.empty(
        "rect",
        &[
            ("class", &"pane"),
            ("x", &n(frame.left)),
            ("y", &n(frame.top)),
            ("width", &n(frame.width)),
            ("height", &n(frame.height)),
        ],
    );
}

/// The frame of J, whose axis follows it, and that of its terms from zero up, whose shares are told by their heights.
fn frames_of(curve: &LengthCurve) -> (Frame, Frame) {
    let minimum = curve
        .minimum
        .iter()
        .map(|(length, cost)| (*length, cost.total()));
    let solved = curve
        .points
        .iter()
        .filter_map(|p| Some((p.net_length, p.outcome.as_ref().ok()?.total())));
    let highest = minimum.clone().chain(solved).map(|(_, j)| j);
    let totals: Vec<f64> = highest.filter(|j| j.is_finite()).collect();
    let highest = totals.iter().copied().fold(0.0, f64::max);
    let least = totals.iter().copied().fold(f64::INFINITY, f64::min);
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
    let top = if highest > 0.0 { 1.06 * highest } else { 1.0 };
    let shown = highest.min(HIGHEST * least);
    let room = 0.08 * (shown - least);
    let plot = Frame {
        left: 84.0,
        top: 62.0,
        width: 660.0,
        height: 300.0,
        x,
        y: if room > 0.0 {
            // Crosses stand at the lower border.
            (least - 2.0 * room, shown + room)
        } else {
            (0.0, top)
        },
    };
    let terms = Frame {
        top: plot.bottom() + BETWEEN,
        height: TERMS_HEIGHT,
        y: (0.0, top),
        ..plot
    };
    (plot, terms)
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
