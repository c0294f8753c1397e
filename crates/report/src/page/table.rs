//! Cards, tables and links of a page.

use crate::svg::{Attributes, Writer};
use pairtrawl_geometry::Point;

/// Opens a card with a heading; [`Writer::close`] ends it.
pub(super) fn open_card(w: &mut Writer, id: &str, heading: &str) {
    w.open("section", &[("id", &id), ("class", &"card")]);
    w.text("h2", &[], heading);
}

/// Opens a table with its heads; [`close_table`] ends it.
pub(super) fn open_table(w: &mut Writer, columns: &[&str]) {
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

/// Ends a table.
pub(super) fn close_table(w: &mut Writer) {
    for _ in ["tbody", "table", "div"] {
        w.close();
    }
}

/// A row of plain text.
pub(super) fn row(w: &mut Writer, head: &str, cells: &[&str]) {
    w.open("tr", &[]);
    w.text("th", &[("scope", &"row")], head);
    for cell in cells {
        w.text("td", &[], cell);
    }
    w.close();
}

/// A number of a table.
pub(super) fn number(w: &mut Writer, text: &str) {
    w.text("td", &[("class", &"number")], text);
}

/// The head of a row: a name that programs know, and below it what it means.
pub(super) fn named(w: &mut Writer, name: &str, meaning: &str) {
    w.open("th", &[("scope", &"row")]);
    w.open("code", &[]);
    // Long names may break between their words, nowhere else.
    for (i, word) in name.split('_').enumerate() {
        if i > 0 {
            w.raw("_<wbr>");
        }
        w.raw(&crate::svg::escape(word));
    }
    w.close();
    w.text("span", &[("class", &"meaning")], meaning);
    w.close();
}

/// A button that takes the player to a time, the map to a place and to a motion (empty: the one that is shown), as far as
/// they are known.
pub(super) fn go_to(
    w: &mut Writer,
    motion: &str,
    time: Option<f64>,
    place: Option<Point>,
    label: &str,
) {
    let Some(time) = time.filter(|t| t.is_finite()) else {
        w.text("span", &[], label);
        return;
    };
    let place = place.filter(|p| p.is_finite());
    let place = place.map_or(String::new(), |p| format!("{} {}", p.x, p.y));
    let attributes: Attributes = &[
        ("type", &"button"),
        ("class", &"goto"),
        ("data-motion", &motion),
        ("data-time", &format_args!("{time:.4}")),
        ("data-place", &place),
    ];
    w.text("button", attributes, label);
}
