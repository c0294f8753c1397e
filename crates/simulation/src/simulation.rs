use crate::contacts::{self, Contact};
use crate::engine::new_world;
use crate::net::Net;
use crate::net_start;
use crate::objects::Objects;
use crate::robots::RobotBody;
use crate::{
    Options, Parameters, RobotDrive, RobotLoad, RobotState, SimulationError, obstacles, tag,
};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{PairPose, Scene, Side, Units, Warning};
use rapier2d_f64::prelude::PhysicsWorld;

/// Objects are woken and put to sleep this often: at a speed of 0.5 things move a third of the wake distance meanwhile.
const SLEEP_INTERVAL: f64 = 0.02;

/// Two robots, the net, the objects and the obstacles of a scene, in motion.
///
/// Callers give and get SI units. Inside, everything is in units of the machine ([`Units::of_machine`]), so that the
/// physics of a scene does not depend on its scale.
pub struct Simulation {
    /// In SI units.
    parameters: Parameters,
    units: Units,
    /// In units of the machine, as all that follows.
    inner: Parameters,
    world: PhysicsWorld,
    robots: [RobotBody; 2],
    net: Net,
    objects: Objects,
    steps: u64,
    warnings: Vec<Warning>,
}

impl Simulation {
    /// At the scene's start.
    ///
    /// # Errors
    /// When the scene, the net length or the options cannot be simulated.
    pub fn new(scene: &Scene, net_length: f64, options: &Options) -> Result<Self, SimulationError> {
        Self::starting_at(scene, net_length, scene.start, options)
    }

    /// With the robots at other poses than the scene's start.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn starting_at(
        scene: &Scene,
        net_length: f64,
        start: PairPose,
        options: &Options,
    ) -> Result<Self, SimulationError> {
        let parameters = Parameters::new(scene, net_length, options)?;
        let units = Units::of_machine(scene);
        let scene = &units.scene(scene);
        let net_length = units.tidy(net_length / units.length);
        let in_si = |error: SimulationError| error.in_si(&units);
        let inner = Parameters::new(scene, net_length, &options.in_units(&units)).map_err(in_si)?;
        let mut world = new_world(&inner);
        obstacles::insert(&mut world, scene).map_err(in_si)?;
        let fixed = world
            .colliders
            .iter()
            .map(|(_, c)| (*c.position(), c.shared_shape().clone()))
            .collect();
        let poses = [start.left, start.right].map(|pose| units.pose(pose));
        let laid = net_start::lay(scene, &inner, poses, fixed).map_err(in_si)?;
        let robots = Side::BOTH.map(|side| {
            RobotBody::insert(&mut world, &inner, poses[side.index()], tag::robot(side))
        });
        let net = Net::insert(
            &mut world,
            &inner,
            &laid.nodes,
            [robots[0].handle, robots[1].handle],
        );
        let objects = Objects::insert(&mut world, &inner, &scene.objects);
        Ok(Self {
            parameters,
            units,
            inner,
            world,
            robots,
            net,
            objects,
            steps: 0,
            warnings: (laid.warning.into_iter())
                .map(|warning| warning.in_meters(units.length))
                .collect(),
        })
    }

    /// Advances by one time step with this drive of the (left, right) robot.
    ///
    /// # Errors
    /// When a position or velocity is no longer finite.
    pub fn step(&mut self, drive: [RobotDrive; 2]) -> Result<(), SimulationError> {
        let every = (SLEEP_INTERVAL / self.inner.time_step).round().max(1.0) as u64;
        if self.steps.is_multiple_of(every) {
            let reach = self.inner.robot.circles().reach();
            let discs = self
                .robots
                .each_ref()
                .map(|r| (r.state.pose.position(), reach));
            let polyline = self.net.polyline(&self.world);
            self.objects
                .update_sleep(&mut self.world, &polyline, &discs);
        }
        for (robot, drive) in self.robots.iter_mut().zip(&drive) {
            robot.apply(&mut self.world, &self.inner, &drive.in_units(&self.units));
        }
        self.net.apply(&mut self.world);
        self.objects.apply(&mut self.world);
        self.world.step();
        self.steps += 1;
        for robot in &mut self.robots {
            robot.observe(&self.world, &self.inner);
        }
        self.objects.observe(&self.world);
        let finite = self
            .robots
            .iter()
            .all(|r| r.state.pose.is_finite() && r.last.load.is_finite());
        if finite {
            Ok(())
        } else {
            Err(SimulationError::Diverged { time: self.time() })
        }
    }

    /// Time since the start, s.
    pub fn time(&self) -> f64 {
        self.steps as f64 * self.parameters.time_step
    }

    /// The units of the machine, which everything inside is in. 1 each for the default machine.
    pub fn units(&self) -> Units {
        self.units
    }

    /// What stays constant, in SI units.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Poses and velocities of the (left, right) robot.
    pub fn robots(&self) -> [RobotState; 2] {
        self.robots.each_ref().map(|r| r.state.in_si(&self.units))
    }

    /// Poses of both robots.
    pub fn pair(&self) -> PairPose {
        let [left, right] = self.robots();
        PairPose {
            left: left.pose,
            right: right.pose,
        }
    }

    /// What acted on the (left, right) robot in the last step. The load is the force of the net (and of whatever else touches
    /// the robot) by the momentum balance of the robot; the impulses that the engine reports are not that force.
    pub fn loads(&self) -> [RobotLoad; 2] {
        self.robots.each_ref().map(|r| r.last.in_si(&self.units))
    }

    /// The net from the left hitch to the right one: both ends and every hinge, m.
    pub fn net(&self) -> Vec<Point> {
        let nodes = self.net.polyline(&self.world);
        nodes
            .into_iter()
            .map(|p| self.units.place_in_si(p))
            .collect()
    }

    /// Centers and turns of the net's links, from the left.
    pub fn links(&self) -> Vec<Pose> {
        self.poses_in_si(self.net.link_poses(&self.world))
    }

    /// Hitch points of the (left, right) robot, m.
    pub fn hitches(&self) -> [Point; 2] {
        self.inner_hitches().map(|p| self.units.place_in_si(p))
    }

    /// Centers and turns of the objects, in the scene's order.
    pub fn objects(&self) -> Vec<Pose> {
        self.poses_in_si(self.objects.poses())
    }

    fn poses_in_si(&self, poses: Vec<Pose>) -> Vec<Pose> {
        poses
            .into_iter()
            .map(|p| self.units.pose_in_si(p))
            .collect()
    }

    fn inner_hitches(&self) -> [Point; 2] {
        self.robots.each_ref().map(|r| r.hitch(&self.inner))
    }

    /// How many objects take part in the physics at the moment; the others lie still, out of reach.
    pub fn awake_objects(&self) -> usize {
        self.objects.awake_count()
    }

    /// Per object: true when its center lies in the region bounded by the net and the hitch line.
    pub fn gathered(&self) -> Vec<bool> {
        let net = self.net();
        self.objects()
            .iter()
            .map(|o| crate::encloses(&net, o.position()))
            .collect()
    }

    /// Everything that touches, after the last step.
    pub fn contacts(&self) -> Vec<Contact> {
        let contacts = contacts::touching(&self.world).into_iter();
        contacts.map(|c| c.in_si(&self.units)).collect()
    }

    /// Greatest gap in a hinge of the net, m.
    pub fn joint_gap(&self) -> f64 {
        self.net.joint_gap(&self.world, self.inner_hitches()) * self.units.length
    }

    /// Kinetic energy of everything and what is stored in tires and support points, J.
    pub fn energy(&self) -> f64 {
        let robots: f64 = self.robots.iter().map(|r| r.energy(&self.world)).sum();
        let inner = robots + self.net.energy(&self.world) + self.objects.energy(&self.world);
        inner * self.units.torque()
    }

    /// Warnings for people, from setting up.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
