use crate::obstacles::{self, FixedShape};
use crate::{Options, Parameters, Simulation, SimulationError};
use pairtrawl_geometry::Pose;
use pairtrawl_model::{PairTrajectory, Scene};

/// How everything stands at the start.
pub(super) struct Layout {
    pub(super) parameters: Parameters,
    pub(super) robots: [Pose; 2],
    /// Centers and turns of the links, from the left.
    pub(super) links: Vec<Pose>,
    pub(super) obstacles: Vec<FixedShape>,
}

impl Layout {
    pub(super) fn new(
        scene: &Scene,
        net_length: f64,
        trajectory: &PairTrajectory,
    ) -> Result<Self, SimulationError> {
        validate(trajectory)?;
        let start = trajectory.pair(0);
        let simulation = Simulation::starting_at(scene, net_length, start, &Options::default())?;
        Ok(Self {
            parameters: simulation.parameters().clone(),
            robots: [start.left, start.right],
            links: simulation.links(),
            obstacles: obstacles::shapes(scene)?
                .into_iter()
                .map(|(_, shape)| shape)
                .collect(),
        })
    }
}

fn validate(trajectory: &PairTrajectory) -> Result<(), SimulationError> {
    let (left, right) = (trajectory.left.len(), trajectory.right.len());
    let step_time = trajectory.step_time;
    let mut poses = trajectory.left.iter().chain(&trajectory.right);
    let usable = left == right && left >= 2 && poses.all(|p| p.is_finite());
    if usable && step_time.is_finite() && step_time > 0.0 {
        return Ok(());
    }
    Err(SimulationError::Trajectory {
        left,
        right,
        step_time,
    })
}
