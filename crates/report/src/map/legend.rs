use super::layers::Layer;
use crate::svg::{Rounded, Writer};

/// What a sign in the legend looks like, within a box of `width` by 14 at (x, y).
pub(crate) fn sign(w: &mut Writer, class: &str, shape: Sign, x: f64, y: f64, width: f64) {
    let n = |v: f64| Rounded(v, 1);
    match shape {
        Sign::Line => {
            let d = format!("M{} {}h{}", n(x), n(y + 7.0), n(width));
            w.empty("path", &[("class", &class), ("d", &d)]);
        }
        Sign::Patch => {
            let d = format!("M{} {}h{}v10h{}Z", n(x), n(y + 2.0), n(width), n(-width));
            w.empty("path", &[("class", &class), ("d", &d)]);
        }
        Sign::Disc(radius) => {
            let (cx, cy) = (n(x + 0.5 * width), n(y + 7.0));
            w.empty(
                "circle",
                &[
                    ("class", &class),
                    ("cx", &cx),
                    ("cy", &cy),
                    ("r", &n(radius)),
                ],
            );
        }
        Sign::Square(side) => {
            let (left, top) = (n(x + 0.5 * (width - side)), n(y + 7.0 - 0.5 * side));
            let d = format!("M{left} {top}h{0}v{0}h-{0}Z", n(side));
            w.empty("path", &[("class", &class), ("d", &d)]);
        }
        Sign::Robots => {
            for (side, cx) in [("left", x + 6.5), ("right", x + width - 6.5)] {
                w.open("g", &[("class", &format_args!("robot {side} {class}"))]);
                let (cx, cy) = (n(cx), n(y + 7.0));
                w.empty(
                    "circle",
                    &[("class", &"body"), ("cx", &cx), ("cy", &cy), ("r", &"5.5")],
                );
                w.close();
            }
        }
    }
}

/// Shapes of signs in a legend.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Sign {
    Line,
    Patch,
    Disc(f64),
    Square(f64),
    Robots,
}

/// A class, its sign, and where in a box of 30 by 14 px it stands: x, y, width.
type Placed = (&'static str, Sign, f64, f64, f64);

impl Layer {
    /// The layer's signs in the page's legend, left robot first.
    pub fn signs(self) -> &'static [Placed] {
        match self {
            Self::Obstacles => &[("obstacle", Sign::Patch, 2.0, 0.0, 26.0)],
            Self::Sweep => &[("sweep", Sign::Patch, 2.0, 0.0, 26.0)],
            Self::Circles => &[("circle", Sign::Disc(6.0), 2.0, 0.0, 26.0)],
            Self::Centerline => &[("centerline", Sign::Line, 1.0, 0.0, 28.0)],
            Self::Baseline => &[
                ("left baseline", Sign::Line, 1.0, 0.0, 13.0),
                ("right baseline", Sign::Line, 16.0, 0.0, 13.0),
            ],
            Self::Ribbons => &[
                ("left ribbon", Sign::Patch, 1.0, 0.0, 13.0),
                ("right ribbon", Sign::Patch, 16.0, 0.0, 13.0),
            ],
            Self::Paths => &[
                ("left path", Sign::Line, 2.0, 0.0, 11.0),
                ("right path", Sign::Line, 17.0, 0.0, 11.0),
            ],
            Self::Ends => &[("start", Sign::Robots, 0.0, 0.0, 30.0)],
            Self::Objects => &[("object", Sign::Square(8.0), 2.0, 0.0, 26.0)],
            Self::Marks => &[("mark", Sign::Disc(6.0), 2.0, 0.0, 26.0)],
        }
    }

    /// The layer's name for people.
    pub fn label(self) -> &'static str {
        match self {
            Self::Obstacles => "obstacles",
            Self::Sweep => "swept by the net, pale: to come",
            Self::Circles => "circles by visit",
            Self::Centerline => "centerline",
            Self::Baseline => "baseline, left and right",
            Self::Ribbons => "driven, left and right",
            Self::Paths => "paths, left (L) and right (R)",
            Self::Ends => "start and end",
            Self::Objects => "objects by number",
            Self::Marks => "places to look at",
        }
    }
}
