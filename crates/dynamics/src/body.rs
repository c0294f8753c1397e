//! Rigid bodies: robots and objects, as seen from their center of mass.

use crate::outline::MovingShape;
use pairtrawl_geometry::Point;

/// State and constants of a body.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) mass: f64,
    /// About the center of mass, kg m^2.
    pub(crate) inertia: f64,
    /// Of the center of mass.
    pub(crate) place: Point,
    pub(crate) heading: f64,
    pub(crate) velocity: Point,
    /// Turning rate, rad/s.
    pub(crate) spin: f64,
    /// What it touches with, around the center of mass.
    pub(crate) shapes: Vec<MovingShape>,
    /// How far its farthest point lies from the center of mass, m.
    pub(crate) reach: f64,
    /// The net is tied this far behind the center of mass, m; robots only.
    pub(crate) hitch: f64,
    /// It takes part in the steps.
    pub(crate) awake: bool,
}

impl Body {
    /// At rest.
    pub(crate) fn new(
        mass: f64,
        inertia: f64,
        place: Point,
        heading: f64,
        shapes: Vec<MovingShape>,
    ) -> Self {
        Self {
            mass,
            inertia,
            place,
            heading,
            velocity: Point::ZERO,
            spin: 0.0,
            reach: shapes.iter().map(MovingShape::reach).fold(0.0, f64::max),
            shapes,
            hitch: 0.0,
            awake: true,
        }
    }

    /// The x axis of its frame.
    pub(crate) fn axis(&self) -> Point {
        Point::unit(self.heading)
    }

    /// From the center of mass to the hitch at the middle of a step, as the last step foresees it.
    pub(crate) fn hitch_arm(&self, dt: f64) -> Point {
        Point::unit(self.heading + 0.5 * dt * self.spin) * -self.hitch
    }

    /// Where the net is tied.
    pub(crate) fn hitch_place(&self) -> Point {
        self.place - self.axis() * self.hitch
    }

    pub(crate) fn energy(&self) -> f64 {
        0.5 * (self.mass * self.velocity.norm_squared() + self.inertia * self.spin * self.spin)
    }
}
