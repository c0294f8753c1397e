//! Where things touch in a step, and which unknowns that ties together.

use crate::contact::{ContactTerm, Other};
use crate::manifold;
use crate::near::Mover;
use crate::outline::MovingShape;
use crate::row::{Row, Tie};
use crate::world::World;
use pairtrawl_geometry::Point;

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

    /// Finds the contacts within `reach` (m), and the order of the unknowns that they tie together.
    pub(crate) fn find_contacts(&mut self, dt: f64, reach: f64) {
        std::mem::swap(&mut self.contacts, &mut self.before);
        self.contacts.clear();
        let mut pairs = std::mem::take(&mut self.near);
        pairs.clear();
        for &(a, b) in &self.neighbors.moving {
            let found =
                manifold::between(self.shapes[a].outline(), self.shapes[b].outline(), reach);
            pairs.extend(
                (0..found.count).map(|k| (a, Other::Moving(b), found.normal, found.points[k])),
            );
        }
        for &(a, b) in &self.neighbors.fixed {
            let found = manifold::between(self.shapes[a].outline(), self.fixed[b].outline(), reach);
            pairs.extend(
                (0..found.count).map(|k| (a, Other::Fixed(b), found.normal, found.points[k])),
            );
        }
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

/// Pairs in the order in which contacts are found: first those of moving things, then those with fixed shapes.
fn rank((a, b): (usize, Other)) -> (bool, usize, usize) {
    match b {
        Other::Moving(b) => (false, a, b),
        Other::Fixed(b) => (true, a, b),
    }
}
