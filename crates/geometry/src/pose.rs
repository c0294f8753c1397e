use crate::Point;
use std::f64::consts::PI;

/// Position of a robot's reference point (axle center) and its heading.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// Map frame x, m.
    pub x: f64,
    /// Map frame y, m.
    pub y: f64,
    /// Counter-clockwise from +x, rad; continuous along a trajectory, so it may leave (-pi, pi].
    pub heading: f64,
}

impl Pose {
    /// The pose (x, y, heading).
    pub const fn new(x: f64, y: f64, heading: f64) -> Self {
        Self { x, y, heading }
    }

    /// A pose at a point.
    pub const fn at(p: Point, heading: f64) -> Self {
        Self::new(p.x, p.y, heading)
    }

    /// The position.
    pub const fn position(self) -> Point {
        Point::new(self.x, self.y)
    }

    /// The unit vector along the heading.
    pub fn forward(self) -> Point {
        Point::unit(self.heading)
    }

    /// The point where the net is tied: `hitch` meters behind the axle center.
    pub fn hitch_point(self, hitch: f64) -> Point {
        self.position() - self.forward() * hitch
    }

    /// Linear interpolation of position and (continuous) heading, as plans are read between waypoints.
    pub fn lerp(self, other: Self, t: f64) -> Self {
        Self::at(
            self.position().lerp(other.position(), t),
            self.heading + (other.heading - self.heading) * t,
        )
    }

    /// True when all three numbers are finite.
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.heading.is_finite()
    }
}

impl From<[f64; 3]> for Pose {
    fn from([x, y, heading]: [f64; 3]) -> Self {
        Self { x, y, heading }
    }
}

impl From<Pose> for [f64; 3] {
    fn from(p: Pose) -> Self {
        [p.x, p.y, p.heading]
    }
}

/// The equivalent angle in (-pi, pi].
pub fn wrap_angle(angle: f64) -> f64 {
    let a = angle.rem_euclid(2.0 * PI);
    if a > PI { a - 2.0 * PI } else { a }
}
