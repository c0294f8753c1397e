use crate::Point;

/// An axis-parallel bounding box; `min` above `max` when it is empty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lower left corner, m.
    pub min: Point,
    /// Upper right corner, m.
    pub max: Point,
}

impl Bounds {
    /// The smallest box around some points.
    pub fn of(points: &[Point]) -> Self {
        let inf = f64::INFINITY;
        let empty = Self {
            min: Point::new(inf, inf),
            max: Point::new(-inf, -inf),
        };
        points.iter().fold(empty, |b, p| Self {
            min: Point::new(b.min.x.min(p.x), b.min.y.min(p.y)),
            max: Point::new(b.max.x.max(p.x), b.max.y.max(p.y)),
        })
    }

    /// The box around a disc.
    pub fn of_disc(center: Point, radius: f64) -> Self {
        Self {
            min: center,
            max: center,
        }
        .grown(radius)
    }

    /// The box with every side moved out by `margin`, m.
    pub fn grown(self, margin: f64) -> Self {
        let m = Point::new(margin, margin);
        Self {
            min: self.min - m,
            max: self.max + m,
        }
    }

    /// True when the point lies in the closed box.
    pub fn contains(&self, p: Point) -> bool {
        self.min.x <= p.x && p.x <= self.max.x && self.min.y <= p.y && p.y <= self.max.y
    }

    /// True when the closed boxes have a point in common.
    pub fn meets(&self, other: &Self) -> bool {
        self.min.x <= other.max.x
            && other.min.x <= self.max.x
            && self.min.y <= other.max.y
            && other.min.y <= self.max.y
    }

    /// Distance between two boxes, 0 when they meet: a lower bound of the distance of what they contain.
    pub fn distance(&self, other: &Self) -> f64 {
        let dx = (other.min.x - self.max.x)
            .max(self.min.x - other.max.x)
            .max(0.0);
        let dy = (other.min.y - self.max.y)
            .max(self.min.y - other.max.y)
            .max(0.0);
        // Not hypot: this is the hot path of pruning, and lengths are far from overflow.
        (dx * dx + dy * dy).sqrt()
    }
}
