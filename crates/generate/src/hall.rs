use crate::random::Random;
use pairtrawl_geometry::{Bounds, Point};
use pairtrawl_model::{Area, Obstacle};

/// Shortest and longest edge of a box, m.
const EDGE: (f64, f64) = (0.3, 1.5);
/// Tries for one box before it is given up.
const ATTEMPTS: usize = 1000;

/// Boxes anywhere in the hall, off one another; the error says how many found a place.
pub(crate) fn boxes(
    random: &mut Random,
    area: &Area,
    wanted: usize,
) -> Result<Vec<Obstacle>, usize> {
    let mut placed: Vec<Bounds> = Vec::with_capacity(wanted);
    for _ in 0..wanted {
        let found = (0..ATTEMPTS)
            .filter_map(|_| draw(random, area))
            .find(|drawn| placed.iter().all(|other| drawn.distance(other) > 0.0));
        placed.push(found.ok_or(placed.len())?);
    }
    let as_obstacle = |Bounds { min, max }| Obstacle::Box { min, max };
    Ok(placed.into_iter().map(as_obstacle).collect())
}

/// A box in the area, to centimeters; `None` when its size does not fit.
fn draw(random: &mut Random, area: &Area) -> Option<Bounds> {
    let centimeters = |v: f64| (v * 100.0).round() / 100.0;
    let mut span = |low: f64, high: f64| {
        let edge = random.between(EDGE.0, EDGE.1);
        let start = centimeters(random.between(low, high - edge));
        (edge < high - low).then(|| (start, centimeters(start + edge)))
    };
    let (x, y) = (span(area.min.x, area.max.x), span(area.min.y, area.max.y));
    let ((x, right), (y, top)) = (x?, y?);
    Some(Bounds {
        min: Point::new(x, y),
        max: Point::new(right, top),
    })
}
