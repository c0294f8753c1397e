//! `body` of `[robot]`.

use crate::files::toml_reader::{Range, Value};
use crate::files::{FileError, Problem};
use pairtrawl_geometry::Point;
use pairtrawl_model::{Body, BodyCircle};

/// Reads `[[x, y, radius], ...]`: circles of one machine, on whose axle the reference point lies.
pub(super) fn read(value: &Value<'_>) -> Result<Body, FileError> {
    let circles = value
        .elements(1, Body::MOST)?
        .iter()
        .map(circle)
        .collect::<Result<Vec<_>, _>>()?;
    let conflict = |reason: String| {
        let field = value.name().to_owned();
        value.error(Problem::Conflict { field, reason })
    };
    // There are as many as a body may have: the list was read with that bound.
    let Some(body) = Body::of(&circles) else {
        return Err(value.refuse(format!("an array of 1 to {}", Body::MOST)));
    };
    if body.inner_radius() <= 0.0 {
        return Err(conflict(
            "no circle contains the reference point (0, 0), the center of the axle: give x forward and y to the left of it, m, \
             and circles that contain the whole machine"
                .to_owned(),
        ));
    }
    if let Some(i) = loose(&circles) {
        return Err(conflict(format!(
            "circle {i} is not joined to the one around the reference point by circles that overlap, but a machine is in one \
             piece: move it, or add circles between"
        )));
    }
    Ok(body)
}

fn circle(value: &Value<'_>) -> Result<BodyCircle, FileError> {
    let parts = match value.elements(3, 3) {
        Ok(parts) => parts,
        Err(_) => return Err(value.refuse("a circle, [x, y, radius]")),
    };
    Ok(BodyCircle {
        center: Point::new(
            parts[0].number(Range::Coordinate)?,
            parts[1].number(Range::Coordinate)?,
        ),
        radius: parts[2].number(Range::Length)?,
    })
}

/// The first circle that no chain of overlapping circles joins to one that contains the reference point.
fn loose(circles: &[BodyCircle]) -> Option<usize> {
    let overlap =
        |a: &BodyCircle, b: &BodyCircle| a.center.distance(b.center) <= a.radius + b.radius;
    let mut joined: Vec<bool> = circles.iter().map(|c| c.offset() < c.radius).collect();
    for _ in circles {
        for i in 0..circles.len() {
            let mut pairs = joined.iter().zip(circles);
            joined[i] = joined[i] || pairs.any(|(joined, c)| *joined && overlap(c, &circles[i]));
        }
    }
    joined.iter().position(|joined| !joined)
}
