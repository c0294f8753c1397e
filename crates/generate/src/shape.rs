use pairtrawl_geometry::{Bounds, Point, Segment};
use pairtrawl_model::Obstacle;

/// Distance between the segments a b and c d; 0 when they cross.
pub(crate) fn segment_segment(a: Point, b: Point, c: Point, d: Point) -> f64 {
    let side = |p: Point, q: Point, r: Point| (q - p).cross(r - p);
    if side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0 {
        return 0.0;
    }
    let (one, other) = (Segment::new(a, b), Segment::new(c, d));
    (other.distance(a).min(other.distance(b)))
        .min(one.distance(c))
        .min(one.distance(d))
}

/// Corners of a box, counter-clockwise.
pub(crate) fn corners(min: Point, max: Point) -> [Point; 4] {
    [min, Point::new(max.x, min.y), max, Point::new(min.x, max.y)]
}

/// Distance from a segment to a convex, counter-clockwise polygon; 0 when they touch or overlap.
fn segment_polygon(a: Point, b: Point, polygon: &[Point]) -> f64 {
    let edges = || (0..polygon.len()).map(|i| (polygon[i], polygon[(i + 1) % polygon.len()]));
    if edges().all(|(p, q)| (q - p).cross(a - p) >= 0.0) {
        return 0.0;
    }
    edges()
        .map(|(p, q)| segment_segment(a, b, p, q))
        .fold(f64::INFINITY, f64::min)
}

/// Distance from a segment to an obstacle whose polygon is convex and counter-clockwise, as all generated ones are.
pub(crate) fn segment_obstacle(a: Point, b: Point, obstacle: &Obstacle) -> f64 {
    match obstacle {
        Obstacle::Box { min, max } => segment_polygon(a, b, &corners(*min, *max)),
        Obstacle::Polygon(vertices) => segment_polygon(a, b, vertices),
        Obstacle::Circle { center, radius } => {
            (Segment::new(a, b).distance(*center) - radius).max(0.0)
        }
    }
}

/// The obstacle's bounding box.
pub(crate) fn bounds(obstacle: &Obstacle) -> Bounds {
    match obstacle {
        Obstacle::Box { min, max } => Bounds {
            min: *min,
            max: *max,
        },
        Obstacle::Circle { center, radius } => Bounds::of_disc(*center, *radius),
        Obstacle::Polygon(vertices) => Bounds::of(vertices),
    }
}

/// The obstacle, moved.
pub(crate) fn moved(obstacle: &Obstacle, by: Point) -> Obstacle {
    match obstacle {
        Obstacle::Box { min, max } => Obstacle::Box {
            min: *min + by,
            max: *max + by,
        },
        Obstacle::Polygon(vertices) => {
            Obstacle::Polygon(vertices.iter().map(|p| *p + by).collect())
        }
        Obstacle::Circle { center, radius } => Obstacle::Circle {
            center: *center + by,
            radius: *radius,
        },
    }
}

/// The obstacle with its coordinates rounded to millimeters, as a person would write them.
pub(crate) fn rounded(obstacle: &Obstacle) -> Obstacle {
    let mm = |v: f64| (v * 1000.0).round() / 1000.0;
    let point = |p: Point| Point::new(mm(p.x), mm(p.y));
    match obstacle {
        Obstacle::Box { min, max } => Obstacle::Box {
            min: point(*min),
            max: point(*max),
        },
        Obstacle::Polygon(vertices) => {
            Obstacle::Polygon(vertices.iter().map(|p| point(*p)).collect())
        }
        Obstacle::Circle { center, radius } => Obstacle::Circle {
            center: point(*center),
            radius: mm(*radius),
        },
    }
}
