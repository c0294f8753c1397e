use super::super::{number, numbers};
use pairtrawl_geometry::Point;
use std::fmt::Write;

/// Radius of the feet, m.
pub(super) const FOOT: f64 = 0.003;
/// Share of a body's mass in all its feet; they press with the weight of all of it.
pub(super) const FOOT_SHARE: f64 = 1.0 / 6.0;

/// A foot: a point of a body where it stands.
pub(super) struct Foot {
    pub place: Point,
    /// Mass that stands on it, kg.
    pub mass: f64,
    /// m/s^2.
    pub gravity: f64,
    pub class: &'static str,
}

impl Foot {
    /// Writes the foot. It has but a part of the mass that stands on it; up and down it has all of the inertia (armature) and
    /// all of the weight (a long soft spring).
    pub fn write(&self, out: &mut String, name: &str) -> std::fmt::Result {
        let rest = self.mass * (1.0 - FOOT_SHARE);
        writeln!(
            out,
            "<body name=\"foot_{name}\" pos=\"{}\"><joint name=\"foot_{name}\" type=\"slide\" axis=\"0 0 1\" armature=\"{rest:e}\" stiffness=\"{:e}\" springref=\"-1\"/><inertial pos=\"0 0 0\" mass=\"{}\" diaginertia=\"1e-9 1e-9 1e-9\"/><geom class=\"{}\"/></body>",
            numbers([self.place.x, self.place.y, FOOT]),
            rest * self.gravity,
            number(self.mass * FOOT_SHARE),
            self.class
        )
    }
}
