//! Curves through points: even resampling, tangents, continuous headings.

use pairtrawl_geometry::{Point, Pose, wrap_angle};

/// Arc length at every vertex.
pub(crate) fn arc_lengths(points: &[Point]) -> Vec<f64> {
    let mut s = Vec::with_capacity(points.len());
    let mut total = 0.0;
    for (i, p) in points.iter().enumerate() {
        if i > 0 {
            total += p.distance(points[i - 1]);
        }
        s.push(total);
    }
    s
}

/// Points evenly spaced along the polyline, at most `spacing` apart, both ends kept.
pub(crate) fn resample(points: &[Point], spacing: f64) -> Vec<Point> {
    let s = arc_lengths(points);
    let Some(&length) = s.last() else {
        return Vec::new();
    };
    let n = (length / spacing).ceil().max(1.0) as usize;
    let mut segment = 0;
    (0..=n)
        .map(|i| {
            let at = length * i as f64 / n as f64;
            while segment + 2 < s.len() && s[segment + 1] < at {
                segment += 1;
            }
            if i == n {
                return points[points.len() - 1];
            }
            let step = s[segment + 1] - s[segment];
            let t = if step > 0.0 {
                ((at - s[segment]) / step).clamp(0.0, 1.0)
            } else {
                0.0
            };
            points[segment].lerp(points[segment + 1], t)
        })
        .collect()
}

/// Points on the cubic through the vertices (centripetal data are even here, so Catmull-Rom), `parts` a segment.
pub(crate) fn refine(points: &[Point], parts: usize) -> Vec<Point> {
    let n = points.len();
    if n < 3 {
        return points.to_vec();
    }
    let mut fine = Vec::with_capacity(n * parts);
    let tangent = |i: usize| {
        if i == 0 {
            points[1] - points[0]
        } else if i == n - 1 {
            points[n - 1] - points[n - 2]
        } else {
            (points[i + 1] - points[i - 1]) * 0.5
        }
    };
    for i in 0..n - 1 {
        let (a, b, ta, tb) = (points[i], points[i + 1], tangent(i), tangent(i + 1));
        for k in 0..parts {
            let t = k as f64 / parts as f64;
            let (t2, t3) = (t * t, t * t * t);
            fine.push(
                a * (2.0 * t3 - 3.0 * t2 + 1.0)
                    + ta * (t3 - 2.0 * t2 + t)
                    + b * (3.0 * t2 - 2.0 * t3)
                    + tb * (t3 - t2),
            );
        }
    }
    fine.push(points[n - 1]);
    fine
}

/// Unit tangents by central differences; a repeated point takes its predecessor's.
pub(crate) fn tangents(points: &[Point]) -> Vec<Point> {
    let n = points.len();
    let mut last = Point::new(1.0, 0.0);
    (0..n)
        .map(|i| {
            let d = points[(i + 1).min(n - 1)] - points[i.saturating_sub(1)];
            if d.norm() > 1e-12 {
                last = d / d.norm();
            }
            last
        })
        .collect()
}

/// The angle equivalent to `angle` that is nearest to `reference`.
pub(crate) fn near_angle(angle: f64, reference: f64) -> f64 {
    reference + wrap_angle(angle - reference)
}

/// Poses with tangent headings, continuous from `first` on; the last heading is `last` modulo 2 pi.
pub(crate) fn with_headings(points: &[Point], first: f64, last: f64) -> Vec<Pose> {
    let directions = tangents(points);
    let n = points.len();
    let mut heading = first;
    (0..n)
        .map(|i| {
            let raw = match i {
                0 => first,
                i if i + 1 == n => last,
                _ => directions[i].angle(),
            };
            heading = near_angle(raw, heading);
            Pose::at(points[i], heading)
        })
        .collect()
}
