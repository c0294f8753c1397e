use crate::{Bounds, Point, Segment, orient2d};
use thiserror::Error;

/// A closed polygon, convex or not, in either orientation. The last vertex is joined to the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    vertices: Vec<Point>,
    bounds: Bounds,
}

/// Why a list of vertices is no simple polygon.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum PolygonError {
    /// Fewer than three vertices.
    #[error("a polygon needs at least 3 vertices, this one has {0}: add the missing ones")]
    TooFewVertices(usize),
    /// A coordinate is NaN or infinite.
    #[error("vertex {0} of the polygon is not finite: give two finite numbers, in meters")]
    NotFinite(usize),
    /// Two neighboring vertices coincide.
    #[error("vertices {0} and {1} of the polygon are the same point: leave one out")]
    RepeatedVertex(usize, usize),
    /// Two edges meet elsewhere than in a shared vertex.
    #[error(
        "the polygon crosses or touches itself: the edges after vertices {0} and {1} meet; reorder the vertices"
    )]
    SelfIntersection(usize, usize),
    /// All vertices lie on a line.
    #[error("the polygon has no area: its vertices lie on one line")]
    NoArea,
}

impl Polygon {
    /// A polygon with these vertices; [`Self::check`] tells whether it is simple.
    pub fn new(vertices: Vec<Point>) -> Self {
        let bounds = Bounds::of(&vertices);
        Self { vertices, bounds }
    }

    /// The axis-parallel box between two opposite corners, counter-clockwise from `min`.
    pub fn rectangle(min: Point, max: Point) -> Self {
        Self::new(vec![
            min,
            Point::new(max.x, min.y),
            max,
            Point::new(min.x, max.y),
        ])
    }

    /// The vertices in the given order.
    pub fn vertices(&self) -> &[Point] {
        &self.vertices
    }

    /// The bounding box.
    pub const fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// The edges, the closing one last.
    pub fn edges(&self) -> impl Iterator<Item = Segment> + '_ {
        let next = self.vertices.iter().cycle().skip(1);
        self.vertices
            .iter()
            .zip(next)
            .map(|(&a, &b)| Segment::new(a, b))
    }

    /// Signed area, positive for counter-clockwise vertices, m^2.
    pub fn signed_area(&self) -> f64 {
        let Some(&o) = self.vertices.first() else {
            return 0.0;
        };
        0.5 * self.edges().map(|e| (e.a - o).cross(e.b - o)).sum::<f64>()
    }

    /// Checks that this is a simple polygon of positive area: at least three finite vertices, no edge of length zero,
    /// no two edges that meet elsewhere than in the vertex they share.
    ///
    /// # Errors
    /// The first fault, with the indices of the vertices concerned.
    pub fn check(&self) -> Result<(), PolygonError> {
        let n = self.vertices.len();
        if let Some(i) = self.vertices.iter().position(|v| !v.is_finite()) {
            return Err(PolygonError::NotFinite(i));
        }
        if n < 3 {
            return Err(PolygonError::TooFewVertices(n));
        }
        let edges: Vec<Segment> = self.edges().collect();
        if let Some(i) = edges.iter().position(|e| e.a == e.b) {
            return Err(PolygonError::RepeatedVertex(i, (i + 1) % n));
        }
        let [a, b] = [self.vertices[0], self.vertices[1]];
        if self.vertices.iter().all(|&c| orient2d(a, b, c) == 0.0) {
            return Err(PolygonError::NoArea);
        }
        // Sweep along x, so that only edges with overlapping x ranges are compared.
        let low = |e: &Segment| e.a.x.min(e.b.x);
        let mut by_x: Vec<usize> = (0..n).collect();
        by_x.sort_by(|&i, &j| low(&edges[i]).total_cmp(&low(&edges[j])).then(i.cmp(&j)));
        for (k, &i) in by_x.iter().enumerate() {
            let high = edges[i].a.x.max(edges[i].b.x);
            for &j in by_x[k + 1..]
                .iter()
                .take_while(|&&j| low(&edges[j]) <= high)
            {
                let (p, q) = (i.min(j), i.max(j));
                if edges_clash(&edges, p, q) {
                    return Err(PolygonError::SelfIntersection(p, q));
                }
            }
        }
        Ok(())
    }

    /// True when the polygon is convex (either orientation, collinear vertices allowed); meaningful for simple ones.
    pub fn is_convex(&self) -> bool {
        let (v, n) = (&self.vertices, self.vertices.len());
        let turns = || (0..n).map(|i| orient2d(v[i], v[(i + 1) % n], v[(i + 2) % n]));
        turns().all(|t| t >= 0.0) || turns().all(|t| t <= 0.0)
    }

    /// Triangles, counter-clockwise, that tile a simple polygon (ear clipping). Vertices on a straight line yield none;
    /// a polygon that fails [`Self::check`] yields an incomplete list.
    pub fn triangles(&self) -> Vec<[Point; 3]> {
        let mut rest = self.vertices.clone();
        if self.signed_area() < 0.0 {
            rest.reverse();
        }
        let mut out = Vec::with_capacity(rest.len().saturating_sub(2));
        while rest.len() >= 3 {
            let n = rest.len();
            let corner = |i: usize| [rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]];
            let is_flat = |i: &usize| {
                let [a, b, c] = corner(*i);
                orient2d(a, b, c) == 0.0
            };
            let is_ear = |i: &usize| {
                let [a, b, c] = corner(*i);
                let inside = |&p: &Point| {
                    p != a
                        && p != b
                        && p != c
                        && orient2d(a, b, p) >= 0.0
                        && orient2d(b, c, p) >= 0.0
                        && orient2d(c, a, p) >= 0.0
                };
                orient2d(a, b, c) > 0.0 && !rest.iter().any(inside)
            };
            let Some(i) = (0..n).find(is_flat).or_else(|| (0..n).find(is_ear)) else {
                break;
            };
            if !is_flat(&i) {
                out.push(corner(i));
            }
            rest.remove(i);
        }
        out
    }

    /// True when the point lies inside or on an edge (nonzero winding; exact).
    pub fn contains(&self, p: Point) -> bool {
        if !self.bounds.contains(p) {
            return false;
        }
        let mut winding = 0_i64;
        for Segment { a, b } in self.edges() {
            let side = orient2d(a, b, p);
            if side == 0.0 && Bounds::of(&[a, b]).contains(p) {
                return true;
            }
            if a.y <= p.y && b.y > p.y && side > 0.0 {
                winding += 1;
            } else if a.y > p.y && b.y <= p.y && side < 0.0 {
                winding -= 1;
            }
        }
        winding != 0
    }

    /// Distance from a point to the boundary, m; infinite without vertices.
    pub fn boundary_distance(&self, p: Point) -> f64 {
        self.edges()
            .map(|e| e.distance(p))
            .fold(f64::INFINITY, f64::min)
    }

    /// Signed distance from a point: negative inside.
    pub fn signed_distance(&self, p: Point) -> f64 {
        let d = self.boundary_distance(p);
        if self.contains(p) { -d } else { d }
    }
}

/// True when edges `i < j` meet elsewhere than in the vertex that neighbors share.
fn edges_clash(edges: &[Segment], i: usize, j: usize) -> bool {
    let (first, second, neighbors) = if i + 1 == j {
        (edges[i], edges[j], true)
    } else if i == 0 && j + 1 == edges.len() {
        (edges[j], edges[i], true)
    } else {
        (edges[i], edges[j], false)
    };
    if !neighbors {
        return first.intersects(&second);
    }
    // first.b == second.a: they clash only when the second folds back onto the first.
    orient2d(first.a, first.b, second.b) == 0.0
        && (first.a - first.b).dot(second.b - second.a) > 0.0
}
