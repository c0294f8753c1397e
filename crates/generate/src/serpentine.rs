use crate::band::Band;
use crate::course::{Bend, Course, widths};
use crate::level::Level;
use crate::random::Random;
use pairtrawl_geometry::Point;
use pairtrawl_model::{Obstacle, Robot};
use std::f64::consts::PI;

/// Where the walls of the hall go; shortened and thinned against the band later.
pub(crate) struct Walls {
    /// Lanes, the last one perhaps cut short.
    lanes: usize,
    /// Length of the straight part of a lane, m.
    lane_length: f64,
    /// From lane to lane, m.
    spacing: f64,
}

/// Lateral width of a half turn per meter of its arc: the integral of sin(pi (t - sin(2 pi t) / (2 pi))) over 0..1.
fn half_turn_width() -> f64 {
    const CELLS: usize = 2000;
    (0..CELLS)
        .map(|k| {
            let t = (k as f64 + 0.5) / CELLS as f64;
            libm::sin(PI * (t - libm::sin(2.0 * PI * t) / (2.0 * PI))) / CELLS as f64
        })
        .sum()
}

/// Parallel lanes along x, the first one eastward, each next one above, joined by half turns; at higher difficulty the
/// lanes wiggle.
pub(crate) fn course(random: &mut Random, level: &Level, waypoints: usize) -> (Course, Walls) {
    let length = waypoints as f64 * 0.05;
    let widest = 0.5 * level.separation.1;
    // Peak curvature of a half turn is 2 pi / arc, and lanes must leave room for a wall of at least 20 cm.
    let room = 2.0 * (widest + 0.24 + level.obstacle_margin.min(0.3)) + 0.2;
    let arc = (2.0 * PI * widest / level.inner.max(0.5)).max(room / half_turn_width())
        * random.between(1.0, 1.15);
    let spacing = arc * half_turn_width();
    // A hall about as wide as it is deep.
    let lane_length = (length * spacing).sqrt().clamp(3.0, 20.0);

    let mut bends = Vec::new();
    let (mut at, mut lanes, mut side) = (0.0, 0, 1.0);
    while at < length {
        at += lane(random, level, lane_length, &mut bends);
        bends.push(Bend {
            angle: side * PI,
            length: arc,
        });
        at += arc;
        side = -side;
        lanes += 1;
    }
    let widths = widths(random, level, length);
    (
        Course::new(0.0, bends, widths, random.between(0.042, 0.047)),
        Walls {
            lanes,
            lane_length,
            spacing,
        },
    )
}

/// One lane: straight, with wiggles (heading 0, a, -a, 0: back on the line) when the level asks for them. Returns its arc length.
fn lane(random: &mut Random, level: &Level, lane_length: f64, bends: &mut Vec<Bend>) -> f64 {
    let amplitude = random.between(0.3, 0.6) * level.fraction;
    let (wiggle, mut x, mut arc) = (1.2, 0.0, 0.0);
    let mut push = |angle: f64, length: f64| {
        bends.push(Bend { angle, length });
        arc += length;
    };
    let span = 3.0 * wiggle;
    while amplitude > 0.05 && x + span + 0.6 <= lane_length {
        let side = random.sign();
        push(0.0, 0.6);
        push(side * amplitude, wiggle);
        push(-2.0 * side * amplitude, wiggle);
        push(side * amplitude, wiggle);
        x += 0.6 + span * (1.0 - 0.25 * amplitude * amplitude);
    }
    push(0.0, (lane_length - x).max(0.1));
    arc
}

/// Walls between the lanes, open at alternate ends, as thick and long as the band allows, and pillars in the turns.
pub(crate) fn walls(
    plan: &Walls,
    _random: &mut Random,
    level: &Level,
    band: &Band<'_>,
    robot: &Robot,
) -> Vec<Obstacle> {
    let keep = robot.radius + level.obstacle_margin;
    let mut placed = Vec::new();
    let cell = 1.0;
    let count = (plan.lane_length / cell).ceil() as usize + 6;
    // The wall line above every lane, and one below the first, in pieces that each grow until they touch the margin.
    for k in 0..=plan.lanes {
        let middle = (k as f64 - 0.5) * plan.spacing;
        for c in 0..count {
            let x = (c as f64 - 3.0) * cell;
            if let Some(piece) = grow(x, x + cell, middle, plan.spacing, keep, band) {
                placed.push(piece);
            }
        }
    }
    placed
}

/// The thickest box over x0..x1 around the wall line that keeps clear of the band, at least 4 cm thick.
fn grow(
    x0: f64,
    x1: f64,
    middle: f64,
    spacing: f64,
    keep: f64,
    band: &Band<'_>,
) -> Option<Obstacle> {
    let reach = 1.5;
    let piece = |low: f64, high: f64| Obstacle::Box {
        min: Point::new(x0, low),
        max: Point::new(x1, high),
    };
    let clear = |low: f64, high: f64| band.obstacle_distance(&piece(low, high), reach) >= keep;
    // Where the lanes wiggle the free strip is not centered: look for a seed.
    let seed = [0.0, 0.1, -0.1, 0.2, -0.2, 0.3, -0.3, 0.4, -0.4]
        .iter()
        .map(|share| middle + share * spacing)
        .find(|y| clear(y - 0.02, y + 0.02))?;
    let stretch = |toward: f64| {
        let (mut good, mut bad) = (0.02, 0.5 * spacing);
        for _ in 0..20 {
            let t = 0.5 * (good + bad);
            let fits = if toward > 0.0 {
                clear(seed - 0.02, seed + t)
            } else {
                clear(seed - t, seed + 0.02)
            };
            if fits { good = t } else { bad = t }
        }
        good
    };
    let (down, up) = (stretch(-1.0), stretch(1.0));
    let mm = |v: f64, round: fn(f64) -> f64| round(v * 1000.0) / 1000.0;
    let (low, high) = (mm(seed - down, f64::ceil), mm(seed + up, f64::floor));
    // Only walls that the pair drives along: far outside the hall they say nothing.
    let near = band.obstacle_distance(&piece(low, high), reach) < reach;
    (near && high > low).then(|| piece(low, high))
}
