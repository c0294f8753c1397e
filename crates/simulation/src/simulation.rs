use crate::implicit::ImplicitWorld;
use crate::physics::Physics;
use crate::{
    Contact, Engine, Options, Parameters, RobotDrive, RobotLoad, RobotState, SimulationError,
    net_start, obstacles,
};
use pairtrawl_dynamics::Work;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{PairPose, Scene, Units, Warning};

/// Two robots, the net, the objects and the obstacles of a scene, in motion.
///
/// Callers give and get SI units. Inside, everything is in units of the machine ([`Units::of_machine`]), so that the
/// physics of a scene does not depend on its scale.
pub struct Simulation {
    /// In SI units.
    parameters: Parameters,
    units: Units,
    /// In units of the machine.
    world: Box<dyn Physics>,
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
        let fixed = obstacles::shapes(scene).map_err(in_si)?;
        let (pieces, solids): (Vec<_>, Vec<_>) = (fixed.iter())
            .map(|(obstacle, shape)| (*obstacle, shape.solid()))
            .unzip();
        let poses = [start.left, start.right].map(|pose| units.pose(pose));
        let laid = net_start::lay(scene, &inner, poses, &solids).map_err(in_si)?;
        let world: Box<dyn Physics> = match options.engine {
            Engine::Implicit => Box::new(ImplicitWorld::new(
                &inner,
                pieces,
                solids,
                &scene.objects,
                poses,
                laid.nodes,
            )),
            #[cfg(feature = "rapier")]
            Engine::Rapier(solver) => Box::new(
                crate::rapier::RapierWorld::new(scene, &inner, fixed, solver, poses, &laid.nodes)
                    .map_err(in_si)?,
            ),
        };
        Ok(Self {
            parameters,
            units,
            world,
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
        self.world
            .step(&drive.map(|drive| drive.in_units(&self.units)));
        self.steps += 1;
        let finite = (self.world.robots().iter()).all(|r| r.pose.is_finite())
            && self.world.loads().iter().all(|l| l.load.is_finite());
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
        self.world.robots().map(|r| r.in_si(&self.units))
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
        self.world.loads().map(|l| l.in_si(&self.units))
    }

    /// The net from the left hitch to the right one: both ends and every hinge, m.
    pub fn net(&self) -> Vec<Point> {
        let nodes = self.world.net();
        nodes
            .into_iter()
            .map(|p| self.units.place_in_si(p))
            .collect()
    }

    /// Centers and turns of the net's links, from the left.
    pub fn links(&self) -> Vec<Pose> {
        self.poses_in_si(self.world.links())
    }

    /// Hitch points of the (left, right) robot, m.
    pub fn hitches(&self) -> [Point; 2] {
        let hitch = self.parameters.robot.hitch;
        self.robots().map(|r| r.pose.hitch_point(hitch))
    }

    /// Centers and turns of the objects, in the scene's order.
    pub fn objects(&self) -> Vec<Pose> {
        self.poses_in_si(self.world.objects())
    }

    fn poses_in_si(&self, poses: Vec<Pose>) -> Vec<Pose> {
        poses
            .into_iter()
            .map(|p| self.units.pose_in_si(p))
            .collect()
    }

    /// How many objects take part in the physics at the moment; the others lie still, out of reach.
    pub fn awake_objects(&self) -> usize {
        self.world.awake_objects()
    }

    /// Per object: true when its center lies in the region bounded by the net and the hitch line.
    pub fn gathered(&self) -> Vec<bool> {
        let net = self.net();
        self.objects()
            .iter()
            .map(|o| crate::encloses(&net, o.position()))
            .collect()
    }

    /// What pushed in the last step; links among themselves left out. rapier also lists what touches without a push.
    pub fn contacts(&self) -> Vec<Contact> {
        let contacts = self.world.contacts().into_iter();
        contacts.map(|c| c.in_si(&self.units)).collect()
    }

    /// Greatest difference of a link's length from what it should be, m; with rapier, whose links are rigid, the greatest gap in a
    /// hinge.
    pub fn joint_gap(&self) -> f64 {
        self.world.joint_gap() * self.units.length
    }

    /// Kinetic energy of everything and what is stored in stretched links (with rapier: in tires and support points), J.
    pub fn energy(&self) -> f64 {
        self.world.energy() * self.units.torque()
    }

    /// Has the stages of the steps timed with this clock; rapier's are not.
    pub fn measure(&mut self, clock: fn() -> u64) {
        self.world.measure(clock);
    }

    /// How much work the steps were; `None` with rapier.
    pub fn work(&self) -> Option<Work> {
        self.world.work()
    }

    /// Warnings for people, from setting up.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
