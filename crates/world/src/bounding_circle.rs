use pairtrawl_geometry::Point;

/// The smallest circle around a set of points: center and radius, m; the origin and 0 for no point.
///
/// Welzl's incremental algorithm in the order given, deterministic; quadratic at worst for the few points of a cluster.
pub fn minimum_bounding_circle(points: &[Point]) -> (Point, f64) {
    let Some(&first) = points.first() else {
        return (Point::ZERO, 0.0);
    };
    let mut circle = (first, 0.0);
    for (i, &p) in points.iter().enumerate() {
        if contains(circle, p) {
            continue;
        }
        circle = (p, 0.0);
        for (j, &q) in points[..i].iter().enumerate() {
            if contains(circle, q) {
                continue;
            }
            circle = on_diameter(p, q);
            for &r in &points[..j] {
                if !contains(circle, r) {
                    circle = through(p, q, r);
                }
            }
        }
    }
    circle
}

fn contains((center, radius): (Point, f64), p: Point) -> bool {
    center.distance(p) <= radius * (1.0 + 1e-12) + 1e-15
}

fn on_diameter(p: Point, q: Point) -> (Point, f64) {
    (p.lerp(q, 0.5), 0.5 * p.distance(q))
}

/// The circumcircle; for points on a line the circle on the longest side.
fn through(p: Point, q: Point, r: Point) -> (Point, f64) {
    let (a, b) = (q - p, r - p);
    let twice_area = a.cross(b);
    if twice_area.abs() <= 1e-14 * a.norm() * b.norm() {
        return [on_diameter(p, q), on_diameter(p, r), on_diameter(q, r)]
            .into_iter()
            .fold((p, 0.0), |best, c| if c.1 > best.1 { c } else { best });
    }
    let offset = (b.perp() * a.norm_squared() - a.perp() * b.norm_squared()) / (-2.0 * twice_area);
    (p + offset, offset.norm())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The smallest of all circles through two or three of the points that contains them all.
    fn brute_force(points: &[Point]) -> f64 {
        let n = points.len();
        let mut best = if n == 1 { 0.0 } else { f64::INFINITY };
        let mut consider = |center: Point| {
            let radius = points
                .iter()
                .map(|p| p.distance(center))
                .fold(0.0, f64::max);
            best = f64::min(best, radius);
        };
        for i in 0..n {
            for j in 0..i {
                consider(points[i].lerp(points[j], 0.5));
                for k in 0..j {
                    let (p, q, r) = (points[i], points[j], points[k]);
                    let d = 2.0 * (p.x * (q.y - r.y) + q.x * (r.y - p.y) + r.x * (p.y - q.y));
                    let (pp, qq, rr) = (p.norm_squared(), q.norm_squared(), r.norm_squared());
                    let x = (pp * (q.y - r.y) + qq * (r.y - p.y) + rr * (p.y - q.y)) / d;
                    let y = (pp * (r.x - q.x) + qq * (p.x - r.x) + rr * (q.x - p.x)) / d;
                    if x.is_finite() && y.is_finite() {
                        consider(Point::new(x, y));
                    }
                }
            }
        }
        best
    }

    proptest! {
        #[test]
        fn radius_is_the_least_and_all_points_are_inside(raw in prop::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64), 1..9)) {
            let points: Vec<Point> = raw.into_iter().map(|(x, y)| Point::new(x, y)).collect();
            let (center, radius) = minimum_bounding_circle(&points);
            for p in &points {
                prop_assert!(p.distance(center) <= radius + 1e-9);
            }
            prop_assert!((radius - brute_force(&points)).abs() < 1e-9, "{} {}", radius, brute_force(&points));
        }
    }

    #[test]
    fn repeated_points_and_points_on_a_line() {
        let p = Point::new(1.0, 2.0);
        assert_eq!(minimum_bounding_circle(&[p, p, p]), (p, 0.0));
        let line: Vec<Point> = [0.0, 3.0, 1.0, 2.0]
            .iter()
            .map(|&x| Point::new(x, x))
            .collect();
        let (center, radius) = minimum_bounding_circle(&line);
        assert!(
            (radius - 1.5 * 2.0_f64.sqrt()).abs() < 1e-12
                && center.distance(Point::new(1.5, 1.5)) < 1e-12
        );
        assert_eq!(minimum_bounding_circle(&[]).1, 0.0);
    }
}
