use super::things::Things;
use pairtrawl_geometry::Point;
use pairtrawl_model::numbers::{self, enough_length, length, most_length};
use std::collections::BinaryHeap;

/// The grid on which the widest way is sought has about this many cells at most.
const CELLS: f64 = 200_000.0;
/// ... and no cells smaller than this, in units of the length scale.
const SMALLEST: f64 = 0.02;

/// Where the widest way is narrowest: words for people, found on a grid of samples. No part of a proof.
pub(super) struct Narrowest {
    pub(super) place: Point,
    /// Width of the way there, 0 where it is closed, m.
    pub(super) width: f64,
    /// What is there and what would open it.
    pub(super) words: String,
}

/// Seeks the widest way for a robot's center from one point to another, leaving one object out.
pub(super) fn narrowest(
    things: &Things<'_>,
    from: Point,
    to: Point,
    skip: Option<usize>,
) -> Narrowest {
    let area = things.scene.area;
    let extent = area.max - area.min;
    let cell = (extent.x * extent.y / CELLS)
        .sqrt()
        .max(SMALLEST * things.scale);
    let count = |length: f64| ((length / cell).ceil().min(CELLS) as usize).max(1);
    let (columns, rows) = (count(extent.x), count(extent.y));
    let size = Point::new(extent.x / columns as f64, extent.y / rows as f64);
    let center = |i: usize| {
        area.min
            + Point::new(
                ((i % columns) as f64 + 0.5) * size.x,
                ((i / columns) as f64 + 0.5) * size.y,
            )
    };
    let index = |p: Point| {
        let at = |v: f64, n: usize| (v.max(0.0) as usize).min(n - 1);
        let d = p - area.min;
        at(d.y / size.y, rows) * columns + at(d.x / size.x, columns)
    };
    // Wider than this is wide enough; what a robot passes easily need not be told apart.
    let bound = 2.0 * things.largest.radius;
    let clearance = |p: Point| things.nearest(p, bound, skip).map_or(bound, |(d, _)| d);
    // Dijkstra's algorithm for the way whose least clearance is greatest; keys are whole
    // numbers of a billionth of the scale, so that they have an order.
    let key = |c: f64| (c / things.scale * 1e9) as i64;
    let (start, goal) = (index(from), index(to));
    let mut done = vec![false; columns * rows];
    let mut heap = BinaryHeap::from([(i64::MAX, start, start)]);
    let mut bottleneck = start;
    while let Some((width, i, at)) = heap.pop() {
        if std::mem::replace(&mut done[i], true) {
            continue;
        }
        if i == goal {
            bottleneck = at;
            break;
        }
        let (column, row) = (i % columns, i / columns);
        for r in row.saturating_sub(1)..=(row + 1).min(rows - 1) {
            for c in column.saturating_sub(1)..=(column + 1).min(columns - 1) {
                let j = r * columns + c;
                if !done[j] {
                    let own = key(clearance(center(j)));
                    heap.push(if own < width {
                        (own, j, j)
                    } else {
                        (width, j, at)
                    });
                }
            }
        }
    }
    describe(things, center(bottleneck), size.norm(), skip)
}

/// Names the two things between which a place lies, or the thing that closes it.
fn describe(things: &Things<'_>, place: Point, cell: f64, skip: Option<usize>) -> Narrowest {
    let radius = things.keep;
    let needed = 2.0 * things.largest.radius;
    let Point { x, y } = place;
    let near = numbers::place(place);
    let Some((clearance, first)) = things.nearest(place, f64::INFINITY, skip) else {
        return Narrowest {
            place,
            width: 0.0,
            words: format!("near {near}"),
        };
    };
    if clearance <= 0.0 {
        let words = format!(
            "{first} closes it near {near}: open a gap of at least {} there",
            enough_length(needed)
        );
        return Narrowest {
            place,
            width: 0.0,
            words,
        };
    }
    let advice = |width: f64| {
        format!(
            "widen it by at least {} or take robots of at most {} radius",
            enough_length(needed - width),
            most_length(0.5 * width)
        )
    };
    let area = things.scene.area;
    let to_edge = (x - area.min.x)
        .min(area.max.x - x)
        .min(y - area.min.y)
        .min(area.max.y - y);
    let foot = things.nearest_point(first, place);
    // The other side of the gap is where the first one is mirrored.
    let mirrored = place * 2.0 - foot;
    let other = things.nearest_other(mirrored, f64::INFINITY, skip, first);
    if let Some((_, second)) = other.filter(|&(d, _)| d <= 2.0 * cell) {
        let width = things.between(first, second).max(0.0);
        if width < needed {
            let words = format!(
                "the gap between {first} and {second} near {near} is {} wide, a robot needs {}: {}",
                length(width),
                length(needed),
                advice(width)
            );
            return Narrowest {
                place,
                width,
                words,
            };
        }
    }
    if to_edge <= cell {
        let width = clearance + to_edge;
        let words = format!(
            "{first} leaves about {} to the edge of the area near {near}, where a robot's center needs {}: widen it by about {}",
            length(width),
            length(radius),
            enough_length(radius - width)
        );
        return Narrowest {
            place,
            width,
            words,
        };
    }
    let width = 2.0 * clearance;
    let words = format!(
        "beside {first} near {near} it is about {} wide, a robot needs {}: {}",
        length(width),
        length(needed),
        advice(width)
    );
    Narrowest {
        place,
        width,
        words,
    }
}
