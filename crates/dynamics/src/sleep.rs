//! Objects that lie at rest out of everything's reach take no part in the steps; their place cannot change meanwhile.
//!
//! How far an object is from everything that moves is only looked at again when something can have come near: a sum of the
//! greatest displacements of all steps says when.

use crate::world::World;
use pairtrawl_geometry::{Point, Segment};

/// An object wakes when something that moves comes this near to its footprint circle, in units of the machine.
const WAKE_DISTANCE: f64 = 0.03;
/// A resting object falls asleep when everything is farther away than this.
const SLEEP_DISTANCE: f64 = 0.04;
/// Below this speed it rests.
const REST_SPEED: f64 = 1e-5;

impl World {
    /// Wakes what something comes near to, and puts to sleep what rests far from all.
    pub(crate) fn update_sleep(&mut self) {
        let mut changed = false;
        for object in 0..self.supports.len() {
            let part = 2 + object;
            let body = &self.bodies[part];
            if body.awake {
                let moves =
                    body.velocity.norm() > REST_SPEED || body.spin.abs() * body.reach > REST_SPEED;
                if moves || self.distance_to_movers(part) < SLEEP_DISTANCE {
                    continue;
                }
                let body = &mut self.bodies[part];
                body.awake = false;
                body.velocity = Point::ZERO;
                body.spin = 0.0;
                self.look_again[object] = self.traveled;
                changed = true;
            }
        }
        loop {
            let mut woken = false;
            for object in 0..self.supports.len() {
                let part = 2 + object;
                if self.bodies[part].awake || (self.traveled < self.look_again[object]) {
                    continue;
                }
                let distance = self.distance_to_movers(part);
                if distance < WAKE_DISTANCE {
                    self.bodies[part].awake = true;
                    woken = true;
                } else {
                    self.look_again[object] = self.traveled + distance - WAKE_DISTANCE;
                }
            }
            if !woken {
                break;
            }
            changed = true;
            // What was far from all that moved may be near to what moves now.
            self.look_again.fill(self.traveled);
        }
        if changed {
            self.drift = f64::INFINITY;
        }
    }

    /// Distance of an object's footprint circle from the net, the robots and objects that are awake, m.
    fn distance_to_movers(&self, part: usize) -> f64 {
        let body = &self.bodies[part];
        let mut distance = distance_to_polyline(body.place, &self.chain.places);
        for (other, circle) in self.bodies.iter().enumerate() {
            if other != part && circle.awake {
                distance = distance.min(body.place.distance(circle.place) - circle.reach);
            }
        }
        distance - body.reach
    }
}

/// Distance of a point from a polyline, m.
fn distance_to_polyline(p: Point, polyline: &[Point]) -> f64 {
    polyline
        .windows(2)
        .map(|ends| {
            let t = Segment::new(ends[0], ends[1]).nearest_parameter(p);
            (p - ends[0].lerp(ends[1], t)).norm_squared()
        })
        .fold(f64::INFINITY, f64::min)
        .sqrt()
}
