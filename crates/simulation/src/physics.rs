use crate::{Contact, RobotDrive, RobotLoad, RobotState};
use pairtrawl_dynamics::Work;
use pairtrawl_geometry::{Point, Pose};

/// An engine with everything of a scene in it. All quantities are in units of the machine, all lists in the order of the scene.
pub(crate) trait Physics {
    /// Advances by the time step with this drive of the (left, right) robot.
    fn step(&mut self, drives: &[RobotDrive; 2]);

    /// Poses and velocities of the (left, right) robot.
    fn robots(&self) -> [RobotState; 2];

    /// What acted on the (left, right) robot in the last step.
    fn loads(&self) -> [RobotLoad; 2];

    /// The net: left hitch, hinges, right hitch.
    fn net(&self) -> Vec<Point>;

    /// Centers and turns of the links.
    fn links(&self) -> Vec<Pose>;

    /// Centers and turns of the objects.
    fn objects(&self) -> Vec<Pose>;

    /// How many objects take part in the physics at the moment.
    fn awake_objects(&self) -> usize;

    /// What pushed in the last step, or at least touches (rapier); links among themselves left out.
    fn contacts(&self) -> Vec<Contact>;

    /// Greatest difference of a link's length from what it should be, or greatest gap in a hinge (rapier).
    fn joint_gap(&self) -> f64;

    /// Kinetic energy and what is stored in links, or in tires and support points (rapier).
    fn energy(&self) -> f64;

    /// Has its stages timed, where the engine can do that.
    fn measure(&mut self, _clock: fn() -> u64) {}

    /// How much work the steps were, where the engine knows.
    fn work(&self) -> Option<Work> {
        None
    }
}
