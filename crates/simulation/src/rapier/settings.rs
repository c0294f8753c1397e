//! The engine's settings, and small conversions between its types and ours.

use crate::{Parameters, RapierSolver};
use pairtrawl_geometry::{Point, Pose};
use rapier2d_f64::dynamics::SpringCoefficients;
use rapier2d_f64::prelude::{PhysicsWorld, RigidBody, Vector};

/// A planar world without gravity.
pub(crate) fn new_world(parameters: &Parameters, solver: RapierSolver) -> PhysicsWorld {
    let mut world = PhysicsWorld {
        gravity: Vector::ZERO,
        ..PhysicsWorld::new()
    };
    let settings = &mut world.integration_parameters;
    settings.dt = parameters.time_step;
    settings.num_solver_iterations = solver.iterations;
    settings.num_internal_pgs_iterations = solver.sweeps;
    settings.num_internal_stabilization_iterations = 1;
    settings.friction_in_bias_pass = true;
    settings.warmstart_joints = true;
    // Stale contact points let a sliding cube stick.
    settings.contact_recycling = false;
    // Links are a tenth of the unit of length long.
    settings.length_unit = 0.1;
    // The default softness scales with the 2 g link and lets a snagged net slide through a post.
    settings.contact_softness = SpringCoefficients {
        natural_frequency: 1e6,
        damping_ratio: 1.0,
    };
    settings.static_contact_softness = settings.contact_softness;
    // A step moves bodies by a fraction of the net's thickness.
    settings.max_ccd_substeps = 0;
    world
}

pub(crate) fn vector(p: Point) -> Vector {
    Vector::new(p.x, p.y)
}

pub(crate) fn point(v: Vector) -> Point {
    Point::new(v.x, v.y)
}

/// Origin and turn of a body.
pub(crate) fn pose_of(body: &RigidBody) -> Pose {
    let rotation = body.rotation();
    Pose::at(
        point(body.translation()),
        libm::atan2(rotation.sin(), rotation.cos()),
    )
}

/// A point of the body frame, in the map frame.
pub(crate) fn world_point(body: &RigidBody, local: Point) -> Point {
    let rotation = body.rotation();
    let (c, s) = (rotation.cos(), rotation.sin());
    point(body.translation()) + Point::new(c * local.x - s * local.y, s * local.x + c * local.y)
}

/// Velocity of a body's material point, m/s.
pub(crate) fn velocity_at(body: &RigidBody, place: Point) -> Point {
    let arm = place - point(body.center_of_mass());
    point(body.linvel()) + arm.perp() * body.angvel()
}
