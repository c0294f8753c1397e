//! Distances, overlaps and coverage against dense sampling that shares no code with the crate.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use pairtrawl_geometry::{Hull, Point, Polygon, PolygonError, Segment, SweptLine, orient2d};
use proptest::prelude::*;

fn point() -> impl Strategy<Value = Point> {
    (-2.0..2.0, -2.0..2.0).prop_map(|(x, y)| Point::new(x, y))
}

/// Coordinates from a coarse grid: touching, collinear and coincident points abound.
fn grid_point() -> impl Strategy<Value = Point> {
    (-4..=4, -4..=4).prop_map(|(x, y)| Point::new(f64::from(x) * 0.5, f64::from(y) * 0.5))
}

/// A simple polygon around a center, star-shaped, in either orientation.
fn star() -> impl Strategy<Value = Vec<Point>> {
    (
        point(),
        prop::collection::vec(0.2..1.5, 3..9),
        0.0..6.0,
        any::<bool>(),
    )
        .prop_map(|(center, radii, turn, reverse)| {
            let n = radii.len() as f64;
            let corner = |(i, r): (usize, &f64)| {
                let a: f64 = turn + std::f64::consts::TAU * i as f64 / n;
                Point::new(center.x + r * a.cos(), center.y + r * a.sin())
            };
            let mut corners: Vec<Point> = radii.iter().enumerate().map(corner).collect();
            if reverse {
                corners.reverse();
            }
            corners
        })
}

fn blend(a: Point, b: Point, t: f64) -> (f64, f64) {
    ((1.0 - t) * a.x + t * b.x, (1.0 - t) * a.y + t * b.y)
}

fn apart(a: (f64, f64), b: (f64, f64)) -> f64 {
    ((a.0 - b.0).powi(2) + (a.1 - b.1).powi(2)).sqrt()
}

/// Points along a segment, spaced by its length / n.
fn along(a: Point, b: Point, n: usize) -> impl Iterator<Item = (f64, f64)> {
    (0..=n).map(move |k| blend(a, b, k as f64 / n as f64))
}

/// Crossing-number test, good away from the boundary.
fn inside(polygon: &[Point], p: (f64, f64)) -> bool {
    let mut odd = false;
    for i in 0..polygon.len() {
        let (a, b) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        if (a.y > p.1) != (b.y > p.1) && p.0 < a.x + (b.x - a.x) * (p.1 - a.y) / (b.y - a.y) {
            odd = !odd;
        }
    }
    odd
}

/// Points of the hull of up to four points: convex combinations on a grid.
fn hull_samples(points: [Point; 4], n: usize) -> Vec<(f64, f64)> {
    let mut out = Vec::new();
    for i in 0..=n {
        for j in 0..=n - i {
            for k in 0..=n - i - j {
                let w = [i, j, k, n - i - j - k].map(|c| c as f64 / n as f64);
                let sum =
                    |f: fn(Point) -> f64| points.iter().zip(w).map(|(p, w)| w * f(*p)).sum::<f64>();
                out.push((sum(|p| p.x), sum(|p| p.y)));
            }
        }
    }
    out
}

proptest! {
    #[test]
    fn segment_distances_match_samples(a in point(), b in point(), c in point(), d in point()) {
        let (s, t) = (Segment::new(a, b), Segment::new(c, d));
        let sampled = along(a, b, 300).map(|p| apart(p, (c.x, c.y))).fold(f64::INFINITY, f64::min);
        prop_assert!((s.distance(c) - sampled).abs() < 0.01);
        let gap = s.gap_to_segment(&t);
        let sampled = along(a, b, 200)
            .flat_map(|p| along(c, d, 200).map(move |q| apart(p, q)))
            .fold(f64::INFINITY, f64::min);
        prop_assert!(gap.distance <= sampled + 1e-12 && sampled < gap.distance + 0.03, "{gap:?} {sampled}");
        prop_assert!((t.distance(gap.place) - gap.distance).abs() < 1e-9);
        prop_assert!((t.gap_to_segment(&s).distance - gap.distance).abs() < 1e-12);
    }

    #[test]
    fn segments_on_a_grid_intersect_as_integers_say(a in grid_point(), b in grid_point(), c in grid_point(), d in grid_point()) {
        // Halves are exact in binary: signs of doubled coordinates are integer arithmetic.
        let int = |p: Point| ((p.x * 2.0) as i64, (p.y * 2.0) as i64);
        let [a2, b2, c2, d2] = [a, b, c, d].map(int);
        let turn = |p: (i64, i64), q: (i64, i64), r: (i64, i64)| {
            ((q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0)).signum()
        };
        let on = |p: (i64, i64), q: (i64, i64), r: (i64, i64)| {
            turn(p, q, r) == 0
                && r.0 >= p.0.min(q.0) && r.0 <= p.0.max(q.0) && r.1 >= p.1.min(q.1) && r.1 <= p.1.max(q.1)
        };
        let expected = (turn(a2, b2, c2) * turn(a2, b2, d2) < 0 && turn(c2, d2, a2) * turn(c2, d2, b2) < 0)
            || on(a2, b2, c2) || on(a2, b2, d2) || on(c2, d2, a2) || on(c2, d2, b2);
        let (s, t) = (Segment::new(a, b), Segment::new(c, d));
        prop_assert_eq!(s.intersects(&t), expected);
        prop_assert_eq!(s.gap_to_segment(&t).distance == 0.0, expected);
    }

    #[test]
    fn polygons_contain_what_the_crossing_number_says(corners in star(), p in point()) {
        let polygon = Polygon::new(corners.clone());
        prop_assert_eq!(polygon.check(), Ok(()));
        let d = polygon.boundary_distance(p);
        if d > 1e-9 {
            prop_assert_eq!(polygon.contains(p), inside(&corners, (p.x, p.y)));
            prop_assert_eq!(polygon.signed_distance(p) < 0.0, polygon.contains(p));
        }
        let n = corners.len();
        let sampled = (0..n)
            .flat_map(|i| along(corners[i], corners[(i + 1) % n], 300))
            .map(|q| apart(q, (p.x, p.y)))
            .fold(f64::INFINITY, f64::min);
        prop_assert!(d <= sampled + 1e-12 && sampled < d + 0.01);
    }

    #[test]
    fn triangles_tile_the_polygon(corners in star(), p in point()) {
        let polygon = Polygon::new(corners);
        let triangles = polygon.triangles();
        let area = |t: &[Point; 3]| 0.5 * (t[1] - t[0]).cross(t[2] - t[0]);
        prop_assert!(triangles.iter().all(|t| area(t) > 0.0));
        prop_assert!((triangles.iter().map(area).sum::<f64>() - polygon.signed_area().abs()).abs() < 1e-9);
        if polygon.boundary_distance(p) > 1e-9 {
            let covered = triangles.iter().any(|t| Polygon::new(t.to_vec()).contains(p));
            prop_assert_eq!(covered, polygon.contains(p));
        }
    }

    #[test]
    fn polygon_checks_find_every_clash(corners in prop::collection::vec(grid_point(), 3..8)) {
        let polygon = Polygon::new(corners.clone());
        let n = corners.len();
        let edge = |i: usize| Segment::new(corners[i], corners[(i + 1) % n]);
        let repeated = (0..n).any(|i| corners[i] == corners[(i + 1) % n]);
        // Two edges clash when they meet; neighbors when they meet beyond their shared vertex.
        let clash = (0..n).any(|i| (0..i).any(|j| {
            if j + 1 == i || (j == 0 && i + 1 == n) {
                let (s, t) = (edge(i), edge(j));
                let shared = [s.a, s.b].into_iter().find(|p| *p == t.a || *p == t.b);
                let other = |s: Segment| if Some(s.a) == shared { s.b } else { s.a };
                s.distance(other(t)) == 0.0 || t.distance(other(s)) == 0.0
            } else {
                edge(i).intersects(&edge(j))
            }
        }));
        let flat = (0..n).all(|i| orient2d(corners[0], corners[1], corners[i]) == 0.0);
        prop_assert_eq!(polygon.check().is_ok(), !repeated && !clash && !flat, "{:?}", polygon.check());
    }

    #[test]
    fn hulls_contain_their_points_and_turn_left(points in prop::collection::vec(grid_point(), 1..6)) {
        let hull = Hull::of(&points);
        let v = hull.vertices();
        if v.len() >= 3 {
            prop_assert!((0..v.len()).all(|i| orient2d(v[i], v[(i + 1) % v.len()], v[(i + 2) % v.len()]) > 0.0));
            prop_assert!(points.iter().all(|&p| hull.edges().all(|e| orient2d(e.a, e.b, p) >= 0.0)));
        } else {
            prop_assert!(points.iter().all(|&p| hull.vertices().contains(&p)
                || hull.edges().any(|e| orient2d(e.a, e.b, p) == 0.0 && e.distance(p) < 1e-12)));
        }
        prop_assert!(v.iter().all(|p| points.contains(p)));
    }

    #[test]
    fn hulls_overlap_polygons_where_samples_do(points in prop::array::uniform4(point()), corners in star()) {
        let polygon = Polygon::new(corners.clone());
        let gap = Hull::of(&points).gap_to_polygon(&polygon);
        let samples = hull_samples(points, 24);
        let edges: Vec<Segment> = polygon.edges().collect();
        let signed = |p: (f64, f64)| {
            let d = edges.iter().map(|e| e.distance(Point::new(p.0, p.1))).fold(f64::INFINITY, f64::min);
            if inside(&corners, p) { -d } else { d }
        };
        let sampled = samples.into_iter().map(signed).fold(f64::INFINITY, f64::min);
        // A sample inside means an overlap at least as deep as half of what it shows; none means at most the spacing.
        if sampled < -1e-9 {
            prop_assert!(gap.distance < 0.0, "{gap:?} {sampled}");
        }
        if gap.distance >= 0.0 {
            prop_assert!(gap.distance <= sampled + 1e-9 && sampled < gap.distance + 0.3, "{gap:?} {sampled}");
        }
        if gap.distance < -0.3 {
            prop_assert!(sampled < 0.0, "{gap:?} {sampled}");
        }
    }

    #[test]
    fn hulls_keep_their_distance_from_discs(points in prop::array::uniform4(point()), center in point(), radius in 0.0..1.0) {
        let gap = Hull::of(&points).gap_to_disc(center, radius);
        let sampled = hull_samples(points, 24)
            .into_iter()
            .map(|p| apart(p, (center.x, center.y)) - radius)
            .fold(f64::INFINITY, f64::min);
        prop_assert!(gap.distance <= sampled + 1e-12);
        prop_assert!(gap.distance < -radius || sampled < gap.distance + 0.3);
    }

    #[test]
    fn a_swept_line_covers_what_its_samples_pass_over(l0 in point(), r0 in point(), l in point(), r in point(), p in point()) {
        let (l1, r1) = (l0 + l * 0.2, r0 + r * 0.2);
        let swept = SweptLine { left: Segment::new(l0, l1), right: Segment::new(r0, r1) };
        let coverage = swept.coverage(p);
        let n = 400;
        let slack = (l.norm().max(r.norm())) * 0.2 / n as f64;
        let mut before: Option<(f64, f64)> = None;
        let (mut best, mut nearest) = (f64::NEG_INFINITY, f64::INFINITY);
        for k in 0..=n {
            let t = k as f64 / n as f64;
            let (a, b) = (blend(l0, l1, t), blend(r0, r1, t));
            let (d, e) = ((b.0 - a.0, b.1 - a.1), (p.x - a.0, p.y - a.1));
            let length = d.0.hypot(d.1);
            let side = (d.0 * e.1 - d.1 * e.0) / length;
            let u = (d.0 * e.0 + d.1 * e.1) / length;
            let inner = u.min(length - u);
            nearest = nearest.min(side.abs().max(-inner));
            if let Some((side0, inner0)) = before && side0 * side <= 0.0 {
                best = f64::max(best, inner0.min(inner) - slack);
            }
            before = Some((side, inner));
        }
        if best > 0.0 {
            prop_assert!(coverage.margin >= best - slack, "{coverage:?} {best}");
            let t = coverage.instant.expect("an instant");
            prop_assert!(swept.at(t).distance(p) < 1e-9);
        }
        if nearest > 2.0 * slack {
            prop_assert!(coverage.instant.is_none() && coverage.margin < 0.0, "{coverage:?} {nearest}");
            prop_assert!(-coverage.margin >= nearest - 2.0 * slack);
        }
    }
}

#[test]
fn a_line_that_crosses_is_an_overlap_however_thin() {
    let square = Polygon::rectangle(Point::ZERO, Point::new(1.0, 1.0));
    let through = Hull::of(&[Point::new(-1.0, 0.5), Point::new(2.0, 0.5)]);
    assert_eq!(through.gap_to_polygon(&square).distance, -0.5);
    let along_edge = Hull::of(&[Point::new(-1.0, 1.0), Point::new(2.0, 1.0)]);
    assert_eq!(along_edge.gap_to_polygon(&square).distance, 0.0);
    let same = Hull::of(square.vertices());
    assert_eq!(same.gap_to_polygon(&square).distance, -0.5);
    let above = Hull::of(&[
        Point::new(0.0, 1.25),
        Point::new(1.0, 1.25),
        Point::new(0.5, 2.0),
        Point::new(0.4, 1.9),
    ]);
    assert_eq!(above.gap_to_polygon(&square).distance, 0.25);
    // A hull around a small polygon, and within a large one.
    let around = Hull::of(&[
        Point::new(-3.0, -3.0),
        Point::new(4.0, -3.0),
        Point::new(4.0, 4.0),
        Point::new(-3.0, 4.0),
    ]);
    assert!(around.gap_to_polygon(&square).distance < 0.0);
    assert!(
        Hull::of(&[Point::new(0.4, 0.5), Point::new(0.6, 0.5)])
            .gap_to_polygon(&square)
            .distance
            < 0.0
    );
    assert_eq!(
        Hull::of(&[Point::new(0.5, 3.0)])
            .gap_to_polygon(&square)
            .distance,
        2.0
    );
}

#[test]
fn orientation_is_exact_where_rounding_would_decide() {
    let (a, b) = (Point::new(12.0, 12.0), Point::new(24.0, 24.0));
    let ulp = 2.0_f64.powi(-53);
    for i in 0..64 {
        for j in 0..64 {
            let p = Point::new(0.5 + f64::from(i) * ulp, 0.5 + f64::from(j) * ulp);
            // b - a is along the diagonal: the sign is that of p.y - p.x, and coordinates are exact.
            assert_eq!(orient2d(a, b, p) > 0.0, p.y > p.x);
            assert_eq!(orient2d(a, b, p) == 0.0, p.y == p.x);
        }
    }
}

#[test]
fn malformed_polygons_are_told_apart() {
    let p = Point::new;
    let check = |v: &[Point]| Polygon::new(v.to_vec()).check();
    assert_eq!(
        check(&[p(0.0, 0.0), p(1.0, 0.0)]),
        Err(PolygonError::TooFewVertices(2))
    );
    assert_eq!(
        check(&[p(0.0, 0.0), p(f64::NAN, 0.0), p(1.0, 1.0)]),
        Err(PolygonError::NotFinite(1))
    );
    assert_eq!(
        check(&[p(0.0, 0.0), p(1.0, 1.0), p(2.0, 2.0)]),
        Err(PolygonError::NoArea)
    );
    assert_eq!(
        check(&[p(0.0, 0.0), p(1.0, 0.0), p(1.0, 0.0), p(0.0, 1.0)]),
        Err(PolygonError::RepeatedVertex(1, 2))
    );
    let bow = [p(0.0, 0.0), p(1.0, 1.0), p(1.0, 0.0), p(0.0, 1.0)];
    assert_eq!(check(&bow), Err(PolygonError::SelfIntersection(0, 2)));
}

#[test]
fn a_point_is_covered_at_the_ends_of_a_step_and_of_the_line() {
    let p = Point::new;
    let swept = SweptLine {
        left: Segment::new(p(0.0, 1.0), p(1.0, 1.0)),
        right: Segment::new(p(0.0, 0.0), p(1.0, 0.0)),
    };
    for (x, y, margin) in [
        (0.0, 0.5, 0.5),
        (1.0, 0.25, 0.25),
        (0.5, 0.75, 0.25),
        (0.3, 1.0, 0.0),
        (0.0, 0.0, 0.0),
    ] {
        let coverage = swept.coverage(p(x, y));
        assert!(
            (coverage.margin - margin).abs() < 1e-12 && coverage.instant.is_some(),
            "{coverage:?}"
        );
    }
    let beside = swept.coverage(p(0.5, 1.25));
    assert_eq!((beside.margin, beside.instant), (-0.25, None));
    // A line that moves along itself covers its track; one that stands still covers itself.
    let slide = SweptLine {
        left: Segment::new(p(0.0, 0.0), p(1.0, 0.0)),
        right: Segment::new(p(2.0, 0.0), p(3.0, 0.0)),
    };
    assert!(slide.coverage(p(1.0, 0.0)).margin >= 0.0 && slide.coverage(p(2.5, 0.0)).margin >= 0.0);
    let still = SweptLine {
        left: Segment::new(p(0.0, 0.0), p(0.0, 0.0)),
        right: Segment::new(p(2.0, 0.0), p(2.0, 0.0)),
    };
    assert_eq!(still.coverage(p(0.5, 0.0)).margin, 0.5);
    assert_eq!(still.coverage(p(0.5, 0.5)).margin, -0.5);
}
