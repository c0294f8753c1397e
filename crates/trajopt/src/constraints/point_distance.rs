use crate::pieces::Piece;
use crate::term::{Jet, POINT, Term};
use pairtrawl_geometry::Point;

/// A robot's axle center keeps `keep` from a convex region: signed distance minus `keep`.
pub struct PointDistance<'a> {
    /// The region.
    pub region: &'a Piece,
    /// m.
    pub keep: f64,
}

/// A robot's axle center keeps `keep` from a point.
pub struct CenterDistance {
    /// The point.
    pub center: Point,
    /// m.
    pub keep: f64,
}

/// What of the region is nearest.
enum Nearest {
    /// A vertex or center.
    Corner(Point),
    /// A point of an edge and its outward unit normal.
    Edge(Point, Point),
}

fn nearest(region: &Piece, p: Point) -> Nearest {
    let vertices = &region.vertices;
    if region.edges.is_empty() {
        return Nearest::Corner(vertices[0]);
    }
    // The foremost edge is nearest inside, and outside when the point lies over it; else a corner or another edge that
    // faces the point is.
    let mut foremost = (f64::NEG_INFINITY, 0);
    let mut best = (f64::INFINITY, Nearest::Corner(vertices[0]));
    for (i, (&a, &(normal, length))) in vertices.iter().zip(&region.edges).enumerate() {
        let out = p - a;
        let outside = normal.dot(out);
        if outside > foremost.0 {
            foremost = (outside, i);
        }
        if outside > 0.0 {
            let t = normal.perp().dot(out);
            let squared = if t < 0.0 {
                out.norm_squared()
            } else if t > length {
                outside * outside + (t - length) * (t - length)
            } else {
                outside * outside
            };
            if squared < best.0 {
                let feature = if t < 0.0 {
                    Nearest::Corner(a)
                } else if t > length {
                    Nearest::Corner(vertices[(i + 1) % vertices.len()])
                } else {
                    Nearest::Edge(a, normal)
                };
                best = (squared, feature);
            }
        }
    }
    if best.0.is_finite() {
        best.1
    } else {
        Nearest::Edge(vertices[foremost.1], region.edges[foremost.1].0)
    }
}

impl Term<POINT> for CenterDistance {
    #[inline]
    fn value(&self, &[x, y]: &[f64; POINT]) -> f64 {
        Point::new(x, y).distance(self.center) - self.keep
    }

    #[inline]
    fn slope(&self, &[x, y]: &[f64; POINT]) -> (f64, [f64; POINT]) {
        let p = Point::new(x, y);
        let d = p.distance(self.center).max(1e-9);
        let u = (p - self.center) / d;
        (d - self.keep, [u.x, u.y])
    }

    fn jet(&self, z: &[f64; POINT]) -> Jet<POINT> {
        let (value, gradient) = self.slope(z);
        let mut jet = Jet::constant(value);
        jet.gradient = gradient;
        let u = Point::from(gradient);
        let d = value + self.keep;
        jet.hessian = [
            [u.y * u.y / d, -u.x * u.y / d],
            [-u.x * u.y / d, u.x * u.x / d],
        ];
        jet
    }
}

impl Term<POINT> for PointDistance<'_> {
    #[inline]
    fn value(&self, &[x, y]: &[f64; POINT]) -> f64 {
        let p = Point::new(x, y);
        let keep = self.keep + self.region.radius;
        match nearest(self.region, p) {
            Nearest::Corner(center) => CenterDistance { center, keep }.value(&[x, y]),
            Nearest::Edge(a, n) => n.dot(p - a) - keep,
        }
    }

    #[inline]
    fn slope(&self, &[x, y]: &[f64; POINT]) -> (f64, [f64; POINT]) {
        let p = Point::new(x, y);
        let keep = self.keep + self.region.radius;
        match nearest(self.region, p) {
            Nearest::Corner(center) => CenterDistance { center, keep }.slope(&[x, y]),
            Nearest::Edge(a, n) => (n.dot(p - a) - keep, [n.x, n.y]),
        }
    }

    fn jet(&self, &[x, y]: &[f64; POINT]) -> Jet<POINT> {
        let p = Point::new(x, y);
        let keep = self.keep + self.region.radius;
        match nearest(self.region, p) {
            Nearest::Corner(center) => CenterDistance { center, keep }.jet(&[x, y]),
            Nearest::Edge(a, n) => {
                let mut jet = Jet::constant(n.dot(p - a) - keep);
                jet.gradient = [n.x, n.y];
                jet
            }
        }
    }
}
