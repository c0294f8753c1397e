//! Where things touch in a step, and which unknowns that ties together.

use crate::contact::{ContactTerm, Other};
use crate::manifold;
use crate::near::Mover;
use crate::outline::MovingShape;
use crate::row::{Row, Tie};
use crate::work::Stage;
use crate::world::World;
use pairtrawl_geometry::Point;

/// What is nearer than this takes part in a step, in units of the machine's length.
const NARROW: f64 = 2e-4;
/// What would close in so many steps takes part.
const FORESIGHT: f64 = 3.0;

impl World {
    /// Shapes and support points at the beginning of a step.
    pub(crate) fn place_shapes(&mut self) {
        let radius = 0.5 * self.chain.parameters.thickness;
        let mut shapes = self.shapes.iter_mut();
        for (part, body) in self.bodies.iter().enumerate() {
            let axis = body.axis();
            for (own, shape) in body.shapes.iter().zip(shapes.by_ref()) {
                if body.awake {
                    *shape = own.placed(body.place, axis);
                }
            }
            if body.awake && part >= 2 {
                self.supports[part - 2].begin(axis);
            }
        }
        for (shape, ends) in shapes.zip(self.chain.places.windows(2)) {
            *shape = MovingShape::segment(ends[0], ends[1], radius);
        }
    }

    /// Looks anew for pairs that can touch soon.
    pub(crate) fn find_neighbors(&mut self) {
        let (bodies, movers) = (&self.bodies, &self.movers);
        let (within, links) = (self.links_within_robot, self.chain.links());
        let shapes = self.shapes.iter().zip(movers).enumerate();
        let moving = shapes
            .filter(|(_, (_, mover))| match mover {
                Mover::Body(i) => bodies[*i].awake,
                Mover::Link(_) => true,
            })
            .map(|(i, (shape, _))| (i, shape.outline()));
        let apart = |a: usize, b: usize| match (movers[a], movers[b]) {
            (Mover::Body(a), Mover::Body(b)) => a == b,
            (Mover::Body(0), Mover::Link(link)) => link < within,
            (Mover::Body(1), Mover::Link(link)) => link + within >= links,
            (Mover::Link(a), Mover::Link(b)) => a.abs_diff(b) < 2,
            _ => false,
        };
        self.neighbors.update(moving, &self.grid, apart);
        self.drift = 0.0;
    }

    /// Finds the contacts within `reach` (m), and the order of the unknowns that they tie together. What does not seem to close in this
    /// step is only watched, unless `all` shall take part.
    pub(crate) fn find_contacts(&mut self, dt: f64, reach: f64, all: bool) {
        std::mem::swap(&mut self.contacts, &mut self.before);
        self.contacts.clear();
        let mut pairs = std::mem::take(&mut self.near);
        let mut watched = std::mem::take(&mut self.watched);
        pairs.clear();
        watched.clear();
        let moving = self.neighbors.moving.iter();
        let moving = moving.map(|&(a, b)| (a, Other::Moving(b), self.shapes[b].outline()));
        let fixed = self.neighbors.fixed.iter();
        let fixed = fixed.map(|&(a, b)| (a, Other::Fixed(b), self.fixed[b].outline()));
        for (a, b, outline) in moving.chain(fixed) {
            let found = manifold::between(self.shapes[a].outline(), outline, reach);
            let points = &found.points[..found.count];
            let closes = |&(place, gap): &(Point, f64)| {
                let opening = self.opening(Velocities::Before, a, b, found.normal, place);
                gap < NARROW || gap + FORESIGHT * dt * opening < 0.0
            };
            let takes_part = all || points.iter().any(closes);
            let list = if takes_part { &mut pairs } else { &mut watched };
            list.extend(points.iter().map(|&point| (a, b, found.normal, point)));
        }
        self.watched = watched;
        self.watch.ends(Stage::Contacts, &mut self.work);
        // Which unknowns depend on each other, before the rows can be written.
        let links = self.chain.links();
        let count = self.bodies.len();
        let bodies = &self.bodies;
        self.pattern
            .begin((0..count + links - 1).map(|part| part >= count || bodies[part].awake));
        for node in 0..=links {
            for other in [node + 1, node + 2] {
                if other <= links {
                    self.pattern.tie(self.part(node), self.part(other));
                }
            }
        }
        let mut last = None;
        for (a, b, ..) in &pairs {
            // The two ends of a link are tied already.
            if let Other::Moving(b) = b
                && last.replace((a, b)) != Some((a, b))
            {
                for first in self.parts_of(*a) {
                    for second in self.parts_of(*b) {
                        self.pattern.tie(first, second);
                    }
                }
            }
        }
        let reordered = self.pattern.finish();
        self.reordered = self.reordered || reordered;
        self.work.orders += u64::from(reordered);
        self.watch.ends(Stage::Order, &mut self.work);
        self.lay_out_ties(dt);
        // Both lists are in the order of their pairs.
        let mut known = 0;
        for (a, b, normal, (place, gap)) in pairs.drain(..) {
            let mut row = Row::default();
            let face = normal.perp();
            self.push_place(&mut row, a, place, -normal, -face);
            if let Other::Moving(b) = b {
                self.push_place(&mut row, b, place, normal, face);
            }
            row.locate(&self.pattern);
            let mut contact = ContactTerm::new((a, b), place, row, gap, self.contact_friction);
            while self
                .before
                .get(known)
                .is_some_and(|old| rank(old.pair) < rank(contact.pair))
            {
                known += 1;
            }
            if let Some(old) = self
                .before
                .get(known)
                .filter(|old| old.pair == contact.pair)
            {
                contact.stand_as(old);
                known += 1;
            }
            self.contacts.push(contact);
        }
        self.near = pairs;
    }

    /// True when something that was only watched would close in the step that was solved last.
    pub(crate) fn something_closed(&self, dt: f64) -> bool {
        self.watched.iter().any(|&(a, b, normal, (place, gap))| {
            gap + dt * self.opening(Velocities::Found, a, b, normal, place) < 0.0
        })
    }

    /// How fast two things move apart at a place, m/s. What slides along a face is pushed off it by its cone: its gap closes
    /// as if it came nearer by mu times its sliding speed.
    fn opening(&self, when: Velocities, a: usize, b: Other, normal: Point, place: Point) -> f64 {
        let own = self.velocity_at(when, a, place);
        let other = match b {
            Other::Moving(b) => self.velocity_at(when, b, place),
            Other::Fixed(_) => Point::ZERO,
        };
        let relative = other - own;
        normal.dot(relative) - self.contact_friction * normal.cross(relative).abs()
    }

    /// The velocity of a place on something that moves.
    fn velocity_at(&self, when: Velocities, moving: usize, place: Point) -> Point {
        match self.movers[moving] {
            Mover::Body(part) => {
                let body = &self.bodies[part];
                let (velocity, spin) = match when {
                    Velocities::Before => (body.velocity, body.spin),
                    Velocities::Found => {
                        let [x, y, spin] = self.solution(part);
                        (Point::new(x, y), spin)
                    }
                };
                velocity + (place - body.place).perp() * spin
            }
            Mover::Link(link) => {
                let velocities = match when {
                    Velocities::Before => &self.chain.velocities[..],
                    Velocities::Found => self.chain.found(),
                };
                let (a, b) = (self.chain.places[link], self.chain.places[link + 1]);
                let (line, from) = (b - a, place - a);
                let squared = line.norm_squared();
                let (s, lever) = (from.dot(line) / squared, line.cross(from) / squared);
                let relative = velocities[link + 1] - velocities[link];
                let turn = line.perp().dot(relative) / squared;
                velocities[link] + relative * s - line * (lever * turn)
            }
        }
    }

    /// The part of the system that a node of the net belongs to.
    pub(crate) fn part(&self, node: usize) -> usize {
        if node == 0 {
            0
        } else if node == self.chain.links() {
            1
        } else {
            self.bodies.len() + node - 1
        }
    }

    /// The parts that the motion of a moving thing depends on: twice the same for a body.
    fn parts_of(&self, moving: usize) -> [usize; 2] {
        match self.movers[moving] {
            Mover::Body(body) => [body, body],
            Mover::Link(link) => [self.part(link), self.part(link + 1)],
        }
    }

    /// Sets how nodes depend on the unknowns, at the beginning of the step.
    fn lay_out_ties(&mut self, dt: f64) {
        let links = self.chain.links();
        for node in 0..=links {
            let part = self.part(node);
            let slot = self.pattern.slot(part);
            self.chain.ties[node] = if part < 2 {
                Tie::Held {
                    slot,
                    arm: self.bodies[part].hitch_arm(dt),
                }
            } else {
                Tie::Free { slot }
            };
        }
    }

    /// Adds the velocity of a point of a moving thing along two directions to a row.
    fn push_place(&self, row: &mut Row, moving: usize, place: Point, along: Point, across: Point) {
        let link = match self.movers[moving] {
            Mover::Body(body) => {
                let arm = place - self.bodies[body].place;
                let slot = self.pattern.slot(body);
                row.push(Tie::Held { slot, arm }, along, across);
                return;
            }
            Mover::Link(link) => link,
        };
        let (a, b) = (self.chain.places[link], self.chain.places[link + 1]);
        let line = b - a;
        let squared = line.norm_squared();
        let from = place - a;
        let s = from.dot(line) / squared;
        // A point beside the middle line moves along it when the link turns.
        let lever = line.cross(from) / squared;
        let split = |d: Point| {
            let turn = line.perp() * (lever * d.dot(line) / squared);
            (d * (1.0 - s) + turn, d * s - turn)
        };
        let ((a0, b0), (a1, b1)) = (split(along), split(across));
        row.push(self.chain.ties[link], a0, a1);
        row.push(self.chain.ties[link + 1], b0, b1);
    }
}

/// Which velocities: those before a step, or those at its end as they were found.
#[derive(Clone, Copy)]
enum Velocities {
    Before,
    Found,
}

/// Pairs in the order in which contacts are found: first those of moving things, then those with fixed shapes.
fn rank((a, b): (usize, Other)) -> (bool, usize, usize) {
    match b {
        Other::Moving(b) => (false, a, b),
        Other::Fixed(b) => (true, a, b),
    }
}
