use crate::engine::unit;
use crate::watch::Watch;
use crate::{Options, RobotDrive, Simulation, SimulationError};
use pairtrawl_geometry::Pose;
use pairtrawl_model::{PairPose, PairTrajectory, RehearsalRecord, Scene};

/// Decides what both robots do next.
pub trait Driver {
    /// The drive of the (left, right) robot for the coming time step.
    fn drive(&mut self, simulation: &Simulation) -> [RobotDrive; 2];
}

/// Drives both robots along a trajectory with the built-in servo, and stands still after its end.
#[derive(Clone, Debug)]
pub struct PlanFollower {
    trajectory: PairTrajectory,
}

impl PlanFollower {
    /// For this trajectory.
    ///
    /// # Errors
    /// When it has fewer than two waypoints, not as many for each robot, or numbers that are not finite.
    pub fn new(trajectory: &PairTrajectory) -> Result<Self, SimulationError> {
        let (left, right, step_time) = (
            trajectory.left.len(),
            trajectory.right.len(),
            trajectory.step_time,
        );
        let finite = trajectory
            .left
            .iter()
            .chain(&trajectory.right)
            .all(|p| p.is_finite());
        if left != right || left < 2 || !finite || !step_time.is_finite() || step_time <= 0.0 {
            return Err(SimulationError::Trajectory {
                left,
                right,
                step_time,
            });
        }
        Ok(Self {
            trajectory: trajectory.clone(),
        })
    }

    /// Where both robots should be at a time, s.
    pub fn reference(&self, time: f64) -> PairPose {
        let (step, fraction) = self.locate(time);
        let at = |poses: &[Pose]| poses[step].lerp(poses[step + 1], fraction);
        PairPose {
            left: at(&self.trajectory.left),
            right: at(&self.trajectory.right),
        }
    }

    /// Step index and fraction of the step at a time.
    fn locate(&self, time: f64) -> (usize, f64) {
        let last = self.trajectory.len() - 2;
        let steps = (time / self.trajectory.step_time).max(0.0);
        let step = (steps.floor() as usize).min(last);
        (step, (steps - step as f64).min(1.0))
    }

    fn follow(&self, poses: &[Pose], time: f64) -> RobotDrive {
        let (step, fraction) = self.locate(time);
        let (from, to) = (poses[step], poses[step + 1]);
        let pose = from.lerp(to, fraction);
        if time >= self.trajectory.duration() {
            return RobotDrive::Follow {
                pose,
                forward: 0.0,
                turn_rate: 0.0,
            };
        }
        let middle = 0.5 * (from.heading + to.heading);
        let forward =
            (to.position() - from.position()).dot(unit(middle)) / self.trajectory.step_time;
        RobotDrive::Follow {
            pose,
            forward,
            turn_rate: (to.heading - from.heading) / self.trajectory.step_time,
        }
    }
}

impl Driver for PlanFollower {
    fn drive(&mut self, simulation: &Simulation) -> [RobotDrive; 2] {
        let time = simulation.time() + simulation.parameters().time_step;
        [
            self.follow(&self.trajectory.left, time),
            self.follow(&self.trajectory.right, time),
        ]
    }
}

/// Steps a simulation until `duration` (s), calling `observe` after each step.
///
/// # Errors
/// When the physics breaks down.
pub fn run(
    simulation: &mut Simulation,
    driver: &mut dyn Driver,
    duration: f64,
    observe: &mut dyn FnMut(&Simulation),
) -> Result<(), SimulationError> {
    let steps = (duration / simulation.parameters().time_step).ceil() as u64;
    for _ in 0..steps {
        let drive = driver.drive(simulation);
        simulation.step(drive)?;
        observe(simulation);
    }
    Ok(())
}

/// Drives a plan in physics with the built-in servo and reports what happened.
///
/// # Errors
/// When scene, net length, trajectory or options cannot be simulated. A plan that goes wrong is a record, not an error.
pub fn rehearse(
    scene: &Scene,
    net_length: f64,
    trajectory: &PairTrajectory,
    options: &Options,
) -> Result<RehearsalRecord, SimulationError> {
    let options = options.for_scene(scene);
    let mut driver = PlanFollower::new(trajectory)?;
    let mut simulation = Simulation::starting_at(scene, net_length, trajectory.pair(0), &options)?;
    let mut watch = Watch::new(scene, &options, driver.clone(), &simulation);
    let duration = trajectory.duration() + options.settle_time;
    run(&mut simulation, &mut driver, duration, &mut |simulation| {
        watch.observe(simulation)
    })?;
    Ok(watch.finish(&simulation))
}
