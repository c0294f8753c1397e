//! Distances of convex pieces, exact up to rounding.

use pairtrawl_geometry::{Bounds, Convex, Point, Segment};

/// Signed distance of a point from a convex piece, m: negative inside, where it is minus the distance to the boundary.
pub fn signed_distance(piece: &Convex, p: Point) -> f64 {
    match piece {
        Convex::Circle { center, radius } => center.distance(p) - radius,
        Convex::Polygon(vertices) => {
            let mut nearest = f64::INFINITY;
            let mut inside = true;
            for (a, b) in edges(vertices) {
                nearest = nearest.min((p - Segment::new(a, b).nearest(p)).norm_squared());
                inside &= (b - a).cross(p - a) >= 0.0;
            }
            if inside {
                -nearest.sqrt()
            } else {
                nearest.sqrt()
            }
        }
    }
}

/// The edges of a closed polygon.
pub fn edges(vertices: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    (0..vertices.len()).map(move |i| (vertices[i], vertices[(i + 1) % vertices.len()]))
}

/// The piece with each point moved by `f`, which must be a rigid motion and a scaling by `scale`.
pub fn moved(piece: &Convex, scale: f64, f: impl Fn(Point) -> Point) -> Convex {
    match piece {
        Convex::Circle { center, radius } => Convex::Circle {
            center: f(*center),
            radius: radius * scale,
        },
        Convex::Polygon(vertices) => Convex::Polygon(vertices.iter().map(|&v| f(v)).collect()),
    }
}

/// True when the piece and the unit square with lower left corner `low` share more than a touch (`slack` deep).
pub fn overlaps_unit_square(piece: &Convex, low: Point, slack: f64) -> bool {
    match piece {
        Convex::Circle { center, radius } => {
            let nearest = Point::new(
                center.x.clamp(low.x, low.x + 1.0),
                center.y.clamp(low.y, low.y + 1.0),
            );
            nearest.distance(*center) < radius - slack
        }
        Convex::Polygon(vertices) => {
            // Separating axes: those of the square (its bounding box), then the normal of each edge.
            let Bounds { min: lo, max: hi } = piece.bounds();
            if lo.x > low.x + 1.0 - slack
                || hi.x < low.x + slack
                || lo.y > low.y + 1.0 - slack
                || hi.y < low.y + slack
            {
                return false;
            }
            edges(vertices).all(|(a, b)| {
                let inward = (b - a).perp();
                let farthest = Point::new(
                    if inward.x > 0.0 { low.x + 1.0 } else { low.x },
                    if inward.y > 0.0 { low.y + 1.0 } else { low.y },
                );
                inward.dot(farthest - a) > slack * inward.norm()
            })
        }
    }
}

/// True when two convex pieces share a region more than `slack` (m) deep.
pub fn overlap(a: &Convex, b: &Convex, slack: f64) -> bool {
    match (a, b) {
        (Convex::Circle { center, radius }, other) | (other, Convex::Circle { center, radius }) => {
            signed_distance(other, *center) < radius - slack
        }
        (Convex::Polygon(p), Convex::Polygon(q)) => {
            !is_separated(p, q, slack) && !is_separated(q, p, slack)
        }
    }
}

/// True when an edge of the first polygon has the whole second one on its outer side, up to `slack`.
fn is_separated(p: &[Point], q: &[Point], slack: f64) -> bool {
    edges(p).any(|(a, b)| {
        let inward = (b - a).perp();
        q.iter()
            .all(|v| inward.dot(*v - a) <= slack * inward.norm())
    })
}
