//! Curves over an axis, each named at its end and told apart by dashes and by the shape of its points.

use super::curve_labels::spread;
use super::style::STYLE;
use crate::axis::Ticks;
use crate::frame;
use crate::svg::{Rounded, Writer};

/// A chart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// What it shows.
    pub title: String,
    /// Below it.
    pub x: Axis,
    /// At its left.
    pub y: Axis,
    /// From the back to the front.
    pub curves: Vec<Curve>,
    /// Vertical lines.
    pub marks: Vec<Mark>,
    /// A sentence below it; may be empty.
    pub caption: String,
}

/// An axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axis {
    /// Its name, with the unit.
    pub name: String,
    /// True: it begins at zero whatever the data.
    pub from_zero: bool,
    /// Values with their labels instead of round values.
    pub ticks: Vec<(f64, String)>,
}

impl Axis {
    /// An axis that follows the data.
    pub fn named(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            ..Self::default()
        }
    }

    /// An axis from zero.
    pub fn from_zero(name: &str) -> Self {
        Self {
            from_zero: true,
            ..Self::named(name)
        }
    }
}

/// A curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Its name, written at its end; short.
    pub label: String,
    /// Its points; a gap where a value is not finite.
    pub points: Vec<(f64, f64)>,
    /// How it is drawn.
    pub line: Line,
    /// Which of the colors and shapes it has, from 0.
    pub look: usize,
    /// A band around it.
    pub band: Option<Band>,
}

/// The borders of a band at the abscissas of its curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// Lower border.
    pub low: Vec<f64>,
    /// Upper border.
    pub high: Vec<f64>,
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// A solid line with points.
    Solid,
    /// A dashed line with points.
    Dashed,
    /// A solid line without points, for many of them.
    Plain,
    /// Points alone.
    Points,
}

/// A vertical line with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Where.
    pub x: f64,
    /// Its name, short.
    pub label: String,
}

/// Size of a chart, px. Small enough to be read on a narrow screen as it is.
const WIDTH: f64 = 420.0;
const HEIGHT: f64 = 300.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 46.0;
const LEFT: f64 = 66.0;
/// Estimated width of a letter, px.
const LETTER: f64 = 7.3;
/// Room above and below the data, as a share of their range.
const ROOM: f64 = 0.07;

struct Scale {
    left: f64,
    right: f64,
    x: (f64, f64),
    y: (f64, f64),
}

impl Scale {
    fn px(&self, x: f64) -> f64 {
        self.left + (x - self.x.0) / (self.x.1 - self.x.0) * (self.right - self.left)
    }

    fn py(&self, y: f64) -> f64 {
        TOP + (self.y.1 - y) / (self.y.1 - self.y.0) * (HEIGHT - BOTTOM - TOP)
    }
}

fn n(value: f64) -> Rounded {
    Rounded(value, 1)
}

/// Draws a chart as an element of a page.
pub(super) fn draw(w: &mut Writer, chart: &Chart) {
    w.open("figure", &[("class", &"chart")]);
    w.text("h3", &[], &chart.title);
    let view = format!("0 0 {WIDTH} {HEIGHT}");
    let label = format!("{}: {} over {}", chart.title, chart.y.name, chart.x.name);
    w.open(
        "svg",
        &[("viewBox", &view), ("role", &"img"), ("aria-label", &label)],
    );
    inside(w, chart);
    w.close();
    if !chart.caption.is_empty() {
        w.text("figcaption", &[], &chart.caption);
    }
    w.close();
}

/// A chart as a standalone picture in SVG, light or dark as the viewer prefers.
pub fn chart_svg(chart: &Chart) -> String {
    const HEAD: f64 = 30.0;
    let mut w = Writer::default();
    let styles = [frame::STYLE, crate::page::STYLE, STYLE];
    let size = (1.5 * WIDTH, 1.5 * (HEIGHT + HEAD + 24.0));
    frame::open_picture(&mut w, size.0, size.1, &chart.title, &styles);
    w.open(
        "g",
        &[("class", &"study chart"), ("transform", &"scale(1.5)")],
    );
    let title = frame::fit(&chart.title, WIDTH - 20.0, 12.0);
    w.text("text", &[("x", &"10"), ("y", &"20")], &title);
    let moved = format!("translate(0 {HEAD})");
    w.open("g", &[("transform", &moved)]);
    inside(&mut w, chart);
    let below = n(HEIGHT + 14.0);
    w.text(
        "text",
        &[("class", &"name"), ("x", &"10"), ("y", &below)],
        &chart.caption,
    );
    w.finish()
}

fn inside(w: &mut Writer, chart: &Chart) {
    let scale = scale(chart);
    axes(w, chart, &scale);
    for mark in &chart.marks {
        vertical(w, mark, &scale);
    }
    for curve in &chart.curves {
        band(w, curve, &scale);
    }
    for curve in &chart.curves {
        line(w, curve, &scale);
    }
    names(w, chart, &scale);
}

fn scale(chart: &Chart) -> Scale {
    let longest = (chart.curves.iter())
        .map(|c| c.label.chars().count())
        .max()
        .unwrap_or(0);
    let points = || chart.curves.iter().flat_map(|c| c.points.iter().copied());
    let ticks = |axis: &Axis| axis.ticks.iter().map(|t| t.0).collect::<Vec<_>>();
    let borders = chart.curves.iter().filter_map(|c| c.band.as_ref());
    let borders = borders.flat_map(|b| b.low.iter().chain(&b.high).copied());
    let x = range(
        points()
            .map(|p| p.0)
            .chain(chart.marks.iter().map(|m| m.x))
            .chain(ticks(&chart.x)),
        &chart.x,
    );
    let y = range(
        points().map(|p| p.1).chain(borders).chain(ticks(&chart.y)),
        &chart.y,
    );
    Scale {
        left: LEFT,
        right: WIDTH - 12.0 - LETTER * longest as f64,
        x,
        y,
    }
}

/// What an axis reaches over, with some room.
fn range(values: impl Iterator<Item = f64>, axis: &Axis) -> (f64, f64) {
    let values = values.filter(|v| v.is_finite());
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
        (low.min(v), high.max(v))
    });
    if low > high {
        return (0.0, 1.0);
    }
    let low = if axis.from_zero { low.min(0.0) } else { low };
    let room = match high > low {
        true => ROOM * (high - low),
        false => 0.5 * high.abs().max(1e-9),
    };
    match axis.from_zero && low == 0.0 {
        true => (0.0, high + room),
        false => (low - room, high + room),
    }
}

fn axes(w: &mut Writer, chart: &Chart, scale: &Scale) {
    let floor = HEIGHT - BOTTOM;
    w.empty(
        "rect",
        &[
            ("class", &"pane"),
            ("x", &n(scale.left)),
            ("y", &n(TOP)),
            ("width", &n(scale.right - scale.left)),
            ("height", &n(floor - TOP)),
        ],
    );
    let labeled = |axis: &Axis, (low, high): (f64, f64), most: usize| {
        if !axis.ticks.is_empty() {
            return axis.ticks.clone();
        }
        let ticks = Ticks::new(low, high, most);
        let values = ticks.values.iter();
        values.map(|v| (*v, ticks.label(*v))).collect()
    };
    for (value, label) in labeled(&chart.x, scale.x, 6) {
        let x = n(scale.px(value));
        let d = format!("M{x} {}V{}", n(TOP), n(floor));
        w.empty("path", &[("class", &"grid"), ("d", &d)]);
        let attributes: &[(&str, &dyn std::fmt::Display)] = &[
            ("x", &x),
            ("y", &n(floor + 16.0)),
            ("text-anchor", &"middle"),
        ];
        w.text("text", attributes, &label);
    }
    for (value, label) in labeled(&chart.y, scale.y, 6) {
        let y = scale.py(value);
        let d = format!("M{} {}H{}", n(scale.left), n(y), n(scale.right));
        w.empty("path", &[("class", &"grid"), ("d", &d)]);
        let attributes: &[(&str, &dyn std::fmt::Display)] = &[
            ("x", &n(scale.left - 6.0)),
            ("y", &n(y + 4.0)),
            ("text-anchor", &"end"),
        ];
        w.text("text", attributes, &label);
    }
    let middle = 0.5 * (scale.left + scale.right);
    let attributes: &[(&str, &dyn std::fmt::Display)] = &[
        ("class", &"name"),
        ("x", &n(middle)),
        ("y", &n(HEIGHT - 8.0)),
        ("text-anchor", &"middle"),
    ];
    w.text("text", attributes, &chart.x.name);
    let turned = format!("translate(13 {}) rotate(-90)", n(0.5 * (TOP + floor)));
    let attributes: &[(&str, &dyn std::fmt::Display)] = &[
        ("class", &"name"),
        ("transform", &turned),
        ("text-anchor", &"middle"),
    ];
    w.text("text", attributes, &chart.y.name);
}

fn vertical(w: &mut Writer, mark: &Mark, scale: &Scale) {
    let x = scale.px(mark.x);
    let d = format!("M{} {}V{}", n(x), n(TOP), n(HEIGHT - BOTTOM));
    w.empty("path", &[("class", &"mark"), ("d", &d)]);
    let width = LETTER * mark.label.chars().count() as f64;
    let (x, anchor) = match x + width + 6.0 > scale.right {
        true => (x - 4.0, "end"),
        false => (x + 4.0, "start"),
    };
    let attributes: &[(&str, &dyn std::fmt::Display)] = &[
        ("class", &"halo"),
        ("x", &n(x)),
        ("y", &n(TOP + 12.0)),
        ("text-anchor", &anchor),
    ];
    w.text("text", attributes, &mark.label);
}

fn band(w: &mut Writer, curve: &Curve, scale: &Scale) {
    let Some(band) = &curve.band else { return };
    let at = |(x, y): (f64, f64)| format!("{} {}", n(scale.px(x)), n(scale.py(y)));
    let xs = || curve.points.iter().map(|p| p.0);
    let there = xs().zip(band.high.iter().copied());
    let back: Vec<_> = xs().zip(band.low.iter().copied()).collect();
    let points = there.chain(back.into_iter().rev());
    let points = points.filter(|(x, y)| x.is_finite() && y.is_finite());
    let d: Vec<String> = points.map(at).collect();
    if !d.is_empty() {
        let d = format!("M{}Z", d.join("L"));
        let class = format!("band look{}", curve.look);
        w.empty("path", &[("class", &class), ("d", &d)]);
    }
}

fn line(w: &mut Writer, curve: &Curve, scale: &Scale) {
    let is_there = |p: &(f64, f64)| p.0.is_finite() && p.1.is_finite();
    if curve.line != Line::Points {
        let mut d = String::new();
        for run in curve.points.split(|p| !is_there(p)) {
            for (i, &(x, y)) in run.iter().enumerate() {
                d.push(if i == 0 { 'M' } else { 'L' });
                d.push_str(&format!("{} {}", n(scale.px(x)), n(scale.py(y))));
            }
        }
        let dashed = if curve.line == Line::Dashed {
            " dashed"
        } else {
            ""
        };
        let class = format!("line look{}{dashed}", curve.look);
        w.empty("path", &[("class", &class), ("d", &d)]);
    }
    if curve.line == Line::Plain {
        return;
    }
    let hollow = if curve.line == Line::Dashed {
        " hollow"
    } else {
        ""
    };
    let class = format!("point look{}{hollow}", curve.look);
    for &(x, y) in curve.points.iter().filter(|p| is_there(p)) {
        let d = shape(curve.look, scale.px(x), scale.py(y));
        w.empty("path", &[("class", &class), ("d", &d)]);
    }
}

/// The outline of a point: a disc, a square, a triangle, a diamond or a triangle that stands on its tip.
pub(super) fn shape(look: usize, x: f64, y: f64) -> String {
    let at = |points: &[(f64, f64)]| {
        let points = points.iter();
        let d: Vec<String> = points
            .map(|(dx, dy)| format!("{} {}", n(x + dx), n(y + dy)))
            .collect();
        format!("M{}Z", d.join("L"))
    };
    match look % 5 {
        0 => format!(
            "M{} {}a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0Z",
            n(x - 3.2),
            n(y)
        ),
        1 => at(&[(-3.0, -3.0), (3.0, -3.0), (3.0, 3.0), (-3.0, 3.0)]),
        2 => at(&[(-3.8, 3.0), (3.8, 3.0), (0.0, -3.8)]),
        3 => at(&[(-4.2, 0.0), (0.0, -4.2), (4.2, 0.0), (0.0, 4.2)]),
        _ => at(&[(-3.8, -3.0), (3.8, -3.0), (0.0, 3.8)]),
    }
}

/// The name of each curve at its last point, apart from each other.
fn names(w: &mut Writer, chart: &Chart, scale: &Scale) {
    let last = |curve: &Curve| {
        let there = |p: &&(f64, f64)| p.0.is_finite() && p.1.is_finite();
        curve.points.iter().rev().find(there).copied()
    };
    let ends: Vec<(&Curve, f64, f64)> = (chart.curves.iter())
        .filter(|curve| !curve.label.is_empty())
        .filter_map(|curve| {
            let (x, y) = last(curve)?;
            Some((curve, scale.px(x), scale.py(y)))
        })
        .collect();
    let wanted: Vec<f64> = ends.iter().map(|e| e.2).collect();
    let heights = spread(&wanted, 14.0, (TOP + 4.0, HEIGHT - BOTTOM - 2.0));
    for ((curve, x, y), height) in ends.iter().zip(heights) {
        if (height - y).abs() > 5.0 || scale.right - x > 12.0 {
            let d = format!(
                "M{} {}L{} {}",
                n(x + 4.0),
                n(*y),
                n(scale.right + 3.0),
                n(height)
            );
            w.empty("path", &[("class", &"leader"), ("d", &d)]);
        }
        let class = format!("halo look{}", curve.look);
        let attributes: &[(&str, &dyn std::fmt::Display)] = &[
            ("class", &class),
            ("x", &n(scale.right + 5.0)),
            ("y", &n(height + 4.0)),
        ];
        w.text("text", attributes, &curve.label);
    }
}
