use crate::{Gap, Point, segments_intersect};

/// A closed straight segment; its ends may coincide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// One end, m.
    pub a: Point,
    /// The other end, m.
    pub b: Point,
}

impl Segment {
    /// The segment from `a` to `b`.
    pub const fn new(a: Point, b: Point) -> Self {
        Self { a, b }
    }

    /// Length, m.
    pub fn length(&self) -> f64 {
        self.a.distance(self.b)
    }

    /// The point `a + t (b - a)`; exactly `b` at t = 1.
    pub fn at(&self, t: f64) -> Point {
        if t == 1.0 {
            self.b
        } else {
            self.a.lerp(self.b, t)
        }
    }

    /// Parameter in [0, 1] of the point nearest to `p`.
    pub fn nearest_parameter(&self, p: Point) -> f64 {
        let d = self.b - self.a;
        let n = d.norm_squared();
        if n > 0.0 {
            ((p - self.a).dot(d) / n).clamp(0.0, 1.0)
        } else {
            0.0
        }
    }

    /// The point of the segment nearest to `p`.
    pub fn nearest(&self, p: Point) -> Point {
        self.at(self.nearest_parameter(p))
    }

    /// Distance to a point, m.
    pub fn distance(&self, p: Point) -> f64 {
        self.nearest(p).distance(p)
    }

    /// True when the closed segments share a point; exact.
    pub fn intersects(&self, other: &Self) -> bool {
        segments_intersect(self.a, self.b, other.a, other.b)
    }

    /// Distance to another segment and the point of `self` nearest to it; 0 when they meet.
    pub fn gap_to_segment(&self, other: &Self) -> Gap {
        if self.intersects(other) {
            let (r, s) = (self.b - self.a, other.b - other.a);
            let n = r.cross(s);
            let t = if n != 0.0 {
                (other.a - self.a).cross(s) / n
            } else {
                self.nearest_parameter(other.a)
            };
            return Gap {
                distance: 0.0,
                place: self.at(t.clamp(0.0, 1.0)),
            };
        }
        let own = |p: Point| Gap {
            distance: other.distance(p),
            place: p,
        };
        let foot = |p: Point| {
            let place = self.nearest(p);
            Gap {
                distance: place.distance(p),
                place,
            }
        };
        own(self.a)
            .min(own(self.b))
            .min(foot(other.a))
            .min(foot(other.b))
    }

    /// Signed distance to a disc: negative when the segment enters it, down to minus the radius at the center.
    pub fn gap_to_disc(&self, center: Point, radius: f64) -> Gap {
        let place = self.nearest(center);
        Gap {
            distance: place.distance(center) - radius,
            place,
        }
    }
}
