//! The scene in the engine of this project (`pairtrawl-dynamics`).

use crate::physics::Physics;
use crate::{Contact, Parameters, Part, RobotDrive, RobotLoad, RobotState};
use pairtrawl_dynamics::{self as dynamics, Solid};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Footprint, Object, Side};

pub(crate) struct ImplicitWorld {
    world: dynamics::World,
    time_step: f64,
    wheel_radius: f64,
    /// Which obstacle of the scene each fixed shape is a piece of.
    obstacles: Vec<Option<usize>>,
}

impl ImplicitWorld {
    pub(crate) fn new(
        parameters: &Parameters,
        obstacles: Vec<Option<usize>>,
        solids: Vec<Solid>,
        objects: &[Object],
        poses: [Pose; 2],
        nodes: Vec<Point>,
    ) -> Self {
        let physics = &parameters.physics;
        let squared = parameters.link_length * parameters.link_length
            + physics.net_thickness * physics.net_thickness;
        let weight = |mass: f64| mass * physics.gravity;
        let setup = dynamics::Setup {
            robot: dynamics::RobotParameters {
                mass: physics.robot_mass,
                inertia: physics.robot_inertia,
                wheels: dynamics::WheelParameters {
                    half_track: parameters.robot.half_track,
                    radius: physics.wheel_radius,
                    max_torque: physics.max_torque,
                    traction: parameters.traction(),
                    center_of_mass: physics.center_of_mass,
                },
                hitch: parameters.robot.hitch,
            },
            robot_outline: (parameters.outline().into_iter())
                .map(|(center, part)| (center, footprint(part)))
                .collect(),
            links_within_robot: parameters.links_within_body(),
            poses,
            net: dynamics::NetParameters {
                link_length: parameters.link_length,
                link_mass: parameters.link_mass,
                link_inertia: parameters.link_mass * squared / 12.0,
                thickness: physics.net_thickness,
                hinge_damping: physics.hinge_damping,
                floor_limit: physics.net_friction * weight(parameters.link_mass),
            },
            nodes,
            objects: objects
                .iter()
                .map(|object| dynamics::ObjectParameters {
                    place: object.position,
                    footprint: footprint(object.footprint),
                    mass: object.mass,
                    floor_limit: physics.object_friction * weight(object.mass),
                })
                .collect(),
            obstacles: solids,
            contact_friction: physics.contact_friction,
        };
        Self {
            world: dynamics::World::new(setup),
            time_step: parameters.time_step,
            wheel_radius: physics.wheel_radius,
            obstacles,
        }
    }

    fn part(&self, part: dynamics::Part) -> Part {
        match part {
            dynamics::Part::Robot(side) => Part::Robot(Side::BOTH[side]),
            dynamics::Part::Link(link) => Part::Link(link),
            dynamics::Part::Object(object) => Part::Object(object),
            dynamics::Part::Obstacle(piece) => Part::Obstacle(self.obstacles[piece]),
        }
    }
}

/// The same for the engine.
fn footprint(footprint: Footprint) -> dynamics::Footprint {
    match footprint {
        Footprint::Box(w, d) => dynamics::Footprint::Box(Point::new(0.5 * w, 0.5 * d)),
        Footprint::Disc(r) => dynamics::Footprint::Disc(r),
    }
}

impl Physics for ImplicitWorld {
    fn step(&mut self, drives: &[RobotDrive; 2]) {
        let drives = drives.map(|drive| match drive {
            RobotDrive::Torques { left, right } => dynamics::Drive::Torques([left, right]),
            RobotDrive::Velocity { forward, turn_rate } => {
                dynamics::Drive::Velocity { forward, turn_rate }
            }
        });
        self.world.step(self.time_step, &drives);
    }

    fn robots(&self) -> [RobotState; 2] {
        [0, 1].map(|side| {
            let (forward, sideways, turn_rate) = self.world.robot_velocity(side);
            RobotState {
                pose: self.world.robot_pose(side),
                forward,
                sideways,
                turn_rate,
            }
        })
    }

    fn loads(&self) -> [RobotLoad; 2] {
        [0, 1].map(|side| {
            let forces = self.world.wheel_forces(side);
            RobotLoad {
                drive_force: forces[0] + forces[1],
                torques: forces.map(|force| force * self.wheel_radius),
                load: self.world.load(side),
            }
        })
    }

    fn net(&self) -> Vec<Point> {
        self.world.net().to_vec()
    }

    fn links(&self) -> Vec<Pose> {
        let pose =
            |ends: &[Point]| Pose::at(ends[0].lerp(ends[1], 0.5), (ends[1] - ends[0]).angle());
        self.world.net().windows(2).map(pose).collect()
    }

    fn objects(&self) -> Vec<Pose> {
        (0..self.world.objects())
            .map(|i| self.world.object_pose(i))
            .collect()
    }

    fn awake_objects(&self) -> usize {
        self.world.awake_objects()
    }

    fn contacts(&self) -> Vec<Contact> {
        let contact = |touch: dynamics::Touch| {
            let (a, b) = (self.part(touch.first), self.part(touch.second));
            Contact {
                first: a.min(b),
                second: a.max(b),
                place: touch.place,
                depth: touch.depth,
                impulse: touch.force * self.time_step,
            }
        };
        self.world.touches().map(contact).collect()
    }

    fn joint_gap(&self) -> f64 {
        self.world.greatest_stretch()
    }

    fn energy(&self) -> f64 {
        self.world.energy()
    }

    fn measure(&mut self, clock: fn() -> u64) {
        self.world.measure(clock);
    }

    fn work(&self) -> Option<dynamics::Work> {
        Some(self.world.work())
    }
}
