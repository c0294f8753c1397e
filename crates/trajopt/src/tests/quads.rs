//! What the line between the robots sweeps in a step, under the derivative check: at random points and where the hull of its
//! ends nearly degenerates.

use super::derivative_check::{Fault, assert_checked, check, slope};
use super::{between, regions};
use crate::constraints::quad_distance::QuadDistance;
use crate::pieces::Piece;
use crate::term::{QUAD, Term};
use fastrand::Rng;
use pairtrawl_geometry::Point;
use std::f64::consts::PI;

fn flat(ends: [Point; 4]) -> [f64; QUAD] {
    std::array::from_fn(|k| {
        let p = ends[k / 2];
        if k % 2 == 0 { p.x } else { p.y }
    })
}

fn random_point(random: &mut Rng, half: f64) -> Point {
    Point::new(between(random, -half, half), between(random, -half, half))
}

/// Checks many points, of which a few may lie near a kink.
struct Trials<'a> {
    term: QuadDistance<'a>,
    tried: usize,
    rough: usize,
}

impl<'a> Trials<'a> {
    fn of(region: &'a Piece) -> Self {
        Self {
            term: QuadDistance { region, keep: 0.05 },
            tried: 0,
            rough: 0,
        }
    }

    fn try_at(&mut self, ends: [Point; 4], reach: f64) {
        self.tried += 1;
        match check(&self.term, &flat(ends), reach) {
            Ok(()) => {}
            Err(Fault::Rough) => self.rough += 1,
            fault => panic!("{fault:?}"),
        }
    }

    /// Only the slope, from values much nearer to the point: second differences would be rounding.
    fn try_slope_at(&mut self, ends: [Point; 4]) {
        self.tried += 1;
        let z = flat(ends);
        let (value, gradient) = self.term.slope(&z);
        assert!((value - self.term.value(&z)).abs() < 1e-12);
        for (k, given) in gradient.into_iter().enumerate() {
            let found = slope(
                |h| {
                    let mut moved = z;
                    moved[k] += h;
                    self.term.value(&moved)
                },
                2e-6,
            );
            if found.error > 1e-5 {
                self.rough += 1;
                return;
            }
            assert!(
                (given - found.value).abs() < 1e-6 + 3.0 * found.error,
                "gradient[{k}]: {given}, by differences {found:?}, at {z:?}"
            );
        }
    }

    /// At most one point in `share` was near a kink.
    fn mostly_smooth(&self, share: usize) {
        let (tried, rough) = (self.tried, self.rough);
        assert!(
            share * rough <= tried,
            "{rough} of {tried} points near a kink"
        );
    }
}

/// A line between robots that passes a point at a distance, the point at a share of its length: its left and right end.
fn line_past(random: &mut Rng, p: Point, aside: f64, share: f64) -> (Point, Point) {
    let along = Point::unit(between(random, -PI, PI));
    let length = between(random, 0.5, 1.2);
    let foot = p + along.perp() * aside;
    (
        foot + along * ((1.0 - share) * length),
        foot - along * (share * length),
    )
}

#[test]
fn hulls_of_any_four_ends() {
    // Convex position in any order, so that diagonals cross or sides do (a bow tie), and one end inside the others; apart
    // and overlapping.
    let mut random = Rng::with_seed(9);
    for convex in regions() {
        let region = Piece::new(&convex);
        let mut trials = Trials::of(&region);
        for k in 0..400 {
            let half = if k % 2 == 0 { 1.2 } else { 0.5 };
            let ends = std::array::from_fn(|_| random_point(&mut random, half));
            trials.try_at(ends, 1e-3);
        }
        trials.mostly_smooth(20);
    }
}

#[test]
fn short_steps_past_a_corner() {
    // The point faces the inside of a long side, its end just within and just beyond, near and far, from either side.
    let mut random = Rng::with_seed(25);
    for convex in regions() {
        let region = Piece::new(&convex);
        let mut trials = Trials::of(&region);
        for &corner in &region.vertices {
            for aside in [-0.3, -1e-2, 1e-2, 0.3] {
                for share in [-2e-3, 2e-3, 0.3, 0.5, 1.0 - 2e-3, 1.0 + 2e-3] {
                    let (l, r) = line_past(&mut random, corner, aside, share);
                    // Away from the corner, a robot's step each.
                    let on = (l - r).perp() * (aside.signum() * 0.03);
                    let [dl, dr] = [0, 1].map(|_| random_point(&mut random, 5e-3));
                    trials.try_at([l, r, l + on + dl, r + on + dr], 2e-4);
                    // Over the corner, or towards it.
                    trials.try_at([l, r, l - on + dl, r - on + dr], 2e-4);
                }
            }
        }
        trials.mostly_smooth(12);
    }
}

#[test]
fn hulls_that_nearly_collapse() {
    let mut random = Rng::with_seed(26);
    for convex in regions() {
        let region = Piece::new(&convex);
        let mut trials = Trials::of(&region);
        for _ in 0..60 {
            let (l, r) = (
                random_point(&mut random, 1.0),
                random_point(&mut random, 1.0),
            );
            let tiny = |random: &mut Rng| random_point(random, 1e-3);
            // Both robots wait, one waits, the line turns about its middle (a bow tie), robots swap places, all at one spot.
            let middle = l.lerp(r, 0.5);
            let turned = (l - middle) + (l - middle).perp() * 0.03;
            let lists = [
                [l, r, l, r],
                [l, r, l, r + Point::new(0.03, -0.02)],
                [l, r, middle + turned, middle - turned],
                [l, r, r, l],
                [l, l, l, l],
            ];
            for ends in lists {
                let mut ends = ends;
                ends.iter_mut().for_each(|p| *p += tiny(&mut random));
                trials.try_slope_at(ends);
            }
        }
        trials.mostly_smooth(20);
    }
}

#[test]
fn a_waiting_pair_has_finite_slopes() {
    // The hull is exactly a line, or exactly a point: at a kink there is no derivative, but a slope of length 1 for one
    // motion of the whole hull, which no search direction shall make infinite.
    let mut random = Rng::with_seed(27);
    for convex in regions() {
        let region = Piece::new(&convex);
        let term = QuadDistance {
            region: &region,
            keep: 0.05,
        };
        for k in 0..200 {
            let l = random_point(&mut random, 0.8);
            let r = if k % 4 == 0 {
                l
            } else {
                random_point(&mut random, 0.8)
            };
            let on = r + (r - l) * 0.03;
            for ends in [[l, r, l, r], [l, r, r, l], [l, r, l, on], [l, l, r, r]] {
                let z = flat(ends);
                let (value, gradient) = term.slope(&z);
                assert!((value - term.value(&z)).abs() < 1e-12);
                let jet = term.jet(&z);
                assert!(jet.gradient == gradient && jet.value == value);
                assert!(jet.hessian.iter().flatten().all(|h| h.is_finite()));
                let whole = |v: usize| gradient.iter().skip(v).step_by(2).sum::<f64>();
                let steepness = whole(0).hypot(whole(1));
                assert!((steepness - 1.0).abs() < 1e-9, "{steepness} at {z:?}");
            }
        }
    }
}

#[test]
fn a_side_over_a_corner_bends_as_it_should() {
    // Box [-0.3, 0.3] x [-0.2, 0.2], lines above it: its corner (0.3, 0.2) is nearest, the side beneath it is that of the
    // first line, then a robot's path, then one from either robot to the other.
    let region = Piece::new(&regions()[1]);
    let term = QuadDistance {
        region: &region,
        keep: 0.05,
    };
    let (low, high) = (
        [Point::new(-0.5, 0.9), Point::new(0.9, 0.4)],
        [Point::new(-0.45, 1.3), Point::new(1.3, 0.9)],
    );
    for (order, sides) in [
        ([0, 1, 2, 3], [0, 1]),
        ([2, 3, 0, 1], [2, 3]),
        ([0, 2, 1, 3], [0, 2]),
        ([2, 0, 3, 1], [1, 3]),
        ([0, 2, 3, 1], [0, 3]),
        ([2, 0, 1, 3], [1, 2]),
    ] {
        let four = [low[0], low[1], high[0], high[1]];
        let z = flat(order.map(|k| four[k]));
        assert_checked(&term, &z, 1e-2);
        let (_, gradient) = term.slope(&z);
        for k in 0..4 {
            let still = gradient[2 * k..2 * k + 2].iter().all(|g| *g == 0.0);
            assert_eq!(still, !sides.contains(&k), "end {k} of {order:?}");
        }
    }
    // An end over an edge, over a corner; then the line dips into the box, corner first and side first.
    let at = |x: f64, y: f64| Point::new(x, y);
    for ends in [
        [at(-0.1, 0.3), at(0.1, 0.9), at(-0.05, 0.5), at(0.15, 1.0)],
        [at(0.4, 0.3), at(0.9, 0.9), at(0.45, 0.5), at(1.0, 0.9)],
        [at(-0.1, 0.15), at(0.1, 0.9), at(-0.05, 0.5), at(0.15, 1.0)],
        [at(-0.1, 0.6), at(0.9, -0.5), at(0.3, 0.6), at(1.0, -0.2)],
    ] {
        assert_checked(&term, &flat(ends), 2e-3);
    }
    // Discs: beside the hull, and with their center inside it.
    let region = Piece::new(&regions()[3]);
    let term = QuadDistance {
        region: &region,
        keep: 0.05,
    };
    for aside in [0.4, -0.12] {
        let c = Point::new(0.1, -0.2 + aside);
        let ends = [
            c + at(-0.3, 0.02),
            c + at(0.4, -0.03),
            c + at(-0.3, 0.5),
            c + at(0.4, 0.4),
        ];
        assert_checked(&term, &flat(ends), 2e-3);
    }
}
