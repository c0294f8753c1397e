//! Where two shapes touch or will touch: a normal and up to two points.
//!
//! For two polygons the edge with the greatest separation from the other polygon is the face of contact (separating axis
//! theorem); the other polygon's most opposed edge is clipped to it, which gives two points where edges face each other.
//! Corners that face each other, and discs, touch in one point along the line between them. Separations are exact for
//! shapes that are apart and depths along the face's normal for shapes that overlap.

use crate::outline::Outline;
use pairtrawl_geometry::Point;

/// Corners nearer than this to the other shape count as touching its face, m.
const TOUCHING: f64 = 1e-9;

/// Up to two points of contact of a shape A with a shape B.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Manifold {
    /// Unit vector from A to B.
    pub(crate) normal: Point,
    /// Place (midway between the surfaces) and separation (negative: depth), m.
    pub(crate) points: [(Point, f64); 2],
    pub(crate) count: usize,
}

impl Manifold {
    const NONE: Self = Self {
        normal: Point::ZERO,
        points: [(Point::ZERO, 0.0); 2],
        count: 0,
    };

    fn one(normal: Point, place: Point, separation: f64) -> Self {
        let mut manifold = Self {
            normal,
            ..Self::NONE
        };
        manifold.points[0] = (place, separation);
        manifold.count = 1;
        manifold
    }

    fn reversed(mut self) -> Self {
        self.normal = -self.normal;
        self
    }
}

/// Points at which A and B are nearer than `reach` (m) to each other.
pub(crate) fn between(a: Outline<'_>, b: Outline<'_>, reach: f64) -> Manifold {
    match (a.points.len(), b.points.len()) {
        (1, 1) => corner_to_corner(a.points[0], b.points[0], a.radius, b.radius, reach),
        (_, 1) => polygon_and_disc(a, b, reach),
        (1, _) => polygon_and_disc(b, a, reach).reversed(),
        _ => polygons(a, b, reach),
    }
}

fn corner_to_corner(a: Point, b: Point, radius_a: f64, radius_b: f64, reach: f64) -> Manifold {
    let line = b - a;
    let distance = line.norm();
    let separation = distance - radius_a - radius_b;
    if separation > reach {
        return Manifold::NONE;
    }
    let normal = if distance > 0.0 {
        line / distance
    } else {
        Point::new(1.0, 0.0)
    };
    let place = a + normal * (radius_a + 0.5 * separation);
    Manifold::one(normal, place, separation)
}

fn polygon_and_disc(a: Outline<'_>, b: Outline<'_>, reach: f64) -> Manifold {
    let center = b.points[0];
    let (edge, separation) = farthest_edge(a, b);
    if separation - a.radius - b.radius > reach {
        return Manifold::NONE;
    }
    let (p, q) = (a.points[edge], a.points[(edge + 1) % a.points.len()]);
    let along = q - p;
    if separation > TOUCHING {
        if (center - p).dot(along) < 0.0 {
            return corner_to_corner(p, center, a.radius, b.radius, reach);
        }
        if (center - q).dot(along) > 0.0 {
            return corner_to_corner(q, center, a.radius, b.radius, reach);
        }
    }
    let normal = a.normals[edge];
    let gap = separation - a.radius - b.radius;
    Manifold::one(normal, center - normal * (b.radius + 0.5 * gap), gap)
}

/// The edge of A from which B is farthest, and how far.
fn farthest_edge(a: Outline<'_>, b: Outline<'_>) -> (usize, f64) {
    let (mut edge, mut separation) = (0, f64::NEG_INFINITY);
    for (i, (p, n)) in a.points.iter().zip(a.normals).enumerate() {
        let mut nearest = f64::INFINITY;
        for q in b.points {
            nearest = nearest.min(n.dot(*q - *p));
        }
        if nearest > separation {
            (edge, separation) = (i, nearest);
        }
    }
    (edge, separation)
}

fn polygons(a: Outline<'_>, b: Outline<'_>, reach: f64) -> Manifold {
    let limit = reach + a.radius + b.radius;
    let (edge_a, apart_a) = farthest_edge(a, b);
    if apart_a > limit {
        return Manifold::NONE;
    }
    let (edge_b, apart_b) = farthest_edge(b, a);
    if apart_b > limit {
        return Manifold::NONE;
    }
    // A is preferred, so that the choice does not flicker between faces that are equally far.
    if apart_b > apart_a + 1e-5 {
        face(b, edge_b, apart_b, a, reach).reversed()
    } else {
        face(a, edge_a, apart_a, b, reach)
    }
}

/// Contact of the polygon `other` with an edge of `a`.
fn face(a: Outline<'_>, edge: usize, apart: f64, other: Outline<'_>, reach: f64) -> Manifold {
    let normal = a.normals[edge];
    let (a0, a1) = (a.points[edge], a.points[(edge + 1) % a.points.len()]);
    let count = other.points.len();
    let mut facing = 0;
    let mut least = f64::INFINITY;
    for (i, n) in other.normals.iter().enumerate() {
        let along = n.dot(normal);
        if along < least {
            (facing, least) = (i, along);
        }
    }
    // In the order in which they lie along A's edge.
    let (b1, b0) = (other.points[facing], other.points[(facing + 1) % count]);
    if apart > TOUCHING {
        let (at_a, at_b) = nearest_on_segments(a0, a1, b0, b1);
        let end = |t: f64| t <= 0.0 || t >= 1.0;
        if end(at_a) && end(at_b) {
            let (p, q) = (a0.lerp(a1, at_a), b0.lerp(b1, at_b));
            return corner_to_corner(p, q, a.radius, other.radius, reach);
        }
    }
    clip(normal, [a0, a1], a.radius, [b0, b1], other.radius, reach)
}

/// The part of B's edge that lies over A's edge, at its two ends.
fn clip(
    normal: Point,
    a: [Point; 2],
    radius_a: f64,
    b: [Point; 2],
    radius_b: f64,
    reach: f64,
) -> Manifold {
    let tangent = normal.perp();
    let high_a = (a[1] - a[0]).dot(tangent);
    let (low, high) = ((b[0] - a[0]).dot(tangent), (b[1] - a[0]).dot(tangent));
    let at = |t: f64| {
        if high - low > f64::EPSILON {
            b[0].lerp(b[1], ((t - low) / (high - low)).clamp(0.0, 1.0))
        } else {
            b[0]
        }
    };
    let mut manifold = Manifold {
        normal,
        ..Manifold::NONE
    };
    let (first, second) = (low.max(0.0), high.min(high_a));
    let ends: &[f64] = if second < first - TOUCHING {
        // The edges pass each other: the nearest corner of B is what touches.
        &[0.5 * (first + second)]
    } else if second - first <= TOUCHING {
        &[first]
    } else {
        &[first, second]
    };
    for &t in ends {
        let q = at(t);
        let separation = (q - a[0]).dot(normal) - radius_a - radius_b;
        if separation <= reach {
            let place = q - normal * (radius_b + 0.5 * separation);
            manifold.points[manifold.count] = (place, separation);
            manifold.count += 1;
        }
    }
    manifold
}

/// Where on two segments (fractions) they are nearest to each other, for segments that do not cross.
fn nearest_on_segments(p0: Point, p1: Point, q0: Point, q1: Point) -> (f64, f64) {
    let (d, e, r) = (p1 - p0, q1 - q0, p0 - q0);
    let (dd, ee) = (d.norm_squared(), e.norm_squared());
    let (rd, re, de) = (r.dot(d), r.dot(e), d.dot(e));
    let denominator = dd * ee - de * de;
    let mut s = if denominator > 1e-12 * dd * ee {
        ((de * re - rd * ee) / denominator).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let mut t = (de * s + re) / ee;
    if t < 0.0 {
        t = 0.0;
        s = (-rd / dd).clamp(0.0, 1.0);
    } else if t > 1.0 {
        t = 1.0;
        s = ((de - rd) / dd).clamp(0.0, 1.0);
    }
    (s, t)
}
