//! Cards, tables and links of a page.

use crate::svg::{Attributes, Writer};
use pairtrawl_geometry::Point;

/// Opens a card with a heading; [`Writer::close`] ends it.
pub(crate) fn open_card(w: &mut Writer, id: &str, heading: &str) {
    w.open("section", &[("id", &id), ("class", &"card")]);
    w.text("h2", &[], heading);
}

/// Opens a table with its heads; [`close_table`] ends it.
pub(super) fn open_table(w: &mut Writer, columns: &[&str]) {
    let heads = columns.iter().map(|column| {
        let is_number = matches!(*column, "margin" | "value" | "share");
        (*column, is_number)
    });
    open_table_of(w, &heads.collect::<Vec<_>>());
}

/// The same, with heads that say whether their column is one of numbers.
pub(crate) fn open_table_of(w: &mut Writer, heads: &[(&str, bool)]) {
    w.open("div", &[("class", &"wide")]);
    w.open("table", &[]);
    w.open("thead", &[]);
    w.open("tr", &[]);
    for (head, is_number) in heads {
        // Columns of numbers are flush right, heads included.
        let class = if *is_number { "number" } else { "" };
        w.text("th", &[("scope", &"col"), ("class", &class)], head);
    }
    w.close();
    w.close();
    w.open("tbody", &[]);
}

/// Ends a table.
pub(crate) fn close_table(w: &mut Writer) {
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
pub(crate) fn number(w: &mut Writer, text: &str) {
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
