use crate::{Bounds, Gap, Point, Polygon, Segment, orient2d};

/// The convex hull of a few points; it may degenerate to a segment or a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Hull {
    /// Counter-clockwise, no three on a line.
    vertices: Vec<Point>,
    bounds: Bounds,
}

impl Hull {
    /// The hull of the points (Andrew's monotone chain with an exact predicate).
    pub fn of(points: &[Point]) -> Self {
        let mut sorted = points.to_vec();
        sorted.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
        sorted.dedup();
        let bounds = Bounds::of(&sorted);
        if sorted.len() < 3 {
            return Self {
                vertices: sorted,
                bounds,
            };
        }
        let mut vertices = chain(sorted.iter().copied());
        vertices.pop();
        let mut upper = chain(sorted.iter().rev().copied());
        upper.pop();
        vertices.append(&mut upper);
        Self { vertices, bounds }
    }

    /// The vertices, counter-clockwise.
    pub fn vertices(&self) -> &[Point] {
        &self.vertices
    }

    /// The bounding box.
    pub const fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// The edges: none for a point, one for a segment.
    pub fn edges(&self) -> impl Iterator<Item = Segment> + '_ {
        let n = self.vertices.len();
        let count = if n < 3 { n.saturating_sub(1) } else { n };
        (0..count).map(move |i| Segment::new(self.vertices[i], self.vertices[(i + 1) % n]))
    }

    /// True when the point lies in the interior; exact. A hull without area has none.
    pub fn contains_strictly(&self, p: Point) -> bool {
        self.vertices.len() >= 3 && self.edges().all(|e| orient2d(e.a, e.b, p) > 0.0)
    }

    /// Distance from a point to the boundary and the nearest point there.
    fn boundary_gap(&self, p: Point) -> Gap {
        let to = |place: Point| Gap {
            distance: place.distance(p),
            place,
        };
        self.edges()
            .map(|e| to(e.nearest(p)))
            .chain(self.vertices.iter().map(|&v| to(v)))
            .reduce(Gap::min)
            .unwrap_or(Gap {
                distance: f64::INFINITY,
                place: p,
            })
    }

    /// Signed distance to a disc: the distance of the closed sets, or minus the least translation that parts them.
    pub fn gap_to_disc(&self, center: Point, radius: f64) -> Gap {
        let boundary = self.boundary_gap(center);
        if self.contains_strictly(center) {
            Gap {
                distance: -boundary.distance - radius,
                place: center,
            }
        } else {
            Gap {
                distance: boundary.distance - radius,
                place: boundary.place,
            }
        }
    }

    /// Signed distance to a simple polygon of positive area, convex or not.
    ///
    /// Positive: the exact distance. Zero: they touch, interiors apart. Negative: they overlap; the depth is the
    /// greatest distance to the other shape's boundary found among the vertices and the middles of edge pieces of one
    /// shape inside the other. It is positive whenever the overlap has area, and also where a hull without area
    /// (a segment) passes through the polygon's interior; it never exceeds the translation that would part them.
    pub fn gap_to_polygon(&self, polygon: &Polygon) -> Gap {
        if let Some(deepest) = self.deepest_in(polygon) {
            return deepest;
        }
        let far = Gap {
            distance: f64::INFINITY,
            place: Point::ZERO,
        };
        if self.vertices.len() == 1 {
            let place = self.vertices[0];
            return Gap {
                distance: polygon.boundary_distance(place),
                place,
            };
        }
        self.edges()
            .flat_map(|e| polygon.edges().map(move |f| e.gap_to_segment(&f)))
            .fold(far, Gap::min)
    }

    /// The deepest common point, when the shapes overlap by more than a touch.
    fn deepest_in(&self, polygon: &Polygon) -> Option<Gap> {
        if self.bounds.distance(&polygon.bounds()) > 0.0 {
            return None;
        }
        let mut deepest = Gap {
            distance: 0.0,
            place: Point::ZERO,
        };
        let mut consider = |place: Point, depth: f64| {
            deepest = deepest.min(Gap {
                distance: -depth,
                place,
            })
        };
        let mut own = |p: Point| {
            if polygon.contains(p) {
                consider(p, polygon.boundary_distance(p));
            }
        };
        let centroid = self.vertices.iter().fold(Point::ZERO, |s, &v| s + v)
            / self.vertices.len().max(1) as f64;
        own(centroid); // The shapes may coincide.
        self.vertices.iter().for_each(|&v| own(v));
        self.edges()
            .for_each(|e| piece_middles(&e, polygon.edges()).for_each(&mut own));
        let mut theirs = |p: Point| {
            if self.contains_strictly(p) {
                consider(p, self.boundary_gap(p).distance);
            }
        };
        polygon.vertices().iter().for_each(|&v| theirs(v));
        polygon
            .edges()
            .for_each(|f| piece_middles(&f, self.edges()).for_each(&mut theirs));
        (deepest.distance < 0.0).then_some(deepest)
    }
}

impl Segment {
    /// Signed distance to a polygon; see [`Hull::gap_to_polygon`].
    pub fn gap_to_polygon(&self, polygon: &Polygon) -> Gap {
        Hull::of(&[self.a, self.b]).gap_to_polygon(polygon)
    }
}

/// The lower chain of points sorted by x, without collinear ones.
fn chain(points: impl Iterator<Item = Point>) -> Vec<Point> {
    let mut out: Vec<Point> = Vec::with_capacity(4);
    for p in points {
        while let [.., a, b] = out[..] {
            if orient2d(a, b, p) > 0.0 {
                break;
            }
            out.pop();
        }
        out.push(p);
    }
    out
}

/// The middles of the pieces into which `others` cut the segment.
fn piece_middles(
    segment: &Segment,
    others: impl Iterator<Item = Segment>,
) -> impl Iterator<Item = Point> {
    let mut cuts = vec![0.0, 1.0];
    let r = segment.b - segment.a;
    for other in others.filter(|o| segment.intersects(o)) {
        let s = other.b - other.a;
        let n = r.cross(s);
        if n != 0.0 {
            cuts.push(((other.a - segment.a).cross(s) / n).clamp(0.0, 1.0));
        } else {
            cuts.push(segment.nearest_parameter(other.a));
            cuts.push(segment.nearest_parameter(other.b));
        }
    }
    cuts.sort_by(f64::total_cmp);
    let segment = *segment;
    let middles: Vec<Point> = cuts
        .windows(2)
        .filter(|w| w[0] < w[1])
        .map(|w| segment.at(0.5 * (w[0] + w[1])))
        .collect();
    middles.into_iter()
}
