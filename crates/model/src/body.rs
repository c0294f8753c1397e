use pairtrawl_geometry::{Point, Pose};
use std::fmt;

/// A circle of a robot's body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyCircle {
    /// Its center in the robot's frame, m: x forward, y to the left of the reference point (axle center).
    pub center: Point,
    /// Its radius, m.
    pub radius: f64,
}

impl BodyCircle {
    /// A circle around the reference point.
    pub const fn around_reference(radius: f64) -> Self {
        Self {
            center: Point::ZERO,
            radius,
        }
    }

    /// True when its center is the reference point: it does not move when the robot turns on the spot.
    pub fn is_centered(&self) -> bool {
        self.center == Point::ZERO
    }

    /// Distance of its center from the reference point, m.
    pub fn offset(&self) -> f64 {
        self.center.norm()
    }

    /// Its center in the map frame when the robot is at a pose, m.
    pub fn center_at(&self, pose: Pose) -> Point {
        if self.is_centered() {
            return pose.position();
        }
        let forward = pose.forward();
        pose.position() + forward * self.center.x + forward.perp() * self.center.y
    }
}

/// Circles that together contain a machine, at least one and at most [`Body::MOST`].
#[derive(Clone, Copy)]
pub struct Body {
    circles: [BodyCircle; Body::MOST],
    count: usize,
}

impl Body {
    /// Most circles of a body.
    pub const MOST: usize = 16;

    /// One circle.
    pub const fn circle(circle: BodyCircle) -> Self {
        Self {
            circles: [circle; Self::MOST],
            count: 1,
        }
    }

    /// These circles; `None` when there is none, or more than [`Self::MOST`].
    pub fn of(circles: &[BodyCircle]) -> Option<Self> {
        let mut body = Self::circle(*circles.first()?);
        body.count = circles.len();
        body.circles.get_mut(..body.count)?.copy_from_slice(circles);
        Some(body)
    }

    /// Its circles.
    pub fn circles(&self) -> &[BodyCircle] {
        &self.circles[..self.count]
    }

    /// Every circle changed alike, such as by a unit of length.
    #[must_use]
    pub fn map(mut self, change: impl Fn(BodyCircle) -> BodyCircle) -> Self {
        for circle in &mut self.circles {
            *circle = change(*circle);
        }
        self
    }

    /// Radius of the smallest circle around the reference point that contains all circles, m.
    pub fn reach(&self) -> f64 {
        self.greatest(|c| c.offset() + c.radius)
    }

    /// Radius of the largest circle around the reference point that lies within one of the circles, m: wherever the
    /// reference point is, nothing else may be closer. Zero or less when the reference point is in no circle.
    pub fn inner_radius(&self) -> f64 {
        self.greatest(|c| c.radius - c.offset())
    }

    /// Radius of the largest circle, m.
    pub fn largest_radius(&self) -> f64 {
        self.greatest(|c| c.radius)
    }

    /// How far the body extends to the side of the reference point, m: the room that it takes while it drives straight.
    pub fn half_width(&self) -> f64 {
        self.greatest(|c| c.center.y.abs() + c.radius)
    }

    /// How far the body extends straight ahead of the reference point, m.
    pub fn front(&self) -> f64 {
        self.greatest(|c| {
            let aside = c.center.y;
            let half_chord = if aside == 0.0 {
                c.radius
            } else {
                (c.radius * c.radius - aside * aside).max(0.0).sqrt()
            };
            c.center.x + half_chord
        })
    }

    /// The gap between two bodies at poses, m: less than zero when they overlap.
    pub fn gap(&self, pose: Pose, other: Pose) -> f64 {
        let gaps = self.circles().iter().flat_map(|a| {
            let center = a.center_at(pose);
            let others = self.circles().iter();
            others.map(move |b| center.distance(b.center_at(other)) - a.radius - b.radius)
        });
        gaps.fold(f64::INFINITY, f64::min)
    }

    fn greatest(&self, measure: impl Fn(&BodyCircle) -> f64) -> f64 {
        let measures = self.circles().iter().map(measure);
        measures.fold(f64::NEG_INFINITY, f64::max)
    }
}

impl PartialEq for Body {
    fn eq(&self, other: &Self) -> bool {
        self.circles() == other.circles()
    }
}

impl fmt::Debug for Body {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.circles()).finish()
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Body {
    /// As in scene files: a list of `[x, y, radius]`.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let triple = |c: &BodyCircle| [c.center.x, c.center.y, c.radius];
        serializer.collect_seq(self.circles().iter().map(triple))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    fn circle(x: f64, y: f64, radius: f64) -> BodyCircle {
        BodyCircle {
            center: Point::new(x, y),
            radius,
        }
    }

    #[test]
    fn measures_of_a_boat() {
        let boat = [
            circle(0.5, 0.0, 0.2),
            circle(0.0, 0.1, 0.3),
            circle(-0.5, 0.0, 0.25),
        ];
        let boat = Body::of(&boat).unwrap();
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-15, "{a} {b}");
        close(boat.reach(), 0.75);
        close(boat.inner_radius(), 0.2);
        close(boat.largest_radius(), 0.3);
        close(boat.half_width(), 0.4);
        close(boat.front(), 0.7);
    }

    #[test]
    fn circles_turn_with_the_robot() {
        let place = circle(0.2, 0.1, 0.3).center_at(Pose::new(1.0, 2.0, FRAC_PI_2));
        assert!(place.distance(Point::new(0.9, 2.2)) < 1e-15);
        let place = circle(0.0, 0.0, 0.3).center_at(Pose::new(1.0, 2.0, 0.7));
        assert_eq!(place, Point::new(1.0, 2.0));
    }

    #[test]
    fn a_body_has_one_circle_at_least_and_not_too_many() {
        assert!(Body::of(&[]).is_none());
        let circles = [circle(0.0, 0.0, 0.1); Body::MOST + 1];
        assert!(Body::of(&circles).is_none());
        assert_eq!(Body::of(&circles[1..]).unwrap().circles().len(), Body::MOST);
    }

    #[test]
    fn bodies_nose_to_tail_touch() {
        let robot = Body::of(&[circle(0.3, 0.0, 0.2), circle(-0.3, 0.0, 0.2)]).unwrap();
        let gap = robot.gap(Pose::new(0.0, 0.0, 0.0), Pose::new(1.1, 0.0, 0.0));
        assert!((gap - 0.1).abs() < 1e-15);
        let gap = robot.gap(Pose::new(0.0, 0.0, 0.0), Pose::new(0.0, 0.3, 0.0));
        assert!((gap + 0.1).abs() < 1e-15);
    }
}
