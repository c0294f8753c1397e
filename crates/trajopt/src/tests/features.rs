//! Distances to convex regions against brute force: along every direction there is, and from point to point.

use super::{between, regions};
use crate::constraints::{PointDistance, RungDistance};
use crate::pieces::Piece;
use crate::term::{RUNG, Term};
use fastrand::Rng;
use pairtrawl_geometry::{Convex, Point, Polygon, Segment};

const DIRECTIONS: usize = 3600;

/// The signed distance of two convex sets is the widest gap between them seen along any direction: apart it is their
/// distance, overlapping it is minus the shortest way out.
fn widest_gap(region: &Piece, l: Point, r: Point) -> f64 {
    let gap = |k: usize| {
        let n = Point::unit(std::f64::consts::TAU * k as f64 / DIRECTIONS as f64);
        let farthest = region
            .vertices
            .iter()
            .map(|v| n.dot(*v))
            .fold(f64::NEG_INFINITY, f64::max);
        n.dot(l).min(n.dot(r)) - farthest - region.radius
    };
    (0..DIRECTIONS).map(gap).fold(f64::NEG_INFINITY, f64::max)
}

/// Seen along the nearest direction, a gap is at most this much less than along the best one, m.
const COARSENESS: f64 = 3e-3;

fn random_rung(random: &mut Rng) -> [f64; RUNG] {
    std::array::from_fn(|_| between(random, -0.9, 0.9))
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
            let brute = widest_gap(&region, p, p);
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
fn rung_distance_is_the_signed_distance() {
    let mut random = Rng::with_seed(22);
    for convex in regions() {
        let region = Piece::new(&convex);
        let term = RungDistance {
            region: &region,
            keep: 0.05,
        };
        let (mut overlapping, mut apart) = (0, 0);
        for _ in 0..400 {
            let z = random_rung(&mut random);
            let (l, r) = (Point::new(z[0], z[1]), Point::new(z[2], z[3]));
            let d = term.value(&z) + 0.05;
            let brute = widest_gap(&region, l, r);
            assert!(
                d >= brute - 1e-12 && d <= brute + COARSENESS,
                "{d} for {brute} at {z:?} of {convex:?}"
            );
            if d <= 0.0 {
                overlapping += 1;
                continue;
            }
            apart += 1;
            // Apart there is other code that measures exactly.
            let segment = Segment { a: l, b: r };
            let gap = match &convex {
                Convex::Polygon(v) => segment.gap_to_polygon(&Polygon::new(v.clone())),
                Convex::Circle { center, radius } => segment.gap_to_disc(*center, *radius),
            };
            assert!((d - gap.distance).abs() < 1e-12, "{d} for {gap:?} at {z:?}");
        }
        assert!(overlapping > 30 && apart > 30, "{overlapping} {apart}");
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
        let rung = RungDistance {
            region: &region,
            keep: 0.05,
        };
        for _ in 0..100 {
            // A walk across, so that features change many times.
            let (a, b) = (random_rung(&mut random), random_rung(&mut random));
            let at = |t: f64| -> [f64; RUNG] { std::array::from_fn(|k| a[k] + t * (b[k] - a[k])) };
            let step = 1.0 / 500.0;
            let move_l = step * (b[0] - a[0]).hypot(b[1] - a[1]);
            let move_r = step * (b[2] - a[2]).hypot(b[3] - a[3]);
            for k in 0..500 {
                let (z, y) = (at(f64::from(k) * step), at(f64::from(k + 1) * step));
                let change = (rung.value(&z) - rung.value(&y)).abs();
                assert!(
                    change <= move_l.max(move_r) + 1e-12,
                    "{change} at {z:?} of {convex:?}"
                );
                let change = point.value(&[z[0], z[1]]) - point.value(&[y[0], y[1]]);
                assert!(change.abs() <= move_l + 1e-12, "{change} at {z:?}");
            }
        }
    }
}
