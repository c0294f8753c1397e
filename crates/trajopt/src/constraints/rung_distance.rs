use super::PointDistance;
use crate::pieces::Piece;
use crate::term::{Jet, RUNG, Term};
use pairtrawl_geometry::Point;

/// The line between the robots keeps `keep` from a convex region: signed distance (along the best separating axis when
/// they overlap) minus `keep`. Robots keep their own radius; this matters where a corner pokes between them.
pub struct RungDistance<'a> {
    /// The region.
    pub region: &'a Piece,
    /// m.
    pub keep: f64,
}

/// Which pair of features is nearest.
enum Nearest {
    /// The left end.
    Left,
    /// The right end.
    Right,
    /// A corner over the inside of the line, and 1 when it lies to the left of right -> left, else -1.
    Inside(Point, f64),
    /// An edge of the region is the best separating axis of an overlap: a point of it, its normal, the deeper end is left.
    Axis(Point, Point, bool),
}

fn nearest(region: &Piece, l: Point, r: Point) -> Nearest {
    let (corners, radius) = (&region.vertices, region.radius);
    let rung = l - r;
    let length = rung.norm_squared().sqrt().max(1e-9);
    let normal = rung.perp() / length;
    // Sides of the corners against the rung's line, and the nearest corner over its inside.
    let (mut low, mut high) = ((f64::INFINITY, corners[0]), (f64::NEG_INFINITY, corners[0]));
    let mut over = (f64::INFINITY, Nearest::Left);
    for &c in corners {
        let side = normal.dot(c - r);
        if side < low.0 {
            low = (side, c);
        }
        if side > high.0 {
            high = (side, c);
        }
        let t = (c - r).dot(rung);
        if t >= 0.0 && t <= length * length && side.abs() - radius < over.0 {
            over = (side.abs() - radius, Nearest::Inside(c, side.signum()));
        }
    }
    let at = |p: Point| PointDistance { region, keep: 0.0 }.value(&[p.x, p.y]);
    let (line_gap, line) = if low.0 >= -high.0 {
        (low.0 - radius, Nearest::Inside(low.1, 1.0))
    } else {
        (-high.0 - radius, Nearest::Inside(high.1, -1.0))
    };
    let nearer_end = || {
        let (gap_l, gap_r) = (at(l), at(r));
        if gap_l <= gap_r {
            (gap_l, Nearest::Left)
        } else {
            (gap_r, Nearest::Right)
        }
    };
    if region.edges.is_empty() {
        // A disc: its center lies over the inside of the line, or an end is nearest, overlapping or not.
        return if over.0.is_finite() {
            over.1
        } else {
            nearer_end().1
        };
    }
    if line_gap > 0.0 {
        let end = nearer_end();
        return if over.0 < end.0 { over.1 } else { end.1 };
    }
    // The line's own axis does not separate; an edge's may.
    let mut axis = (f64::NEG_INFINITY, Nearest::Left);
    for (&a, &(n, _)) in corners.iter().zip(&region.edges) {
        let (left, right) = (n.dot(l - a), n.dot(r - a));
        if left.min(right) > axis.0 {
            axis = (left.min(right), Nearest::Axis(a, n, left < right));
        }
    }
    if axis.0 > 0.0 {
        return nearer_end().1;
    }
    if axis.0 > line_gap { axis.1 } else { line }
}

impl RungDistance<'_> {
    fn point(&self) -> PointDistance<'_> {
        PointDistance {
            region: self.region,
            keep: self.keep,
        }
    }
}

impl Term<RUNG> for RungDistance<'_> {
    fn value(&self, &[lx, ly, rx, ry]: &[f64; RUNG]) -> f64 {
        let (l, r) = (Point::new(lx, ly), Point::new(rx, ry));
        match nearest(self.region, l, r) {
            Nearest::Left => self.point().value(&[lx, ly]),
            Nearest::Right => self.point().value(&[rx, ry]),
            Nearest::Inside(c, sign) => {
                let side = sign * (l - r).cross(c - r) / (l - r).norm_squared().sqrt();
                side - self.region.radius - self.keep
            }
            Nearest::Axis(a, n, left) => n.dot(if left { l } else { r } - a) - self.keep,
        }
    }

    fn jet(&self, &[lx, ly, rx, ry]: &[f64; RUNG]) -> Jet<RUNG> {
        let (l, r) = (Point::new(lx, ly), Point::new(rx, ry));
        let end = |end: Jet<2>, at: usize| {
            let mut jet = Jet::constant(end.value);
            for i in 0..2 {
                jet.gradient[at + i] = end.gradient[i];
                for j in 0..2 {
                    jet.hessian[at + i][at + j] = end.hessian[i][j];
                }
            }
            jet
        };
        match nearest(self.region, l, r) {
            Nearest::Left => end(self.point().jet(&[lx, ly]), 0),
            Nearest::Right => end(self.point().jet(&[rx, ry]), 2),
            Nearest::Axis(a, n, left) => {
                let mut jet = Jet::constant(n.dot(if left { l } else { r } - a) - self.keep);
                let at = if left { 0 } else { 2 };
                jet.gradient[at] = n.x;
                jet.gradient[at + 1] = n.y;
                jet
            }
            Nearest::Inside(c, sign) => inside_jet(l, r, c, sign, self.region.radius + self.keep),
        }
    }
}

/// `sign (l - r) x (c - r) / |l - r| - minus` with derivatives in `l` and `r`.
fn inside_jet(l: Point, r: Point, c: Point, sign: f64, minus: f64) -> Jet<RUNG> {
    let e = l - r;
    let n = e.norm_squared().sqrt();
    let q = c - r;
    let a = e.cross(q);
    // a = e x q; derivatives in (lx, ly, rx, ry).
    let ga = [q.y, -q.x, e.y - q.y, q.x - e.x];
    let u = e / n;
    let gn = [u.x, u.y, -u.x, -u.y];
    let mut jet = Jet::constant(sign * a / n - minus);
    let bend = [u.y, -u.x, -u.y, u.x];
    for i in 0..4 {
        jet.gradient[i] = sign * (ga[i] / n - a * gn[i] / (n * n));
        for j in 0..4 {
            let hn = bend[i] * bend[j] / n;
            jet.hessian[i][j] = sign
                * (-(ga[i] * gn[j] + ga[j] * gn[i]) / (n * n)
                    + 2.0 * a * gn[i] * gn[j] / (n * n * n)
                    - a * hn / (n * n));
        }
    }
    // Mixed second derivatives of a: lx ry: -1 ... (e x q = (l - r) x (c - r) is bilinear in l and r).
    let mixed = sign / n;
    for (i, j, v) in [(0, 3, -1.0), (1, 2, 1.0)] {
        jet.hessian[i][j] += mixed * v;
        jet.hessian[j][i] += mixed * v;
    }
    jet
}
