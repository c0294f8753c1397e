//! One robot: a planar body on two driven wheels.
//!
//! Reference point on the axle, center of mass d ahead of it, inertia I about the center of mass (row 16 of `docs/paper.md`, the paper's
//! reading): M = diag(m, I + m d^2), C = [[0, -m d w], [m d w, 0]]. The body is simulated in its three planar freedoms; the
//! wheels push with torque / r along the heading at +-half_track, and a lateral bristle at the axle holds the no-slip
//! condition as long as the tires can: longitudinal and lateral force together stay within mu m g.

use super::ground_friction::Bristle;
use super::servo;
use super::settings::{pose_of, vector, velocity_at, world_point};
use crate::{Parameters, RobotDrive, RobotLoad, RobotState};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::Footprint;
use rapier2d_f64::prelude::{
    ColliderBuilder, Group, InteractionGroups, InteractionTestMode, MassProperties, PhysicsWorld,
    RigidBodyBuilder, RigidBodyHandle,
};

pub(crate) struct RobotBody {
    pub(crate) handle: RigidBodyHandle,
    lateral: Bristle,
    deflection: f64,
    heading: f64,
    momentum: Point,
    applied: Point,
    pub(crate) state: RobotState,
    pub(crate) last: RobotLoad,
}

/// The group of the robots, which links of the net within their bodies do not touch.
pub(crate) const ROBOTS: Group = Group::GROUP_1;

impl RobotBody {
    pub(crate) fn insert(
        world: &mut PhysicsWorld,
        parameters: &Parameters,
        pose: Pose,
        tag: u128,
    ) -> Self {
        let physics = &parameters.physics;
        let center = Point::new(physics.center_of_mass, 0.0);
        let body = RigidBodyBuilder::dynamic()
            .translation(vector(pose.position()))
            .rotation(pose.heading)
            .additional_mass_properties(MassProperties::new(
                vector(center),
                physics.robot_mass,
                physics.robot_inertia,
            ))
            .can_sleep(false);
        let handle = world.insert_body(body);
        let groups = InteractionGroups::new(ROBOTS, Group::ALL, InteractionTestMode::And);
        for (center, footprint) in parameters.outline() {
            let collider = match footprint {
                Footprint::Box(w, d) => ColliderBuilder::cuboid(0.5 * w, 0.5 * d),
                Footprint::Disc(radius) => ColliderBuilder::ball(radius),
            };
            let collider = collider
                .translation(vector(center))
                .collision_groups(groups)
                .density(0.0)
                .friction(physics.contact_friction)
                .user_data(tag);
            world.insert_collider(collider, Some(handle));
        }
        let axle_inertia = 1.0
            / (1.0 / physics.robot_mass
                + physics.center_of_mass * physics.center_of_mass / physics.robot_inertia);
        let lateral = Bristle::new(
            physics.wheel_friction,
            physics.robot_mass * physics.gravity,
            axle_inertia,
            parameters.time_step,
        );
        Self {
            handle,
            lateral,
            deflection: 0.0,
            heading: pose.heading,
            momentum: Point::ZERO,
            applied: Point::ZERO,
            state: RobotState {
                pose,
                ..RobotState::default()
            },
            last: RobotLoad::default(),
        }
    }

    /// Puts the forces of the coming step on the body.
    pub(crate) fn apply(
        &mut self,
        world: &mut PhysicsWorld,
        parameters: &Parameters,
        drive: &RobotDrive,
    ) {
        let physics = &parameters.physics;
        let traction = parameters.traction();
        let forces = match *drive {
            RobotDrive::Torques { left, right } => [left, right].map(|torque| {
                torque.clamp(-physics.max_torque, physics.max_torque) / physics.wheel_radius
            }),
            RobotDrive::Velocity { forward, turn_rate } => {
                servo::wheel_forces(parameters, &self.state, forward, turn_rate)
            }
        };
        let [left, right] = forces.map(|force| force.clamp(-0.5 * traction, 0.5 * traction));
        let along = left + right;
        let room = (traction * traction - along * along).max(0.0).sqrt();
        // The last displacement was along the mid-step heading: that is the direction that must not slip.
        let middle = self.heading - 0.5 * self.state.turn_rate * parameters.time_step;
        let body = &mut world.bodies[self.handle];
        let axle = world_point(body, Point::ZERO);
        let slip = velocity_at(body, axle).dot(Point::unit(middle).perp());
        let across = self.lateral.force_along(&mut self.deflection, slip, room);
        let forward = Point::unit(self.heading);
        self.applied = forward * along + forward.perp() * across;
        body.reset_forces(false);
        body.reset_torques(false);
        body.add_force_at_point(vector(self.applied), vector(axle), false);
        body.add_torque((right - left) * parameters.robot.half_track, false);
        self.last.drive_force = along;
        self.last.torques = [left * physics.wheel_radius, right * physics.wheel_radius];
    }

    /// Reads the state after a step.
    pub(crate) fn observe(&mut self, world: &PhysicsWorld, parameters: &Parameters) {
        let body = &world.bodies[self.handle];
        let pose = pose_of(body);
        self.heading += pairtrawl_geometry::wrap_angle(pose.heading - self.heading);
        let velocity = velocity_at(body, pose.position());
        let forward = Point::unit(self.heading);
        self.state = RobotState {
            pose: Pose::at(pose.position(), self.heading),
            forward: velocity.dot(forward),
            sideways: velocity.dot(forward.perp()),
            turn_rate: body.angvel(),
        };
        let momentum = super::settings::point(body.linvel()) * parameters.physics.robot_mass;
        self.last.load = (momentum - self.momentum) / parameters.time_step - self.applied;
        self.momentum = momentum;
    }

    /// Where the net is tied.
    pub(crate) fn hitch(&self, parameters: &Parameters) -> Point {
        self.state.pose.hitch_point(parameters.robot.hitch)
    }

    /// Kinetic energy and energy of the tires, J.
    pub(crate) fn energy(&self, world: &PhysicsWorld) -> f64 {
        world.bodies[self.handle].kinetic_energy()
            + self.lateral.energy(Point::new(self.deflection, 0.0))
    }
}
