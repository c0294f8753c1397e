//! Objects: rigid bodies on the floor. One that lies at rest out of everything's reach is taken out of the engine until
//! something comes near; its place cannot change meanwhile.

use super::ground_friction::Bristle;
use super::settings::{pose_of, vector, velocity_at, world_point};
use super::tag;
use crate::Parameters;
use pairtrawl_geometry::{Point, Pose, Segment};
use pairtrawl_model::{Footprint, Object};
use rapier2d_f64::prelude::{
    ColliderBuilder, MassProperties, PhysicsWorld, RigidBodyBuilder, RigidBodyHandle,
};

/// An object wakes when something that moves comes this near to its footprint circle, in units of the machine.
const WAKE_DISTANCE: f64 = 0.03;
/// A resting object falls asleep when everything is farther away than this.
const SLEEP_DISTANCE: f64 = 0.04;
/// Below this speed it rests (a speed, or a turning rate).
const REST_SPEED: f64 = 1e-5;

pub(crate) struct Objects {
    items: Vec<Item>,
}

struct Item {
    handle: RigidBodyHandle,
    radius: f64,
    /// Support points in the body frame.
    supports: [Point; 4],
    bristle: Bristle,
    deflections: [Point; 4],
    awake: bool,
    pose: Pose,
}

impl Objects {
    pub(crate) fn insert(
        world: &mut PhysicsWorld,
        parameters: &Parameters,
        objects: &[Object],
    ) -> Self {
        let items = objects
            .iter()
            .enumerate()
            .map(|(i, object)| Item::insert(world, parameters, i, object))
            .collect();
        Self { items }
    }

    pub(crate) fn poses(&self) -> Vec<Pose> {
        self.items.iter().map(|item| item.pose).collect()
    }

    pub(crate) fn awake_count(&self) -> usize {
        self.items.iter().filter(|item| item.awake).count()
    }

    /// Wakes objects that are near one of the segments (the net), of the discs (the robots) or of an object that is awake,
    /// and puts those to sleep that rest far from all.
    pub(crate) fn update_sleep(
        &mut self,
        world: &mut PhysicsWorld,
        segments: &[Point],
        discs: &[(Point, f64)],
    ) {
        // A wave of wakings runs through objects that touch each other.
        let near = |a: Point, reach: f64| {
            segments
                .windows(2)
                .any(|s| Segment::new(s[0], s[1]).distance(a) < reach)
                || discs
                    .iter()
                    .any(|&(center, radius)| (a - center).norm() < reach + radius)
        };
        for i in 0..self.items.len() {
            let item = &self.items[i];
            let margin = if item.awake {
                SLEEP_DISTANCE
            } else {
                WAKE_DISTANCE
            };
            let (place, radius) = (item.pose.position(), item.radius);
            let wanted = near(place, radius + margin) || (item.awake && item.moves(world));
            self.items[i].set_awake(world, wanted);
        }
        loop {
            let mut changed = false;
            for i in 0..self.items.len() {
                if self.items[i].awake {
                    continue;
                }
                let (place, radius) = (self.items[i].pose.position(), self.items[i].radius);
                let touched = self.items.iter().any(|other| {
                    other.awake
                        && (other.pose.position() - place).norm()
                            < radius + other.radius + WAKE_DISTANCE
                });
                if touched {
                    self.items[i].set_awake(world, true);
                    changed = true;
                }
            }
            if !changed {
                break;
            }
        }
    }

    /// Puts the floor's friction of the coming step on the objects.
    pub(crate) fn apply(&mut self, world: &mut PhysicsWorld) {
        for item in self.items.iter_mut().filter(|item| item.awake) {
            let body = &world.bodies[item.handle];
            let center = super::settings::point(body.translation());
            let (mut force, mut torque) = (Point::ZERO, 0.0);
            for (support, deflection) in item.supports.iter().zip(&mut item.deflections) {
                let place = world_point(body, *support);
                let f = item.bristle.force(deflection, velocity_at(body, place));
                force += f;
                torque += (place - center).cross(f);
            }
            let body = &mut world.bodies[item.handle];
            body.reset_forces(false);
            body.reset_torques(false);
            body.add_force(vector(force), false);
            body.add_torque(torque, false);
        }
    }

    pub(crate) fn observe(&mut self, world: &PhysicsWorld) {
        for item in self.items.iter_mut().filter(|item| item.awake) {
            item.pose = pose_of(&world.bodies[item.handle]);
        }
    }

    /// Kinetic energy and energy of the floor's bristles, J.
    pub(crate) fn energy(&self, world: &PhysicsWorld) -> f64 {
        self.items
            .iter()
            .filter(|item| item.awake)
            .map(|item| {
                let elastic: f64 = item
                    .deflections
                    .iter()
                    .map(|&z| item.bristle.energy(z))
                    .sum();
                world.bodies[item.handle].kinetic_energy() + elastic
            })
            .sum()
    }
}

impl Item {
    fn insert(
        world: &mut PhysicsWorld,
        parameters: &Parameters,
        index: usize,
        object: &Object,
    ) -> Self {
        let physics = &parameters.physics;
        // Inertia about the center over the mass, and support points at the distance that gives the moment of an evenly
        // pressed disc (2/3 of its radius), or the corners of a box.
        let (collider, gyration, support) = match object.footprint {
            Footprint::Box(w, d) => (
                ColliderBuilder::cuboid(0.5 * w, 0.5 * d),
                (w * w + d * d) / 12.0,
                Point::new(0.5 * w, 0.5 * d),
            ),
            Footprint::Disc(r) => {
                let s = r * 2.0 / 3.0 * std::f64::consts::FRAC_1_SQRT_2;
                (ColliderBuilder::ball(r), 0.5 * r * r, Point::new(s, s))
            }
        };
        let body = RigidBodyBuilder::dynamic()
            .translation(vector(object.position))
            .additional_mass_properties(MassProperties::new(
                vector(Point::ZERO),
                object.mass,
                object.mass * gyration,
            ))
            .can_sleep(false);
        let collider = collider
            .density(0.0)
            .friction(physics.contact_friction)
            .user_data(tag::object(index));
        let (handle, _) = world.insert(body, collider);
        world.bodies[handle].set_enabled(false);
        let inertia = 0.25 * object.mass * (gyration / support.norm_squared()).min(1.0);
        Self {
            handle,
            radius: object.footprint_radius(),
            supports: [
                support,
                Point::new(-support.x, support.y),
                Point::new(-support.x, -support.y),
                Point::new(support.x, -support.y),
            ],
            bristle: Bristle::new(
                physics.object_friction,
                0.25 * object.mass * physics.gravity,
                inertia,
                parameters.time_step,
            ),
            deflections: [Point::ZERO; 4],
            awake: false,
            pose: Pose::at(object.position, 0.0),
        }
    }

    fn moves(&self, world: &PhysicsWorld) -> bool {
        let body = &world.bodies[self.handle];
        super::settings::point(body.linvel()).norm() > REST_SPEED
            || body.angvel().abs() > REST_SPEED / self.radius
    }

    fn set_awake(&mut self, world: &mut PhysicsWorld, awake: bool) {
        if self.awake == awake {
            return;
        }
        self.awake = awake;
        let body = &mut world.bodies[self.handle];
        if !awake {
            body.set_linvel(vector(Point::ZERO), false);
            body.set_angvel(0.0, false);
            self.deflections = [Point::ZERO; 4];
        }
        body.set_enabled(awake);
    }
}
