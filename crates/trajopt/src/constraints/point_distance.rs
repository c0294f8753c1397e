use crate::term::{Jet, POINT, Term};
use pairtrawl_geometry::{Convex, Point};

/// A robot's axle center keeps `keep` from a convex region: signed distance minus `keep`.
pub struct PointDistance<'a> {
    /// The region.
    pub region: &'a Convex,
    /// m.
    pub keep: f64,
}

/// What of the region is nearest.
enum Nearest {
    /// A vertex or center, and what to subtract from the distance to it.
    Corner(Point, f64),
    /// A point of an edge and its outward unit normal.
    Edge(Point, Point),
}

fn nearest(region: &Convex, p: Point) -> Nearest {
    let vertices = match region {
        Convex::Circle { center, radius } => return Nearest::Corner(*center, *radius),
        Convex::Polygon(vertices) => vertices,
    };
    let mut best = (f64::NEG_INFINITY, Point::ZERO, Point::ZERO, 0);
    for (i, &a) in vertices.iter().enumerate() {
        let b = vertices[(i + 1) % vertices.len()];
        let edge = b - a;
        let normal = -edge.perp() / edge.norm();
        let outside = normal.dot(p - a);
        if outside > best.0 {
            best = (outside, a, normal, i);
        }
    }
    let (outside, a, normal, i) = best;
    if outside <= 0.0 {
        return Nearest::Edge(a, normal);
    }
    // Outside, the foremost edge need not be the nearest, but the nearest feature is found from all of them.
    let mut least = (f64::INFINITY, Nearest::Edge(a, normal));
    let count = vertices.len();
    for k in 0..count {
        let (a, b) = (vertices[(i + k) % count], vertices[(i + k + 1) % count]);
        let edge = b - a;
        let t = (p - a).dot(edge) / edge.norm_squared();
        let feature = if t <= 0.0 {
            Nearest::Corner(a, 0.0)
        } else if t >= 1.0 {
            Nearest::Corner(b, 0.0)
        } else {
            Nearest::Edge(a, -edge.perp() / edge.norm())
        };
        let distance = match feature {
            Nearest::Corner(v, _) => p.distance(v),
            Nearest::Edge(v, n) => n.dot(p - v).abs(),
        };
        if distance < least.0 {
            least = (distance, feature);
        }
    }
    least.1
}

/// Distance to a point, minus `minus`, with derivatives.
pub(super) fn corner_jet(p: Point, corner: Point, minus: f64) -> Jet<POINT> {
    let d = p.distance(corner).max(1e-9);
    let u = (p - corner) / d;
    let mut jet = Jet::constant(d - minus);
    jet.gradient = [u.x, u.y];
    jet.hessian = [
        [u.y * u.y / d, -u.x * u.y / d],
        [-u.x * u.y / d, u.x * u.x / d],
    ];
    jet
}

impl Term<POINT> for PointDistance<'_> {
    fn value(&self, &[x, y]: &[f64; POINT]) -> f64 {
        let p = Point::new(x, y);
        match nearest(self.region, p) {
            Nearest::Corner(c, minus) => p.distance(c) - minus - self.keep,
            Nearest::Edge(a, n) => n.dot(p - a) - self.keep,
        }
    }

    fn jet(&self, &[x, y]: &[f64; POINT]) -> Jet<POINT> {
        let p = Point::new(x, y);
        match nearest(self.region, p) {
            Nearest::Corner(c, minus) => corner_jet(p, c, minus + self.keep),
            Nearest::Edge(a, n) => {
                let mut jet = Jet::constant(n.dot(p - a) - self.keep);
                jet.gradient = [n.x, n.y];
                jet
            }
        }
    }
}
