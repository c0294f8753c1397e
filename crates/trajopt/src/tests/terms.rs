//! Every cost and constraint under the one derivative check, at random and near-degenerate points.

use super::derivative_check::{Fault, assert_checked, check};
use super::{between, regions};
use crate::constraints::abreast::Abreast;
use crate::constraints::bodies_apart::CirclesApart;
use crate::constraints::carried::Carried;
use crate::constraints::half_plane::HalfPlane;
use crate::constraints::net_reach::NetReach;
use crate::constraints::point_distance::{CenterDistance, PointDistance};
use crate::constraints::separation::{SeparationAbove, SeparationBelow};
use crate::costs::distance::Distance;
use crate::costs::expansion::Expansion;
use crate::costs::smoothness::Smoothness;
use crate::costs::turning::Turning;
use crate::pieces::Piece;
use crate::step_bound::StepBound;
use crate::term::{PAIR, Term};
use fastrand::Rng;
use pairtrawl_geometry::Point;
use pairtrawl_model::Side;
use std::f64::consts::{FRAC_2_PI, PI};

fn expansion() -> Expansion {
    Expansion {
        weight: 1.3,
        kd1: 20.0,
        kd2: 15.0,
        rest_ratio: FRAC_2_PI,
        min_ratio: 0.1,
    }
}

/// A pair at a given separation, everything else random.
fn pair(random: &mut Rng, d: f64, d_max: f64) -> [f64; PAIR] {
    let towards = Point::unit(between(random, -PI, PI)) * d;
    let mut heading = || between(random, -PI, PI);
    [towards.x, towards.y, heading(), heading(), d_max]
}

#[test]
fn expansion_cost() {
    let mut random = Rng::with_seed(1);
    let term = expansion();
    let (rho, sigma) = (term.rest_ratio, term.min_ratio);
    // Where branches meet, as shares of d_max: Taylor extension below, rest, Taylor extension above.
    let joints = [rho - 0.97 * (rho - sigma), rho, rho + 0.97 * (1.0 - rho)];
    let check_at = |random: &mut Rng, eta: f64| {
        let d_max = between(random, 0.8, 3.0);
        let z = pair(random, eta * d_max, d_max);
        let joint = joints
            .iter()
            .fold(f64::INFINITY, |m, j| m.min((eta - j).abs()));
        let reach = (0.4 * joint * d_max).min(0.2 * eta * d_max).min(0.02);
        assert_checked(&term, &z, reach);
    };
    for _ in 0..60 {
        let eta = between(&mut random, 0.02, 1.3);
        if joints.iter().all(|j| (eta - j).abs() > 1e-3) {
            check_at(&mut random, eta);
        }
    }
    for joint in joints {
        for aside in [-1e-2, -1e-3, 1e-3, 1e-2] {
            check_at(&mut random, joint + aside);
        }
    }
    // Either pole, far beyond, almost coincident.
    for eta in [sigma - 1e-3, sigma, sigma + 1e-3, 1.0, 1.001, 2.0, 1e-3] {
        check_at(&mut random, eta);
    }
}

#[test]
fn expansion_cost_joins_smoothly() {
    // Value and gradient meet at every joint, and the second derivative where the polynomials take over.
    let term = expansion();
    let (rho, sigma) = (term.rest_ratio, term.min_ratio);
    for (joint, smooth) in [
        (rho - 0.97 * (rho - sigma), true),
        (rho, false),
        (rho + 0.97 * (1.0 - rho), true),
    ] {
        let jet = |eta: f64| term.jet(&[eta * 1.5, 0.0, 0.0, 0.0, 1.5]);
        let (below, above) = (jet(joint - 1e-10), jet(joint + 1e-10));
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-6 * (1.0 + a.abs());
        assert!(close(below.value, above.value));
        assert!(close(below.gradient[0], above.gradient[0]));
        assert!(close(below.gradient[4], above.gradient[4]));
        assert!(!smooth || close(below.hessian[0][0], above.hessian[0][0]));
    }
}

#[test]
fn expansion_cost_without_negative_curvature() {
    let mut random = Rng::with_seed(2);
    let term = expansion();
    for _ in 0..300 {
        let d_max = between(&mut random, 0.8, 3.0);
        let d = between(&mut random, 0.001, 1.3) * d_max;
        let z = pair(&mut random, d, d_max);
        let (exact, convex) = (term.jet(&z), term.convex_jet(&z));
        assert_eq!(exact.value, convex.value);
        assert_eq!(exact.gradient, convex.gradient);
        let largest = convex
            .hessian
            .iter()
            .flatten()
            .fold(0.0, |m: f64, v| m.max(v.abs()));
        for _ in 0..20 {
            let v: [f64; PAIR] = std::array::from_fn(|_| between(&mut random, -1.0, 1.0));
            let quadratic = |h: &[[f64; PAIR]; PAIR]| -> f64 {
                (0..PAIR)
                    .map(|i| (0..PAIR).map(|j| v[i] * h[i][j] * v[j]).sum::<f64>())
                    .sum()
            };
            let (q, e) = (quadratic(&convex.hessian), quadratic(&exact.hessian));
            assert!(q >= -1e-12 * largest, "{q} at {z:?}");
            assert!(q >= e - 1e-12 * largest, "{q} below the exact {e} at {z:?}");
        }
    }
}

/// At random separations, and with the robots almost coincident.
fn check_pair_term(seed: u64, term: &dyn Term<PAIR>) {
    let mut random = Rng::with_seed(seed);
    for d in [1e-3, 1e-2] {
        let z = pair(&mut random, d, 1.3);
        assert_checked(term, &z, 0.1 * d);
    }
    for _ in 0..40 {
        let d = between(&mut random, 0.1, 2.0);
        let z = pair(&mut random, d, 1.3);
        assert_checked(term, &z, 0.1 * d);
    }
}

#[test]
fn costs_and_bounds_of_steps() {
    for z in [-0.7, -0.1, 0.05, 0.4] {
        for sign in [1.0, -1.0] {
            assert_checked(&StepBound { sign, offset: 0.3 }, &[z], 0.01);
        }
        assert_checked(&Distance { weight: 300.0 }, &[z], 0.01);
        assert_checked(&Turning { weight: 10.0 }, &[z], 0.01);
    }
}

#[test]
fn smoothness() {
    let mut random = Rng::with_seed(9);
    for _ in 0..20 {
        let z = std::array::from_fn(|_| between(&mut random, -2.0, 2.0));
        assert_checked(&Smoothness { weight: 110.0 }, &z, 0.1);
    }
}

#[test]
fn separation() {
    check_pair_term(
        3,
        &SeparationAbove {
            lower: 0.48,
            ratio: 0.1,
        },
    );
    check_pair_term(
        4,
        &SeparationBelow {
            reserve: 1e-3,
            ratio: 0.7,
        },
    );
}

#[test]
fn abreast() {
    for robot in Side::BOTH {
        check_pair_term(
            5,
            &Abreast {
                cos_max_skew: 0.54,
                robot,
            },
        );
    }
}

#[test]
fn net_reach() {
    let term = NetReach {
        hitch: 0.207,
        reserve: 1e-3,
    };
    let mut random = Rng::with_seed(6);
    for _ in 0..60 {
        let d = between(&mut random, 0.6, 2.0);
        let z = pair(&mut random, d, 1.3);
        assert_checked(&term, &z, 0.02);
    }
    // Hitches almost coincident, though the robots are not.
    for gap in [1e-3, 1e-2] {
        let (l, r) = (0.3_f64, 2.9_f64);
        let apart = (Point::unit(l) - Point::unit(r)) * 0.207 + Point::unit(1.0) * gap;
        assert_checked(&term, &[apart.x, apart.y, l, r, 1.3], 0.1 * gap);
    }
}

#[test]
fn points() {
    let mut random = Rng::with_seed(7);
    let plane = HalfPlane {
        normal: [0.6, -0.8],
        offset: 0.3,
    };
    let center = Point::new(0.4, -0.7);
    let disc = CenterDistance { center, keep: 0.3 };
    for d in [1e-3, 1e-2, 0.1, 0.3, 1.0] {
        let p = center + Point::unit(between(&mut random, -PI, PI)) * d;
        assert_checked(&disc, &p.into(), 0.1 * d);
        assert_checked(&plane, &p.into(), 0.1);
    }
}

#[test]
fn points_that_a_robot_carries() {
    let mut random = Rng::with_seed(9);
    let center = Point::new(0.4, -0.7);
    for o in [Point::new(-0.064, 0.0), Point::new(0.3, -0.2)] {
        let disc = Carried {
            point: o,
            term: CenterDistance { center, keep: 0.3 },
        };
        for d in [1e-2, 0.1, 0.3, 1.0] {
            for _ in 0..10 {
                let phi = between(&mut random, -PI, PI);
                let (forward, away) = (Point::unit(phi), between(&mut random, -PI, PI));
                let arm = forward * o.x + forward.perp() * o.y;
                let p = center + Point::unit(away) * d - arm;
                assert_checked(&disc, &[p.x, p.y, phi], 0.1 * d);
            }
        }
    }
    for region in regions() {
        let region = Piece::new(&region);
        let term = Carried {
            point: Point::new(-0.1, 0.05),
            term: PointDistance {
                region: &region,
                keep: 0.19,
            },
        };
        let mut rough = 0;
        for _ in 0..100 {
            let z = [1.0, 1.0, PI].map(|most| between(&mut random, -most, most));
            match check(&term, &z, 1e-3) {
                Ok(()) => {}
                Err(Fault::Rough) => rough += 1,
                fault => panic!("{fault:?}"),
            }
        }
        assert!(rough <= 4, "{rough} of 100 points near a kink");
    }
}

#[test]
fn circles_of_both_bodies() {
    let term = CirclesApart {
        left: Point::new(-0.3, 0.1),
        right: Point::new(0.4, -0.05),
        keep: 0.38,
    };
    let mut random = Rng::with_seed(10);
    for _ in 0..40 {
        let d = between(&mut random, 1.0, 2.0);
        let z = pair(&mut random, d, 1.3);
        assert_checked(&term, &z, 0.05);
    }
    // Almost concentric.
    for gap in [1e-3, 1e-2] {
        let (l, r) = (0.3_f64, 2.9_f64);
        let arm = |p: Point, phi: f64| Point::unit(phi) * p.x + Point::unit(phi).perp() * p.y;
        let apart = arm(term.right, r) - arm(term.left, l) + Point::unit(1.0) * gap;
        assert_checked(&term, &[apart.x, apart.y, l, r, 1.3], 0.1 * gap);
    }
}

#[test]
fn point_off_region() {
    let mut random = Rng::with_seed(8);
    for region in regions() {
        let region = Piece::new(&region);
        let term = PointDistance {
            region: &region,
            keep: 0.24,
        };
        let mut rough = 0;
        for _ in 0..100 {
            let z = [
                between(&mut random, -1.0, 1.0),
                between(&mut random, -1.0, 1.0),
            ];
            match check(&term, &z, 1e-3) {
                Ok(()) => {}
                Err(Fault::Rough) => rough += 1,
                fault => panic!("{fault:?}"),
            }
        }
        assert!(rough <= 4, "{rough} of 100 points near a kink");
        // Beside the lines on which corners hand over to edges, just outside and just inside edges, close to corners.
        for (i, &(normal, length)) in region.edges.iter().enumerate() {
            let (a, along) = (region.vertices[i], normal.perp());
            for out in [1e-2, 0.3] {
                for t in [-1e-3, 1e-3, length - 1e-3, length + 1e-3] {
                    let p = a + normal * out + along * t;
                    assert_checked(&term, &p.into(), 2e-4);
                }
            }
            for out in [-1e-3, 1e-3] {
                let p = a + normal * out + along * (0.5 * length);
                assert_checked(&term, &p.into(), 2e-4);
            }
        }
    }
}
