//! Distances to convex regions against brute force: along every direction there is, and from point to point.

use super::{between, regions};
use crate::constraints::point_distance::PointDistance;
use crate::constraints::quad_distance::QuadDistance;
use crate::pieces::Piece;
use crate::term::{QUAD, Term};
use fastrand::Rng;
use pairtrawl_geometry::{Convex, Hull, Point, Polygon};

const DIRECTIONS: usize = 3600;

/// The signed distance of two convex sets is the widest gap between them seen along any direction: apart it is their
/// distance, overlapping it is minus the shortest way out. Of the hull of some points here.
fn widest_gap(region: &Piece, points: &[Point]) -> f64 {
    let gap = |k: usize| {
        let n = Point::unit(std::f64::consts::TAU * k as f64 / DIRECTIONS as f64);
        let farthest = region
            .vertices
            .iter()
            .map(|v| n.dot(*v))
            .fold(f64::NEG_INFINITY, f64::max);
        let nearest = points
            .iter()
            .map(|p| n.dot(*p))
            .fold(f64::INFINITY, f64::min);
        nearest - farthest - region.radius
    };
    (0..DIRECTIONS).map(gap).fold(f64::NEG_INFINITY, f64::max)
}

/// Seen along the nearest direction, a gap is at most this much less than along the best one, m.
const COARSENESS: f64 = 3e-3;

/// Any four ends, or those of a short step as robots make it.
fn random_quad(random: &mut Rng, short: bool) -> [f64; QUAD] {
    let mut z: [f64; QUAD] = std::array::from_fn(|_| between(random, -0.9, 0.9));
    if short {
        for k in 4..QUAD {
            z[k] = z[k - 4] + between(random, -0.05, 0.05);
        }
    }
    z
}

fn ends(z: &[f64; QUAD]) -> [Point; 4] {
    std::array::from_fn(|k| Point::new(z[2 * k], z[2 * k + 1]))
}

#[test]
fn point_distance_is_the_signed_distance() {
    let mut random = Rng::with_seed(21);
    for convex in regions() {
        let region = Piece::new(&convex);
        let term = PointDistance {
            region: &region,
            keep: 0.24,
        };
        let (mut inside, mut outside) = (0, 0);
        for k in 0..300 {
            // Regions lie within 0.6 m of the origin; slivers are met by points close to the axis.
            let narrow = if k % 2 == 0 { 0.1 } else { 1.0 };
            let p = Point::new(
                between(&mut random, -0.8, 0.8),
                narrow * between(&mut random, -0.6, 0.6),
            );
            let d = term.value(&p.into()) + 0.24;
            let brute = widest_gap(&region, &[p]);
            assert!(
                d >= brute - 1e-12 && d <= brute + COARSENESS,
                "{d} for {brute} at {p:?} of {convex:?}"
            );
            if d < 0.0 {
                inside += 1;
            } else {
                outside += 1;
            }
        }
        assert!(inside > 0 && outside > 50);
    }
}

#[test]
fn quad_distance_is_the_signed_distance() {
    let mut random = Rng::with_seed(22);
    for convex in regions() {
        let region = Piece::new(&convex);
        let term = QuadDistance {
            region: &region,
            keep: 0.05,
        };
        let (mut overlapping, mut apart) = (0, 0);
        for k in 0..600 {
            let z = match k % 5 {
                // Any four ends are mostly so far apart from each other that they surround the region.
                0 => random_quad(&mut random, false),
                1 => {
                    // Beside the region: its hull wide, but not around it.
                    let aside = Point::unit(between(&mut random, -3.2, 3.2)) * 1.2;
                    let mut z = random_quad(&mut random, false);
                    for (k, v) in z.iter_mut().enumerate() {
                        *v += if k % 2 == 0 { aside.x } else { aside.y };
                    }
                    z
                }
                2 => {
                    // Robots that wait: the hull is a line.
                    let z = random_quad(&mut random, true);
                    std::array::from_fn(|k| z[k % 4])
                }
                _ => random_quad(&mut random, true),
            };
            let q = ends(&z);
            let d = term.value(&z) + 0.05;
            let brute = widest_gap(&region, &q);
            assert!(
                d >= brute - 1e-9 && d <= brute + COARSENESS,
                "{d} for {brute} at {z:?} of {convex:?}"
            );
            // Apart, and of a disc always, there is other code that measures exactly.
            let hull = Hull::of(&q);
            let gap = match &convex {
                Convex::Polygon(v) => hull.gap_to_polygon(&Polygon::new(v.clone())),
                Convex::Circle { center, radius } => hull.gap_to_disc(*center, *radius),
            };
            if d <= 0.0 {
                overlapping += 1;
                // Of polygons it measures a depth that is at most the way out.
                assert!(gap.distance <= 1e-12 && gap.distance >= d - 1e-9, "{gap:?}");
            } else {
                apart += 1;
            }
            if d > 0.0 || region.radius > 0.0 {
                assert!((d - gap.distance).abs() < 1e-9, "{d} for {gap:?} at {z:?}");
            }
        }
        assert!(overlapping > 100 && apart > 100, "{overlapping} {apart}");
    }
}

#[test]
fn a_region_within_the_hull_is_seen_though_no_line_meets_it() {
    // Between the lines at both waypoints, and between the robots' paths.
    let quad = [0.0, 0.5, 0.0, -0.5, 0.04, 0.5, 0.04, -0.5];
    let center = Point::new(0.02, 0.1);
    let (w, h) = (Point::new(0.005, 0.0), Point::new(0.0, 0.005));
    let square = Convex::Polygon(vec![
        center - w - h,
        center + w - h,
        center + w + h,
        center - w + h,
    ]);
    let disc = Convex::Circle {
        center,
        radius: 0.005,
    };
    for convex in [square, disc] {
        let region = &Piece::new(&convex);
        let d = QuadDistance { region, keep: 0.0 }.value(&quad);
        assert!((d + 0.025).abs() < 1e-12, "{d}");
    }
}

#[test]
fn the_order_of_the_ends_does_not_matter() {
    let mut random = Rng::with_seed(28);
    for convex in regions() {
        let region = Piece::new(&convex);
        let term = QuadDistance {
            region: &region,
            keep: 0.05,
        };
        for k in 0..200 {
            let z = random_quad(&mut random, k % 2 == 0);
            let d = term.value(&z);
            // Robots swapped, time reversed, one line turned over: bow ties.
            for order in [[1, 0, 3, 2], [2, 3, 0, 1], [0, 1, 3, 2], [0, 3, 1, 2]] {
                let y = std::array::from_fn(|k| z[2 * order[k / 2] + k % 2]);
                assert!((term.value(&y) - d).abs() < 1e-9, "{order:?} of {z:?}");
            }
        }
    }
}

#[test]
fn distances_never_change_faster_than_the_robots_move() {
    let mut random = Rng::with_seed(23);
    for convex in regions() {
        let region = Piece::new(&convex);
        let point = PointDistance {
            region: &region,
            keep: 0.24,
        };
        let quad = QuadDistance {
            region: &region,
            keep: 0.05,
        };
        for walk in 0..200 {
            // A walk across, so that features change many times; some begin at a hull that has collapsed to a line or point.
            let (mut a, b) = (
                random_quad(&mut random, walk % 2 == 0),
                random_quad(&mut random, walk % 2 == 0),
            );
            match walk % 10 {
                0 => a = std::array::from_fn(|k| a[k % 4]),
                1 => a = std::array::from_fn(|k| a[k % 2]),
                _ => {}
            }
            let at = |t: f64| -> [f64; QUAD] { std::array::from_fn(|k| a[k] + t * (b[k] - a[k])) };
            let step = 1.0 / 500.0;
            let moves = [0, 2, 4, 6].map(|k| step * (b[k] - a[k]).hypot(b[k + 1] - a[k + 1]));
            let farthest = moves.iter().fold(0.0, |m: f64, v| m.max(*v));
            for k in 0..500 {
                let (z, y) = (at(f64::from(k) * step), at(f64::from(k + 1) * step));
                let change = (quad.value(&z) - quad.value(&y)).abs();
                assert!(
                    change <= farthest + 1e-9,
                    "{change}, not {farthest}, at {z:?} of {convex:?}"
                );
                let change = point.value(&[z[0], z[1]]) - point.value(&[y[0], y[1]]);
                assert!(change.abs() <= moves[0] + 1e-12, "{change} at {z:?}");
            }
        }
    }
}
