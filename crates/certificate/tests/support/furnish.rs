//! Furnishes a driven plan with obstacles and objects that leave it valid.

use super::Case;
use super::brute::{Opinion, opinions};
use super::random::Random;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Footprint, Object, Obstacle, OccupancyMap};

/// Puts obstacles as close as `accepts` allows, and objects into the band.
pub fn furnish(case: &mut Case, kind: usize, random: &mut Random, accepts: impl Fn(&Case) -> bool) {
    while case.scene.objects.len() < 4 {
        let object = Object {
            position: on_a_line(case, random, 0.3, 0.7),
            footprint: if random.below(2) == 0 {
                Footprint::Disc(0.03)
            } else {
                Footprint::Box(0.05, 0.05)
            },
            mass: 0.02,
            leave: false,
        };
        case.scene.objects.push(object);
        if !accepts(case) {
            case.scene.objects.pop();
        }
    }
    if kind >= 5 {
        case.scene.map = Some(map_around(case, if kind == 5 { 0.0 } else { 0.4 }));
        assert!(accepts(case));
        return;
    }
    for k in 0..60 {
        let mut p = on_a_line(case, random, -1.0, 2.0);
        if k % 3 == 0 {
            // Close behind the first line or ahead of the last one, where no robot passes.
            let last = random.below(2) * (case.trajectory.len() - 1);
            let pair = case.trajectory.pair(last);
            let off =
                pair.left.forward() * random.within(0.0, 0.4) * if last == 0 { -1.0 } else { 1.0 };
            p = pair
                .left
                .position()
                .lerp(pair.right.position(), random.within(0.0, 1.0))
                + off;
        }
        case.scene
            .obstacles
            .push(shape(p, random.within(0.05, 0.4), kind, random));
        if !accepts(case) {
            case.scene.obstacles.pop();
        }
    }
}

/// A point on the line between the robots at some waypoint; parameters beyond [0, 1] extend it.
pub fn on_a_line(case: &Case, random: &mut Random, low: f64, high: f64) -> Point {
    let n = case.trajectory.len();
    let at = [0, n - 1, random.below(n), random.below(n)][random.below(4)];
    let pair = case.trajectory.pair(at);
    pair.left
        .position()
        .lerp(pair.right.position(), random.within(low, high))
}

pub fn shape(p: Point, size: f64, kind: usize, random: &mut Random) -> Obstacle {
    let turn = random.within(0.0, 6.0);
    let star = |radii: &[f64]| {
        let n = radii.len() as f64;
        let corner = |(i, r): (usize, &f64)| {
            p + Point::unit(turn + std::f64::consts::TAU * i as f64 / n) * (r * size)
        };
        radii.iter().enumerate().map(corner).collect::<Vec<Point>>()
    };
    match kind {
        0 => Obstacle::Box {
            min: p,
            max: p + Point::new(size, 0.6 * size),
        },
        1 => Obstacle::Circle {
            center: p,
            radius: size,
        },
        2 => Obstacle::Polygon(star(&[1.0, 0.8, 1.0])),
        // A star, clockwise and counter-clockwise.
        3 => Obstacle::Polygon(star(&[1.0, 0.3, 1.0, 0.3, 1.0, 0.3, 1.0, 0.3])),
        _ => Obstacle::Polygon(
            star(&[1.0, 0.3, 1.0, 0.3, 1.0, 0.4])
                .into_iter()
                .rev()
                .collect(),
        ),
    }
}

/// A map whose cells are blocked where they are well away from the paths and the net.
fn map_around(case: &Case, yaw: f64) -> OccupancyMap {
    let (columns, rows) = (200, 160);
    let origin = Pose::new(if yaw == 0.0 { -1.0 } else { 0.0 }, -1.5, yaw);
    let mut map = OccupancyMap {
        origin,
        resolution: 0.05,
        columns,
        rows,
        blocked: vec![false; columns * rows],
    };
    let pairs: Vec<_> = (0..case.trajectory.len())
        .map(|i| case.trajectory.pair(i))
        .collect();
    for i in 0..columns * rows {
        let center = map.from_cells(Point::new(
            (i % columns) as f64 + 0.5,
            (i / columns) as f64 + 0.5,
        ));
        let near = pairs.iter().any(|pair| {
            (0..=8).any(|k| {
                pair.left
                    .position()
                    .lerp(pair.right.position(), k as f64 / 8.0)
                    .distance(center)
                    < 0.31
            })
        });
        map.blocked[i] = !near;
    }
    map
}

/// The verdict of the brute-force checker.
pub fn brute_accepts(case: &Case) -> bool {
    let found = opinions(&case.scene, case.net_length, &case.trajectory);
    found.iter().all(|(_, o)| *o == Opinion::Holds)
}
