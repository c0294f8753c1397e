use crate::axis::nice_below;
use crate::frame::{self, Frame};
use crate::map::{self, Layer, Projection, Sign, View};
use crate::svg::{Rounded, Writer};
use crate::words;
use pairtrawl_geometry::Point;
use pairtrawl_model::Summary;
use pairtrawl_model::numbers::LengthUnit;

/// Greatest width and height of the map itself, px.
const MOST: (f64, f64) = (1000.0, 760.0);
/// Space around the map, px: for the vertical axis, the heading, the right border, the horizontal axis.
const LEFT: f64 = 62.0;
const TOP: f64 = 62.0;
const RIGHT: f64 = 20.0;
const AXIS: f64 = 50.0;
/// A legend entry, px.
const ENTRY: (f64, f64) = (158.0, 22.0);

/// A standalone picture of a plan in SVG: obstacles, objects, circles, centerline, baseline, both trajectories, the
/// floor that the net sweeps, start and end poses, with axes, a scale bar and a legend below the map. Left and right are
/// told apart by letters and dashes as well as by color; objects are numbered as in the scene, circles by their visits.
/// Light or dark as the viewer prefers.
pub fn plan_svg(summary: &Summary) -> String {
    let view = View::of(&summary.outline);
    let unit = view.unit();
    let scale = (MOST.0 / view.width()).min(MOST.1 / view.height());
    let map = Frame {
        left: LEFT,
        top: TOP,
        width: scale * view.width(),
        height: scale * view.height(),
        x: (unit.per_meter * view.min.x, unit.per_meter * view.max.x),
        y: (unit.per_meter * view.min.y, unit.per_meter * view.max.y),
    };
    let width = (map.right() + RIGHT).max(520.0);
    let entries = legend(summary);
    let columns = ((width - LEFT - RIGHT) / ENTRY.0).max(1.0) as usize;
    let rows = entries.len().div_ceil(columns);
    let legend_top = map.bottom() + AXIS;
    let height = legend_top + rows as f64 * ENTRY.1 + 12.0;

    let mut w = Writer::default();
    let title = format!("{}: {}", summary.title, words::facts(summary));
    frame::open_picture(&mut w, width, height, &title, &[frame::STYLE, map::STYLE]);
    let n = |v: f64| Rounded(v, 1);
    let room = width - LEFT - RIGHT;
    let name = frame::fit(&summary.title, room, 18.0);
    w.text(
        "text",
        &[("class", &"head"), ("x", &LEFT), ("y", &"28")],
        &name,
    );
    let facts = frame::fit(&words::facts(summary), room, 13.0);
    w.text(
        "text",
        &[("class", &"quiet"), ("x", &LEFT), ("y", &"48")],
        &facts,
    );

    let (left, top) = (n(map.left), n(map.top));
    let (map_width, map_height) = (n(map.width), n(map.height));
    w.open("clipPath", &[("id", &"map")]);
    w.empty(
        "rect",
        &[
            ("x", &left),
            ("y", &top),
            ("width", &map_width),
            ("height", &map_height),
        ],
    );
    w.close();
    w.empty(
        "rect",
        &[
            ("class", &"pane"),
            ("x", &left),
            ("y", &top),
            ("width", &map_width),
            ("height", &map_height),
        ],
    );
    let [x_name, y_name] = ["x", "y"].map(|axis| format!("{axis} ({})", unit.name));
    map.draw_axes(&mut w, &x_name, &y_name);
    w.open("g", &[("clip-path", &"url(#map)")]);
    let to = Projection::pixels(&view, scale, Point::new(map.left, map.top));
    for layer in Layer::ALL {
        if layer.is_present(summary) {
            w.open("g", &[("class", &layer.key())]);
            layer.draw(&mut w, summary, &to);
            w.close();
        }
    }
    for label in map::labels(summary, &view, scale) {
        let (x, y) = (
            to.x_offset(label.anchor.x, label.offset.x),
            to.y_offset(label.anchor.y, label.offset.y + 4.0),
        );
        w.text(
            "text",
            &[("class", &label.class), ("x", &x), ("y", &y)],
            &label.text,
        );
    }
    w.close();

    scale_bar(&mut w, &map, scale);
    for (i, (class, sign, label)) in entries.iter().enumerate() {
        let x = LEFT + (i % columns) as f64 * ENTRY.0;
        let y = legend_top + (i / columns) as f64 * ENTRY.1;
        map::sign(&mut w, class, *sign, x, y, 26.0);
        let (x, y) = (n(x + 33.0), n(y + 11.5));
        w.text("text", &[("x", &x), ("y", &y)], label);
    }
    w.finish()
}

/// A bar of round length, right below the map, beside the name of the axis.
fn scale_bar(w: &mut Writer, map: &Frame, scale: f64) {
    let length = nice_below(0.22 * map.width / scale);
    let n = |v: f64| Rounded(v, 1);
    let (right, y) = (map.right(), map.bottom() + 37.0);
    let left = right - length * scale;
    let d = format!("M{} {}v6H{}v-6", n(left), n(y - 6.0), n(right));
    w.empty("path", &[("class", &"scale"), ("d", &d)]);
    let (x, y) = (n(left - 6.0), n(y));
    let unit = LengthUnit::of(length);
    let label = format!("{} {}", Rounded(unit.per_meter * length, 3), unit.name);
    w.text(
        "text",
        &[("x", &x), ("y", &y), ("text-anchor", &"end")],
        &label,
    );
}

/// Class, sign and label of everything that the picture shows.
fn legend(summary: &Summary) -> Vec<(&'static str, Sign, &'static str)> {
    let all = [
        (Layer::Obstacles, "obstacle", Sign::Patch, "obstacle"),
        (
            Layer::Objects,
            "object",
            Sign::Square(8.0),
            "object, number",
        ),
        (Layer::Circles, "circle", Sign::Disc(6.0), "circle, visit"),
        (Layer::Paths, "left path", Sign::Line, "left robot (L)"),
        (Layer::Paths, "right path", Sign::Line, "right robot (R)"),
        (Layer::Sweep, "sweep", Sign::Patch, "swept by the net"),
        (Layer::Ends, "start", Sign::Robots, "start, L and R"),
        (Layer::Ends, "end", Sign::Robots, "end, L and R"),
        (Layer::Centerline, "centerline", Sign::Line, "centerline"),
        (
            Layer::Baseline,
            "left baseline",
            Sign::Line,
            "baseline, left",
        ),
        (
            Layer::Baseline,
            "right baseline",
            Sign::Line,
            "baseline, right",
        ),
        (Layer::Ribbons, "left ribbon", Sign::Patch, "driven, left"),
        (Layer::Ribbons, "right ribbon", Sign::Patch, "driven, right"),
    ];
    all.into_iter()
        .filter(|(layer, ..)| layer.is_present(summary))
        .map(|(_, class, sign, label)| (class, sign, label))
        .collect()
}
