use crate::files::PlanFile;
use crate::judge;
use pairtrawl_model::{Plan, RehearsalRecord, Scene, SceneReference};
use pairtrawl_simulation::{Options, SimulationError};

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
/// When scene, net length or trajectories cannot be simulated. A plan that goes wrong is a record, not an error.
pub fn rehearse(
    scene: &Scene,
    reference: &SceneReference,
    file: &PlanFile,
    options: &Options,
) -> Result<Rehearsed, SimulationError> {
    let mut plan = judge(scene, reference, file);
    let record = pairtrawl_simulation::rehearse(scene, plan.net_length, &plan.trajectory, options)?;
    plan.rehearsal = record.verdict.clone();
    Ok(Rehearsed { plan, record })
}
