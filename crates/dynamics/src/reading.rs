//! What can be read from a world between its steps.

use crate::body::Body;
use crate::contact::Other;
use crate::near::Mover;
use crate::touch::{Part, Touch};
use crate::work::Work;
use crate::world::World;
use pairtrawl_geometry::{Point, Pose};

impl World {
    /// Axle center and heading of a robot.
    pub fn robot_pose(&self, side: usize) -> Pose {
        let body = &self.bodies[side];
        let axle = body.place - body.axis() * self.wheels[side].parameters.center_of_mass;
        Pose::at(axle, body.heading)
    }

    /// Velocity of the axle along and across the heading (m/s) and turning rate (rad/s).
    pub fn robot_velocity(&self, side: usize) -> (f64, f64, f64) {
        let body = &self.bodies[side];
        let (forward, sideways) = self.wheels[side].axle_velocity(body);
        (forward, sideways, body.spin)
    }

    /// Force of net and contacts on a robot in the last step, by its momentum balance, N.
    pub fn load(&self, side: usize) -> Point {
        self.loads[side]
    }

    /// Mean force of a robot's (left, right) wheel along its heading in the last step, N.
    pub fn wheel_forces(&self, side: usize) -> [f64; 2] {
        self.pushes[side]
    }

    /// The net: left hitch, hinges, right hitch.
    pub fn net(&self) -> &[Point] {
        &self.chain.places
    }

    /// How many objects there are.
    pub fn objects(&self) -> usize {
        self.supports.len()
    }

    /// Center and turn of an object.
    pub fn object_pose(&self, object: usize) -> Pose {
        let body = &self.bodies[2 + object];
        Pose::at(body.place, body.heading)
    }

    /// How many objects take part at the moment.
    pub fn awake_objects(&self) -> usize {
        self.bodies[2..].iter().filter(|b| b.awake).count()
    }

    /// Greatest difference of a link's length from what it should be, m.
    pub fn greatest_stretch(&self) -> f64 {
        self.chain.greatest_stretch()
    }

    /// Kinetic and elastic energy, J.
    pub fn energy(&self) -> f64 {
        let bodies: f64 = self.bodies.iter().map(Body::energy).sum();
        bodies + self.chain.energy()
    }

    /// What pushed in the last step; links among themselves left out.
    pub fn touches(&self) -> impl Iterator<Item = Touch> + '_ {
        let part = |shape: usize| match self.movers[shape] {
            Mover::Body(body @ (0 | 1)) => Part::Robot(body),
            Mover::Body(body) => Part::Object(body - 2),
            Mover::Link(link) => Part::Link(link),
        };
        self.contacts
            .iter()
            .filter(|c| c.force > 0.0)
            .filter_map(move |c| {
                let second = match c.pair.1 {
                    Other::Moving(b) => part(b),
                    Other::Fixed(b) => Part::Obstacle(b),
                };
                let first = part(c.pair.0);
                let among = matches!((first, second), (Part::Link(_), Part::Link(_)));
                (!among).then_some(Touch {
                    first,
                    second,
                    place: c.place,
                    force: c.force,
                    depth: c.depth(),
                })
            })
    }

    /// How much work the steps so far were.
    pub fn work(&self) -> Work {
        self.work
    }
}
