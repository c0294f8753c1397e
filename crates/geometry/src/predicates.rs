use crate::Point;
use robust::Coord;

/// Twice the signed area of the triangle a, b, c: positive when c lies left of the line from a to b.
///
/// The sign is exact (Shewchuk's adaptive predicate) for finite input without over- or underflow.
pub fn orient2d(a: Point, b: Point, c: Point) -> f64 {
    let coord = |p: Point| Coord { x: p.x, y: p.y };
    robust::orient2d(coord(a), coord(b), coord(c))
}

/// True when the closed segments ab and cd share a point; exact.
pub fn segments_intersect(a: Point, b: Point, c: Point, d: Point) -> bool {
    let (abc, abd) = (orient2d(a, b, c), orient2d(a, b, d));
    let (cda, cdb) = (orient2d(c, d, a), orient2d(c, d, b));
    if abc == 0.0 && abd == 0.0 && cda == 0.0 && cdb == 0.0 {
        // All on one line: they meet when their bounding boxes do.
        let overlap = |a0: f64, a1: f64, b0: f64, b1: f64| {
            a0.min(a1) <= b0.max(b1) && b0.min(b1) <= a0.max(a1)
        };
        return overlap(a.x, b.x, c.x, d.x) && overlap(a.y, b.y, c.y, d.y);
    }
    let one_side = |s: f64, t: f64| (s > 0.0 && t > 0.0) || (s < 0.0 && t < 0.0);
    !one_side(abc, abd) && !one_side(cda, cdb)
}
