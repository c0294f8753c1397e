use super::things::Things;
use crate::limits::CAUTION;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::numbers::{enough_length, place};
use std::f64::consts::TAU;

/// A move of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Move {
    /// Where it would lie, m.
    pub to: Point,
    /// How far that is from where it lies, m.
    pub distance: f64,
}

/// Directions in which places are tried, besides those away from what is near.
const DIRECTIONS: usize = 48;
/// Places are tried on rings this far apart, in units of the length scale ...
const RING: f64 = 0.06;
/// ... and this far away at most.
const FARTHEST: f64 = 3.0;
/// How often a move is halved between a ring where it helps and one where it does not.
const HALVINGS: usize = 14;

/// The least move found after which `helps` holds, as far as directions on rings tell. Places where the object would lie in
/// an obstacle, outside of the area, on another object or where a robot starts or ends are no use to anybody.
pub(super) fn least_move(
    things: &Things<'_>,
    object: usize,
    helps: impl Fn(Point) -> bool,
) -> Option<Move> {
    if !things.in_words {
        return None;
    }
    let scene = things.scene;
    let from = scene.objects[object].position;
    let can = |p: Point| is_place(things, object, p) && helps(p);
    let mut directions: Vec<Point> = (0..DIRECTIONS)
        .map(|k| Point::unit(TAU * k as f64 / DIRECTIONS as f64))
        .collect();
    // Straight away from what is near is often the shortest way.
    for (distance, part) in things.obstacles.distances(from, FARTHEST * things.scale) {
        let away = from - things.nearest_point_of(part, from);
        if distance > 0.0 && away.norm() > 0.0 && directions.len() < 2 * DIRECTIONS {
            directions.push(away / away.norm());
        }
    }
    directions.extend([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]].map(Point::from));
    let rings = (FARTHEST / RING) as usize;
    let ring = |k: usize| RING * things.scale * k as f64;
    let first = (1..=rings).find_map(|k| {
        let helping: Vec<Point> = (directions.iter().copied())
            .filter(|&d| can(from + d * ring(k)))
            .collect();
        (!helping.is_empty()).then_some((k, helping))
    });
    let (k, helping) = first?;
    let moves = helping.into_iter().map(|direction| {
        let (mut too_little, mut enough) = (ring(k - 1), ring(k));
        for _ in 0..HALVINGS {
            let middle = 0.5 * (too_little + enough);
            match can(from + direction * middle) {
                true => enough = middle,
                false => too_little = middle,
            }
        }
        let to = from + direction * enough;
        Move {
            to,
            distance: to.distance(from),
        }
    });
    moves.reduce(|a, b| if b.distance < a.distance { b } else { a })
}

/// True where the object could lie at all.
pub(super) fn is_place(things: &Things<'_>, object: usize, p: Point) -> bool {
    let scene = things.scene;
    let rho = scene.objects[object].footprint_radius();
    let (min, max) = (scene.area.min, scene.area.max);
    let inside = p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y;
    let robots = [scene.start, scene.end]
        .into_iter()
        .flat_map(|pair| [pair.left, pair.right]);
    let body = scene.robot.circles();
    let misses = |pose: Pose| {
        let mut circles = body.circles().iter();
        circles.all(|c| c.center_at(pose).distance(p) >= c.radius + rho)
    };
    inside
        && robots.into_iter().all(misses)
        && things.nearest(p, rho + CAUTION, Some(object)).is_none()
}

/// What a proof says of the least move.
pub(super) fn advice(least: Option<Move>) -> String {
    match least {
        Some(Move { to, distance }) => format!(
            "the least move that was found to help is {}, to {}",
            enough_length(distance),
            place(to)
        ),
        None => "no place near it was found where this would not hold".to_owned(),
    }
}
