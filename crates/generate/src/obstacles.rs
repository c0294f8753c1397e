use crate::band::Band;
use crate::level::Level;
use crate::random::Random;
use crate::shape;
use pairtrawl_geometry::Point;
use pairtrawl_model::{Obstacle, Robot};

/// Rounding to millimeters moves a corner by less than this, m.
const ROUNDING: f64 = 0.001;
const REACH: f64 = 2.5;

/// Obstacles beside the band: tight ones on alternating sides, gates of two, and looser ones further out.
pub(crate) fn scatter(
    random: &mut Random,
    level: &Level,
    band: &Band<'_>,
    robot: &Robot,
) -> Vec<Obstacle> {
    let mut placed = Vec::new();
    let length = band.length();
    let n = band.witness.len();
    let tight = (length * level.obstacles_per_meter).ceil() as usize;
    let gates = if level.fraction > 0.3 {
        (length / 4.0 * level.fraction).ceil() as usize
    } else {
        0
    };

    for _ in 0..gates {
        // The narrowest of a few random waypoints.
        let at = (0..6)
            .map(|_| random.index(n / 10, n - n / 10))
            .min_by(|a, b| {
                band.witness
                    .pair(*a)
                    .separation()
                    .total_cmp(&band.witness.pair(*b).separation())
            })
            .unwrap_or(n / 2);
        for side in [1.0, -1.0] {
            placed.extend(beside(random, level, band, robot, at, side, 1.0));
        }
    }
    for _ in 0..tight {
        let (at, side) = (random.index(0, n), random.sign());
        placed.extend(beside(random, level, band, robot, at, side, 1.0));
    }
    for _ in 0..tight {
        let (at, side) = (random.index(0, n), random.sign());
        let further = random.between(2.0, 8.0);
        placed.extend(beside(random, level, band, robot, at, side, further));
    }
    placed
}

/// An obstacle of random shape beside waypoint `at`, as close to the band as `looseness` times the level's margin
/// allows; `None` when its size does not fit there.
fn beside(
    random: &mut Random,
    level: &Level,
    band: &Band<'_>,
    robot: &Robot,
    at: usize,
    side: f64,
    looseness: f64,
) -> Option<Obstacle> {
    let pair = band.witness.pair(at);
    let outward = (pair.left.position() - pair.right.position()) / pair.separation() * side;
    let edge = if side > 0.0 {
        pair.left.position()
    } else {
        pair.right.position()
    };
    let margin = (level.obstacle_margin * random.between(0.5, 1.0) - ROUNDING).min(1.0) * looseness;
    let keep = robot.radius + margin;
    for shrink in 0..4 {
        let shape = draw(random, outward, libm::pow(0.75, f64::from(shrink)));
        // Least shift along the outward normal that keeps clear: far is clear, the edge itself is not.
        let (mut near, mut far) = (0.0, 2.5);
        let clear = |t: f64| {
            band.obstacle_distance(&shape::moved(&shape, edge + outward * t), REACH) >= keep
        };
        if !clear(far) {
            continue;
        }
        for _ in 0..24 {
            let middle = 0.5 * (near + far);
            if clear(middle) {
                far = middle
            } else {
                near = middle
            }
        }
        let obstacle = shape::rounded(&shape::moved(&shape, edge + outward * far));
        let distance = band.obstacle_distance(&obstacle, REACH);
        // A box may have stopped at another part of the course than the one it was meant for: fine, it is as tight there.
        if distance >= robot.radius + 0.25 * margin && distance < REACH {
            return Some(obstacle);
        }
    }
    None
}

/// A shape around the origin: mostly boxes, as in real halls, some turned rectangles, triangles and discs.
fn draw(random: &mut Random, outward: Point, scale: f64) -> Obstacle {
    let size = |random: &mut Random| scale * random.between(0.2, 1.2);
    let (w, d) = (size(random), size(random));
    match random.index(0, 10) {
        0..=5 => Obstacle::Box {
            min: Point::new(-0.5 * w, -0.5 * d),
            max: Point::new(0.5 * w, 0.5 * d),
        },
        6 | 7 => {
            let (x, y) = (outward * (0.5 * w), outward.perp() * (0.5 * d));
            Obstacle::Polygon(vec![-x - y, x - y, x + y, y - x])
        }
        8 => {
            let turn = random.between(0.0, std::f64::consts::TAU);
            let corner =
                |k: f64| Point::unit(turn + k * std::f64::consts::TAU / 3.0) * (0.3 + 0.4 * w);
            Obstacle::Polygon(vec![corner(0.0), corner(1.0), corner(2.0)])
        }
        _ => Obstacle::Circle {
            center: Point::ZERO,
            radius: (0.3 * w).max(0.05),
        },
    }
}
