//! The floor with tracks on it.

use crate::map::{Layer, Projection, View};
use crate::svg::{Rounded, Writer};
use pairtrawl_geometry::{Hull, Point};
use pairtrawl_model::Summary;

/// A picture of the floor.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// What it shows.
    pub title: String,
    /// The scene; what of a plan it holds is drawn below the tracks.
    pub scene: Summary,
    /// The part of the floor that is drawn, lower left and upper right corner, m; `None`: all of it.
    pub window: Option<[Point; 2]>,
    /// Surfaces.
    pub washes: Vec<Wash>,
    /// Lines, from the back to the front.
    pub tracks: Vec<Track>,
    /// Words at places.
    pub notes: Vec<Note>,
    /// A sentence below it; may be empty.
    pub caption: String,
}

/// A line on the floor.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// Points, m.
    pub points: Vec<Point>,
    /// How it is drawn.
    pub pen: Pen,
    /// Its name in the list below the picture; a name that stood there already is not repeated, an empty one not shown.
    pub name: String,
    /// True: a cross at its end.
    pub stops: bool,
}

/// How a track is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pen {
    /// Dashed, in the color of the text.
    Planned,
    /// Solid, of the (left, right) robot or anything else.
    Driven,
    /// Long dashes.
    Other,
    /// Dots.
    Third,
    /// The net.
    Net,
    /// Points instead of a line.
    Dots,
    /// Points of another shape.
    Squares,
}

impl Pen {
    fn class(self) -> &'static str {
        match self {
            Self::Planned => "planned",
            Self::Driven => "driven",
            Self::Other => "second",
            Self::Third => "third",
            Self::Net => "rope",
            Self::Dots => "dots",
            Self::Squares => "squares",
        }
    }
}

/// A surface around a line: the same number of points on both sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Wash {
    /// One border, m.
    pub left: Vec<Point>,
    /// The other, m.
    pub right: Vec<Point>,
    /// Its name in the list below the picture; may be empty.
    pub name: String,
}

/// Words at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// Where, m.
    pub place: Point,
    /// What.
    pub text: String,
}

/// Greatest size of a picture, px.
const MOST: (f64, f64) = (420.0, 420.0);
const LEFT: f64 = 34.0;
const BOTTOM: f64 = 34.0;

fn n(value: f64) -> Rounded {
    Rounded(value, 1)
}

/// Draws a picture as an element of a page; `id` is unique on the page.
pub(super) fn draw(w: &mut Writer, picture: &Picture, id: &str) {
    let mut view = View::of(&picture.scene.outline);
    if let Some([min, max]) = picture.window {
        (view.min, view.max) = (min, max);
    }
    let room = MOST.0 - LEFT - 4.0;
    let scale = (room / view.width()).min(MOST.1 / view.height());
    let (width, height) = (scale * view.width(), scale * view.height());
    let all = (width + LEFT + 4.0, height + BOTTOM + 4.0);
    w.open("figure", &[("class", &"floor")]);
    w.text("h3", &[], &picture.title);
    let size = format!("0 0 {} {}", n(all.0), n(all.1));
    w.open(
        "svg",
        &[
            ("viewBox", &size),
            ("role", &"img"),
            ("aria-label", &picture.title),
        ],
    );
    let clip = format!("clip-{id}");
    w.open("clipPath", &[("id", &clip)]);
    pane(w, "", width, height);
    w.close();
    pane(w, "pane", width, height);
    axes(w, &view, scale, (width, height));
    let clipped = format!("url(#{clip})");
    w.open("g", &[("clip-path", &clipped)]);
    let to = Projection::pixels(&view, scale, Point::new(LEFT, 4.0));
    for layer in Layer::ALL {
        if layer.is_present(&picture.scene) && layer != Layer::Objects {
            layer.draw(w, &picture.scene, &to);
        }
    }
    for wash in &picture.washes {
        surface(w, wash, &to);
    }
    for track in &picture.tracks {
        line(w, track, &to);
    }
    Layer::Objects.draw(w, &picture.scene, &to);
    for note in &picture.notes {
        let attributes: &[(&str, &dyn std::fmt::Display)] = &[
            ("class", &"halo"),
            ("x", &to.x(note.place.x)),
            ("y", &to.y_offset(note.place.y, -6.0)),
            ("text-anchor", &"middle"),
        ];
        w.text("text", attributes, &note.text);
    }
    w.close();
    w.close();
    legend(w, picture);
    if !picture.caption.is_empty() {
        w.text("figcaption", &[], &picture.caption);
    }
    w.close();
}

fn pane(w: &mut Writer, class: &str, width: f64, height: f64) {
    w.empty(
        "rect",
        &[
            ("class", &class),
            ("x", &n(LEFT)),
            ("y", &"4"),
            ("width", &n(width)),
            ("height", &n(height)),
        ],
    );
}

fn axes(w: &mut Writer, view: &View, scale: f64, (width, height): (f64, f64)) {
    use crate::axis::Ticks;
    let x_ticks = Ticks::new(view.min.x, view.max.x, (width / 50.0) as usize);
    for v in &x_ticks.values {
        let x = n(LEFT + scale * (v - view.min.x));
        let attributes: &[(&str, &dyn std::fmt::Display)] = &[
            ("x", &x),
            ("y", &n(height + 18.0)),
            ("text-anchor", &"middle"),
        ];
        w.text("text", attributes, &x_ticks.label(*v));
    }
    let y_ticks = Ticks::new(view.min.y, view.max.y, (height / 40.0) as usize);
    for v in &y_ticks.values {
        let y = n(8.0 + scale * (view.max.y - v));
        let attributes: &[(&str, &dyn std::fmt::Display)] =
            &[("x", &n(LEFT - 5.0)), ("y", &y), ("text-anchor", &"end")];
        w.text("text", attributes, &y_ticks.label(*v));
    }
    let attributes: &[(&str, &dyn std::fmt::Display)] = &[
        ("class", &"name"),
        ("x", &n(LEFT + 0.5 * width)),
        ("y", &n(height + 34.0)),
        ("text-anchor", &"middle"),
    ];
    w.text("text", attributes, "x and y (m)");
}

fn surface(w: &mut Writer, wash: &Wash, to: &Projection) {
    let mut d = String::new();
    for (l, r) in wash.left.windows(2).zip(wash.right.windows(2)) {
        let cell = Hull::of(&[l[0], l[1], r[0], r[1]]);
        d.push_str(&to.ring(cell.vertices().iter().copied()));
    }
    if !d.is_empty() {
        w.empty("path", &[("class", &"wash"), ("d", &d)]);
    }
}

fn line(w: &mut Writer, track: &Track, to: &Projection) {
    let class = format!("track {}", track.pen.class());
    match track.pen {
        Pen::Dots | Pen::Squares => {
            let look = usize::from(track.pen == Pen::Squares);
            for p in &track.points {
                let d = super::chart::shape(look, to.x(p.x).0, to.y(p.y).0);
                w.empty("path", &[("class", &class), ("d", &d)]);
            }
        }
        _ => {
            let d = to.path(track.points.iter().copied());
            if !d.is_empty() {
                w.empty("path", &[("class", &class), ("d", &d)]);
            }
        }
    }
    if let (true, Some(end)) = (track.stops, track.points.last()) {
        let d = format!(
            "M{} {}l10 10m0-10l-10 10",
            n(to.x(end.x).0 - 5.0),
            n(to.y(end.y).0 - 5.0)
        );
        w.empty("path", &[("class", &"cross"), ("d", &d)]);
    }
}

fn legend(w: &mut Writer, picture: &Picture) {
    let mut seen: Vec<&str> = Vec::new();
    w.open("ul", &[("class", &"legend")]);
    for track in &picture.tracks {
        if track.name.is_empty() || seen.contains(&track.name.as_str()) {
            continue;
        }
        seen.push(&track.name);
        w.open("li", &[]);
        w.open(
            "svg",
            &[
                ("viewBox", &"0 0 30 10"),
                ("width", &"30"),
                ("height", &"10"),
                ("aria-hidden", &"true"),
            ],
        );
        let class = format!("track {}", track.pen.class());
        let d = match track.pen {
            Pen::Dots => super::chart::shape(0, 15.0, 5.0),
            Pen::Squares => super::chart::shape(1, 15.0, 5.0),
            _ => "M1 5H29".to_owned(),
        };
        w.empty("path", &[("class", &class), ("d", &d)]);
        w.close();
        w.text("span", &[], &track.name);
        w.close();
    }
    if picture.tracks.iter().any(|t| t.stops) {
        w.open("li", &[]);
        w.raw("<svg viewBox=\"0 0 30 10\" width=\"30\" height=\"10\" aria-hidden=\"true\"><path class=\"cross\" d=\"M11 1l8 8m0-8l-8 8\"/></svg>\n");
        w.text("span", &[], "ends here");
        w.close();
    }
    for wash in picture
        .washes
        .iter()
        .filter(|wash| !wash.name.is_empty())
        .take(1)
    {
        w.open("li", &[]);
        w.raw("<svg viewBox=\"0 0 30 10\" width=\"30\" height=\"10\" aria-hidden=\"true\"><path class=\"wash\" d=\"M1 0h28v10h-28z\"/></svg>\n");
        w.text("span", &[], &wash.name);
        w.close();
    }
    w.close();
}
