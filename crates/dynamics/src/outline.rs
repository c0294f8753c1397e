//! Shapes that can touch: convex polygons with rounded edges. A disc is a rounded point, a link of the net a rounded segment,
//! a box or an obstacle a polygon of radius zero.

use pairtrawl_geometry::{Bounds, Point};

/// A rounded convex polygon at its place in the map frame: all points within `radius` of the hull of `points`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outline<'a> {
    /// Vertices counter-clockwise; one for a disc, two for a segment.
    pub(crate) points: &'a [Point],
    /// Outward unit normal of the edge that begins at each vertex; unused for a disc.
    pub(crate) normals: &'a [Point],
    /// How far the shape reaches beyond the polygon, m.
    pub(crate) radius: f64,
}

impl Outline<'_> {
    /// The bounding box with `margin` (m) around.
    pub(crate) fn bounds(&self, margin: f64) -> Bounds {
        Bounds::of(self.points).grown(self.radius + margin)
    }
}

/// Outward unit normals of the edges of a counter-clockwise polygon.
pub(crate) fn edge_normals(points: &[Point]) -> Vec<Point> {
    (0..points.len())
        .map(|i| {
            let edge = points[(i + 1) % points.len()] - points[i];
            -edge.perp() / edge.norm().max(f64::MIN_POSITIVE)
        })
        .collect()
}

/// Greatest number of vertices of a shape that moves.
const MOVING_VERTICES: usize = 4;

/// A shape of something that moves, in its own frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MovingShape {
    points: [Point; MOVING_VERTICES],
    normals: [Point; MOVING_VERTICES],
    count: usize,
    radius: f64,
}

impl MovingShape {
    /// A box around `center` with half sides `half`.
    pub(crate) fn of_box(center: Point, half: Point) -> Self {
        Self {
            points: [
                center - half,
                center + Point::new(half.x, -half.y),
                center + half,
                center + Point::new(-half.x, half.y),
            ],
            normals: [
                Point::new(0.0, -1.0),
                Point::new(1.0, 0.0),
                Point::new(0.0, 1.0),
                Point::new(-1.0, 0.0),
            ],
            count: 4,
            radius: 0.0,
        }
    }

    /// A disc around `center`.
    pub(crate) fn disc(center: Point, radius: f64) -> Self {
        Self {
            points: [center; MOVING_VERTICES],
            normals: [Point::ZERO; MOVING_VERTICES],
            count: 1,
            radius,
        }
    }

    /// The points within `radius` of the segment from `a` to `b`.
    pub(crate) fn segment(a: Point, b: Point, radius: f64) -> Self {
        let along = b - a;
        let normal = -along.perp() / along.norm().max(f64::MIN_POSITIVE);
        let mut shape = Self::disc(a, radius);
        shape.points[0] = a;
        shape.points[1] = b;
        shape.normals[0] = normal;
        shape.normals[1] = -normal;
        shape.count = 2;
        shape
    }

    /// The shape of a body with its origin at `place`, turned so that its x axis points along `axis`.
    pub(crate) fn placed(&self, place: Point, axis: Point) -> Self {
        let turn = |p: Point| Point::new(axis.x * p.x - axis.y * p.y, axis.y * p.x + axis.x * p.y);
        Self {
            points: self.points.map(|p| place + turn(p)),
            normals: self.normals.map(turn),
            ..*self
        }
    }

    pub(crate) fn outline(&self) -> Outline<'_> {
        Outline {
            points: &self.points[..self.count],
            normals: &self.normals[..self.count],
            radius: self.radius,
        }
    }

    /// How far its farthest point lies from the origin of its frame, m.
    pub(crate) fn reach(&self) -> f64 {
        let farthest = self.points[..self.count]
            .iter()
            .map(|p| p.norm())
            .fold(0.0, f64::max);
        farthest + self.radius
    }
}
