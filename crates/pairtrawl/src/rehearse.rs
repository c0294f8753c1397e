use crate::check::without_left;
use crate::files::PlanFile;
use crate::judge;
use pairtrawl_execution::ExecutionError;
use pairtrawl_model::{PairTrajectory, Plan, RehearsalRecord, Scene, SceneReference};
use pairtrawl_reference::Reference;
use pairtrawl_simulation::Options;

/// A plan from a file, judged anew, with what happened when it was driven in physics.
#[derive(Clone, Debug, PartialEq)]
pub struct Rehearsed {
    /// The plan with its own certificate, cost and rehearsal. Its certificate need not hold.
    pub plan: Plan,
    /// What happened.
    pub record: RehearsalRecord,
}

/// Drives any plan of a scene in physics. The certificate is derived again beside it: what is proven and what was
/// rehearsed are never mixed.
///
/// # Errors
/// When the trajectories cannot become a reference, or scene or net length cannot be simulated. A plan that goes wrong is a record, not an error.
pub fn rehearse(
    scene: &Scene,
    reference: &SceneReference,
    file: &PlanFile,
    options: &Options,
) -> Result<Rehearsed, ExecutionError> {
    let mut plan = judge(scene, reference, file);
    let scene = &*without_left(scene, &plan.left_out);
    let record = rehearse_trajectory(scene, plan.net_length, &plan.trajectory, options)?;
    plan.rehearsal = record.verdict.clone();
    Ok(Rehearsed { plan, record })
}

/// Drives the reference of a trajectory in physics.
///
/// # Errors
/// As [`rehearse`].
pub fn rehearse_trajectory(
    scene: &Scene,
    net_length: f64,
    trajectory: &PairTrajectory,
    options: &Options,
) -> Result<RehearsalRecord, ExecutionError> {
    let reference = Reference::of_scene(scene, trajectory)?;
    Ok(pairtrawl_execution::rehearse(
        scene, net_length, &reference, options,
    )?)
}
