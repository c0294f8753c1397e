//! The frame around a picture: ticks, labels and grid, in pixels.

use crate::axis::Ticks;
use crate::svg::{Rounded, Writer};

/// Style of frames and text, light and dark.
pub(crate) const STYLE: &str = include_str!("../assets/frame.css");

/// A rectangle of the picture with a linear scale along each side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    /// Left border, px.
    pub left: f64,
    /// Upper border, px.
    pub top: f64,
    /// Width, px.
    pub width: f64,
    /// Height, px.
    pub height: f64,
    /// Values at the left and the right border.
    pub x: (f64, f64),
    /// Values at the lower and the upper border.
    pub y: (f64, f64),
}

impl Frame {
    /// Horizontal pixel of a value.
    pub fn px(&self, x: f64) -> f64 {
        self.left + (x - self.x.0) / (self.x.1 - self.x.0) * self.width
    }

    /// Vertical pixel of a value.
    pub fn py(&self, y: f64) -> f64 {
        self.top + (self.y.1 - y) / (self.y.1 - self.y.0) * self.height
    }

    /// Right border, px.
    pub fn right(&self) -> f64 {
        self.left + self.width
    }

    /// Lower border, px.
    pub fn bottom(&self) -> f64 {
        self.top + self.height
    }

    /// Grid lines, tick labels and the names of both axes; needs about 60 px to the left and 42 px below.
    pub fn draw_axes(&self, w: &mut Writer, x_name: &str, y_name: &str) {
        let n = |v: f64| Rounded(v, 1);
        w.open("g", &[("class", &"axes")]);
        let ticks = Ticks::new(self.x.0, self.x.1, (self.width / 60.0) as usize);
        for v in &ticks.values {
            let x = self.px(*v);
            let d = format!("M{} {}V{}", n(x), n(self.top), n(self.bottom()));
            w.empty("path", &[("class", &"grid"), ("d", &d)]);
            let d = format!("M{} {}v5", n(x), n(self.bottom()));
            w.empty("path", &[("class", &"tick"), ("d", &d)]);
            let (x, y) = (n(x), n(self.bottom() + 18.0));
            let label = ticks.label(*v);
            w.text(
                "text",
                &[("x", &x), ("y", &y), ("text-anchor", &"middle")],
                &label,
            );
        }
        let ticks = Ticks::new(self.y.0, self.y.1, (self.height / 50.0) as usize);
        let mut longest = 0;
        for v in &ticks.values {
            let y = self.py(*v);
            let d = format!("M{} {}H{}", n(self.left), n(y), n(self.right()));
            w.empty("path", &[("class", &"grid"), ("d", &d)]);
            let d = format!("M{} {}h-5", n(self.left), n(y));
            w.empty("path", &[("class", &"tick"), ("d", &d)]);
            let (x, y) = (n(self.left - 8.0), n(y + 4.0));
            let label = ticks.label(*v);
            longest = longest.max(label.chars().count());
            w.text(
                "text",
                &[("x", &x), ("y", &y), ("text-anchor", &"end")],
                &label,
            );
        }
        let (x, y) = (n(self.left + 0.5 * self.width), n(self.bottom() + 36.0));
        w.text(
            "text",
            &[("x", &x), ("y", &y), ("text-anchor", &"middle")],
            x_name,
        );
        let (x, y) = (
            self.left - 16.0 - 7.8 * longest as f64,
            self.top + 0.5 * self.height,
        );
        let turned = format!("translate({} {}) rotate(-90)", n(x), n(y));
        w.text(
            "text",
            &[("transform", &turned), ("text-anchor", &"middle")],
            y_name,
        );
        w.close();
    }
}

/// The head of a picture's document: size, description, style, background.
pub(crate) fn open_picture(w: &mut Writer, width: f64, height: f64, title: &str, styles: &[&str]) {
    let (width, height) = (Rounded(width, 0), Rounded(height, 0));
    w.open(
        "svg",
        &[
            ("xmlns", &"http://www.w3.org/2000/svg"),
            ("viewBox", &format_args!("0 0 {width} {height}")),
            ("width", &width),
            ("height", &height),
            ("role", &"img"),
            ("aria-labelledby", &"title"),
        ],
    );
    w.text("title", &[("id", &"title")], title);
    // The style sheets are ours and hold neither `<` nor `&`.
    w.raw("<style>\n");
    for style in styles {
        w.raw(style);
    }
    w.raw("</style>\n");
    w.empty(
        "rect",
        &[("class", &"paper"), ("width", &width), ("height", &height)],
    );
}

/// Text cut so that it fits a width at a font size, px. Widths are estimated, on the safe side for Latin letters.
pub(crate) fn fit(text: &str, width: f64, font_size: f64) -> String {
    let most = (width / (0.62 * font_size)).max(1.0) as usize;
    match text.chars().count() > most {
        true => text
            .chars()
            .take(most.saturating_sub(1))
            .chain(['\u{2026}'])
            .collect(),
        false => text.to_owned(),
    }
}
