//! The scene in rapier, a general engine of rigid bodies: the second opinion beside the engine of this project.

mod contacts;
mod fixed;
mod ground_friction;
mod net;
mod objects;
mod robots;
mod servo;
mod settings;
mod tag;
#[cfg(test)]
mod theory_tests;

use crate::obstacles::FixedShape;
use crate::physics::Physics;
use crate::{
    Contact, Parameters, RapierSolver, RobotDrive, RobotLoad, RobotState, SimulationError,
};
use net::Net;
use objects::Objects;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Scene, Side};
use rapier2d_f64::prelude::PhysicsWorld;
use robots::RobotBody;

/// Objects are woken and put to sleep this often: at a speed of 0.5 things move a third of the wake distance meanwhile.
const SLEEP_INTERVAL: f64 = 0.02;

pub(crate) struct RapierWorld {
    parameters: Parameters,
    world: PhysicsWorld,
    robots: [RobotBody; 2],
    net: Net,
    objects: Objects,
    steps: u64,
}

impl RapierWorld {
    pub(crate) fn new(
        scene: &Scene,
        parameters: &Parameters,
        obstacles: Vec<(Option<usize>, FixedShape)>,
        solver: RapierSolver,
        poses: [Pose; 2],
        nodes: &[Point],
    ) -> Result<Self, SimulationError> {
        let mut world = settings::new_world(parameters, solver);
        fixed::insert(&mut world, obstacles, parameters.physics.contact_friction)?;
        let robots = Side::BOTH.map(|side| {
            RobotBody::insert(
                &mut world,
                parameters,
                poses[side.index()],
                tag::robot(side),
            )
        });
        let net = Net::insert(
            &mut world,
            parameters,
            nodes,
            [robots[0].handle, robots[1].handle],
        );
        let objects = Objects::insert(&mut world, parameters, &scene.objects);
        Ok(Self {
            parameters: parameters.clone(),
            world,
            robots,
            net,
            objects,
            steps: 0,
        })
    }

    fn hitches(&self) -> [Point; 2] {
        self.robots.each_ref().map(|r| r.hitch(&self.parameters))
    }
}

impl Physics for RapierWorld {
    fn step(&mut self, drives: &[RobotDrive; 2]) {
        let every = (SLEEP_INTERVAL / self.parameters.time_step)
            .round()
            .max(1.0) as u64;
        if self.steps.is_multiple_of(every) {
            let reach = self.parameters.robot.circles().reach();
            let discs = self
                .robots
                .each_ref()
                .map(|r| (r.state.pose.position(), reach));
            let polyline = self.net.polyline(&self.world);
            self.objects
                .update_sleep(&mut self.world, &polyline, &discs);
        }
        for (robot, drive) in self.robots.iter_mut().zip(drives) {
            robot.apply(&mut self.world, &self.parameters, drive);
        }
        self.net.apply(&mut self.world);
        self.objects.apply(&mut self.world);
        self.world.step();
        self.steps += 1;
        for robot in &mut self.robots {
            robot.observe(&self.world, &self.parameters);
        }
        self.objects.observe(&self.world);
    }

    fn robots(&self) -> [RobotState; 2] {
        self.robots.each_ref().map(|r| r.state)
    }

    fn loads(&self) -> [RobotLoad; 2] {
        self.robots.each_ref().map(|r| r.last)
    }

    fn net(&self) -> Vec<Point> {
        self.net.polyline(&self.world)
    }

    fn links(&self) -> Vec<Pose> {
        self.net.link_poses(&self.world)
    }

    fn objects(&self) -> Vec<Pose> {
        self.objects.poses()
    }

    fn awake_objects(&self) -> usize {
        self.objects.awake_count()
    }

    fn contacts(&self) -> Vec<Contact> {
        contacts::touching(&self.world)
    }

    fn joint_gap(&self) -> f64 {
        self.net.joint_gap(&self.world, self.hitches())
    }

    fn energy(&self) -> f64 {
        let robots: f64 = self.robots.iter().map(|r| r.energy(&self.world)).sum();
        robots + self.net.energy(&self.world) + self.objects.energy(&self.world)
    }
}
