use crate::axis::nice_below;
use crate::frame::{self, Frame};
use crate::map::{self, Layer, Projection, Sign, View};
use crate::svg::{Rounded, Writer};
use crate::words;
use pairtrawl_geometry::Point;
use pairtrawl_model::numbers::LengthUnit;
use pairtrawl_model::{FailedSummary, Summary};

/// Greatest width and height of the map itself, px.
const MOST: (f64, f64) = (1000.0, 760.0);
/// Space around the map, px: for the vertical axis, the heading, the right border, the horizontal axis.
const LEFT: f64 = 62.0;
const TOP: f64 = 62.0;
/// Space for a warning above the map, px.
const WARNING: f64 = 20.0;
const RIGHT: f64 = 20.0;
const AXIS: f64 = 50.0;
/// A legend entry, px.
const ENTRY: (f64, f64) = (158.0, 22.0);

/// A standalone picture of a plan in SVG: obstacles, objects, circles, centerline, baseline, both trajectories, the
/// floor that the net sweeps, start and end poses, with axes, a scale bar and a legend below the map. Left and right are
/// told apart by letters and dashes as well as by color; objects are numbered as in the scene, circles by their visits.
/// Light or dark as the viewer prefers.
pub fn plan_svg(summary: &Summary) -> String {
    picture(summary, &words::facts(summary), None)
}

/// The picture of a scene before it is planned: obstacles, numbered objects, those hollow that cannot be swept, circles in
/// visiting order, start and end.
pub fn scene_svg(summary: &Summary) -> String {
    picture(summary, &words::scene_facts(summary), None)
}

/// The picture of a scene for which there is no plan, with the best attempt where there is one and the places that are to
/// be seen. It says that it is no plan.
pub fn failed_svg(failed: &FailedSummary) -> String {
    let summary = &failed.summary;
    let facts = words::scene_facts(summary);
    let warning = words::no_plan(failed);
    picture(summary, &facts, Some(&warning))
}

/// A picture of whatever a summary holds, under facts and perhaps a warning.
fn picture(summary: &Summary, facts: &str, warning: Option<&str>) -> String {
    let view = View::of(&summary.outline);
    let unit = view.unit();
    let scale = (MOST.0 / view.width()).min(MOST.1 / view.height());
    let top = match warning {
        Some(_) => TOP + WARNING,
        None => TOP,
    };
    let map = Frame {
        left: LEFT,
        top,
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
    let title = match warning {
        Some(warning) => format!("{}: {warning}", summary.title),
        None => format!("{}: {facts}", summary.title),
    };
    frame::open_picture(&mut w, width, height, &title, &[frame::STYLE, map::STYLE]);
    let n = |v: f64| Rounded(v, 1);
    let room = width - LEFT - RIGHT;
    let name = frame::fit(&summary.title, room, 18.0);
    w.text(
        "text",
        &[("class", &"head"), ("x", &LEFT), ("y", &"28")],
        &name,
    );
    let facts = frame::fit(facts, room, 13.0);
    w.text(
        "text",
        &[("class", &"quiet"), ("x", &LEFT), ("y", &"48")],
        &facts,
    );
    if let Some(warning) = warning {
        let warning = frame::fit(warning, room, 15.0);
        w.text(
            "text",
            &[("class", &"warning"), ("x", &LEFT), ("y", &"70")],
            &warning,
        );
    }

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
        (
            Layer::Objects,
            "object leave",
            Sign::Square(8.0),
            match summary.trajectory.is_empty() {
                true => "cannot be swept",
                false => "left where it lies",
            },
        ),
        (Layer::Marks, "mark", Sign::Disc(6.0), "look here"),
        (Layer::Marks, "move", Sign::Line, "least move found"),
    ];
    let objects = &summary.outline.objects;
    let is_there = |class: &str| match class {
        "object" => objects.iter().any(|object| !object.leave),
        "object leave" => objects.iter().any(|object| object.leave),
        "move" => summary.marks.iter().any(|mark| mark.toward.is_some()),
        _ => true,
    };
    all.into_iter()
        .filter(|(layer, class, ..)| layer.is_present(summary) && is_there(class))
        .map(|(_, class, sign, label)| (class, sign, label))
        .collect()
}
