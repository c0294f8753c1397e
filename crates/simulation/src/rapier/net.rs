//! The net: a chain of rigid links with vertical hinges, tied to both robots.

use super::ground_friction::Bristle;
use super::robots::ROBOTS;
use super::settings::{vector, velocity_at, world_point};
use super::tag;
use crate::Parameters;
use pairtrawl_geometry::{Point, Pose};
use rapier2d_f64::prelude::{
    ColliderBuilder, Group, InteractionGroups, InteractionTestMode, MassProperties, MotorModel,
    PhysicsWorld, RevoluteJointBuilder, RigidBodyBuilder, RigidBodyHandle,
};

pub(crate) struct Net {
    links: Vec<RigidBodyHandle>,
    half_length: f64,
    /// One at each hitch and hinge.
    bristles: Vec<Bristle>,
    deflections: Vec<Point>,
    /// Force of the floor on each hitch and hinge, N.
    forces: Vec<Point>,
}

impl Net {
    /// Lays the net along `nodes` (left hitch, hinges, right hitch) and ties its ends to the robots.
    pub(crate) fn insert(
        world: &mut PhysicsWorld,
        parameters: &Parameters,
        nodes: &[Point],
        robots: [RigidBodyHandle; 2],
    ) -> Self {
        let physics = &parameters.physics;
        let half_length = 0.5 * parameters.link_length;
        let half_thickness = 0.5 * physics.net_thickness;
        let mass = parameters.link_mass;
        let inertia = mass
            * vector(Point::new(parameters.link_length, physics.net_thickness)).length_squared()
            / 12.0;
        let is_within_body = parameters.is_within_body();
        let links: Vec<_> = nodes
            .windows(2)
            .enumerate()
            .map(|(i, ends)| {
                let along = ends[1] - ends[0];
                let body = RigidBodyBuilder::dynamic()
                    .translation(vector(ends[0].lerp(ends[1], 0.5)))
                    .rotation(libm::atan2(along.y, along.x))
                    .additional_mass_properties(MassProperties::new(
                        vector(Point::ZERO),
                        mass,
                        inertia,
                    ))
                    .can_sleep(false);
                let touches = if is_within_body(i) {
                    Group::ALL.difference(ROBOTS)
                } else {
                    Group::ALL
                };
                let groups = InteractionGroups::new(Group::ALL, touches, InteractionTestMode::And);
                let collider = ColliderBuilder::cuboid(half_length, half_thickness)
                    .density(0.0)
                    .collision_groups(groups)
                    .friction(physics.contact_friction)
                    .user_data(tag::link(i));
                world.insert(body, collider).0
            })
            .collect();
        let hitch = Point::new(-parameters.robot.hitch, 0.0);
        let (head, tail) = (Point::new(-half_length, 0.0), Point::new(half_length, 0.0));
        let mut tie = |a: RigidBodyHandle, at_a: Point, b: RigidBodyHandle, at_b: Point| {
            let hinge = RevoluteJointBuilder::new()
                .local_anchor1(vector(at_a))
                .local_anchor2(vector(at_b))
                .motor_model(MotorModel::ForceBased)
                .motor_velocity(0.0, physics.hinge_damping)
                .contacts_enabled(false);
            world.insert_impulse_joint(a, b, hinge);
        };
        tie(robots[0], hitch, links[0], head);
        for pair in links.windows(2) {
            tie(pair[0], tail, pair[1], head);
        }
        tie(robots[1], hitch, links[links.len() - 1], tail);
        // A rod's end feels a quarter of its mass; a hinge joins two rods.
        let weight = mass * physics.gravity;
        let bristle = |links: f64| {
            Bristle::new(
                physics.net_friction,
                0.5 * links * weight,
                0.25 * links * mass,
                parameters.time_step,
            )
        };
        let count = links.len() + 1;
        let bristles = (0..count)
            .map(|i| bristle(if i == 0 || i + 1 == count { 1.0 } else { 2.0 }))
            .collect();
        Self {
            links,
            half_length,
            bristles,
            deflections: vec![Point::ZERO; count],
            forces: vec![Point::ZERO; count],
        }
    }

    /// Puts the floor's friction of the coming step on the links.
    pub(crate) fn apply(&mut self, world: &mut PhysicsWorld) {
        let (head, tail) = (
            Point::new(-self.half_length, 0.0),
            Point::new(self.half_length, 0.0),
        );
        let last = self.links.len();
        for i in 0..=last {
            // Both links at a hinge move alike there.
            let velocity = if i < last {
                let link = &world.bodies[self.links[i]];
                velocity_at(link, world_point(link, head))
            } else {
                let link = &world.bodies[self.links[last - 1]];
                velocity_at(link, world_point(link, tail))
            };
            self.forces[i] = self.bristles[i].force(&mut self.deflections[i], velocity);
        }
        for (i, handle) in self.links.iter().enumerate() {
            let share = |node: usize| if node == 0 || node == last { 1.0 } else { 0.5 };
            let (at_head, at_tail) = (self.forces[i] * share(i), self.forces[i + 1] * share(i + 1));
            let link = &mut world.bodies[*handle];
            let arm = world_point(link, tail) - super::settings::point(link.translation());
            link.reset_forces(false);
            link.reset_torques(false);
            link.add_force(vector(at_head + at_tail), false);
            link.add_torque(arm.cross(at_tail - at_head), false);
        }
    }

    /// The left hitch, every hinge, the right hitch.
    pub(crate) fn polyline(&self, world: &PhysicsWorld) -> Vec<Point> {
        let (head, tail) = (
            Point::new(-self.half_length, 0.0),
            Point::new(self.half_length, 0.0),
        );
        let ends = |i: usize| {
            let link = &world.bodies[self.links[i]];
            (world_point(link, head), world_point(link, tail))
        };
        let last = self.links.len();
        (0..=last)
            .map(|i| match i {
                0 => ends(0).0,
                i if i == last => ends(last - 1).1,
                i => ends(i - 1).1.lerp(ends(i).0, 0.5),
            })
            .collect()
    }

    /// Greatest gap in a hinge between links, m.
    pub(crate) fn joint_gap(&self, world: &PhysicsWorld, hitches: [Point; 2]) -> f64 {
        let (head, tail) = (
            Point::new(-self.half_length, 0.0),
            Point::new(self.half_length, 0.0),
        );
        let mut before = hitches[0];
        let mut gap: f64 = 0.0;
        for handle in &self.links {
            let link = &world.bodies[*handle];
            gap = gap.max((world_point(link, head) - before).norm());
            before = world_point(link, tail);
        }
        gap.max((hitches[1] - before).norm())
    }

    /// Centers and turns of the links.
    pub(crate) fn link_poses(&self, world: &PhysicsWorld) -> Vec<Pose> {
        self.links
            .iter()
            .map(|&h| super::settings::pose_of(&world.bodies[h]))
            .collect()
    }

    /// Kinetic energy and energy of the floor's bristles, J.
    pub(crate) fn energy(&self, world: &PhysicsWorld) -> f64 {
        let kinetic: f64 = self
            .links
            .iter()
            .map(|&h| world.bodies[h].kinetic_energy())
            .sum();
        let elastic: f64 = self
            .bristles
            .iter()
            .zip(&self.deflections)
            .map(|(b, &z)| b.energy(z))
            .sum();
        kinetic + elastic
    }
}
