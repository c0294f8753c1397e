use crate::check::{Candidate, check};
use crate::files::PlanFile;
use pairtrawl_model::{
    PairTrajectory, Plan, Rehearsal, RehearsalRecord, Scene, SceneReference, SolverReport,
    SolverStatus,
};
use pairtrawl_simulation::{Options, SimulationError};
use pairtrawl_trajopt::evaluate;

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
    let trajectory = file.trajectory(scene);
    let record = pairtrawl_simulation::rehearse(scene, file.net_length, &trajectory, options)?;
    let plan = judged(scene, reference, file, trajectory, record.verdict.clone());
    Ok(Rehearsed { plan, record })
}

/// A plan file as a plan, with its cost evaluated and its claims derived again.
pub(crate) fn judged(
    scene: &Scene,
    reference: &SceneReference,
    file: &PlanFile,
    trajectory: PairTrajectory,
    rehearsal: Rehearsal,
) -> Plan {
    let candidate = Candidate {
        net_length: file.net_length,
        trajectory: &trajectory,
        scene: file.scene.as_ref(),
        overrides: &file.overrides,
    };
    let certificate = check(scene, reference, &candidate);
    let (left, right) = file.baseline.clone().unwrap_or_default();
    Plan {
        net_length: file.net_length,
        cost: evaluate(scene, &trajectory, file.net_length),
        certificate,
        scene: reference.clone(),
        overrides: file.overrides,
        centerline: file.centerline.clone(),
        baseline: PairTrajectory {
            left,
            right,
            step_time: trajectory.step_time,
        },
        circles: file.circles.clone(),
        order: file.order.clone(),
        rehearsal,
        solver: SolverReport {
            status: SolverStatus::NotStated,
            iterations: 0,
            kkt_error: f64::NAN,
            seconds: 0.0,
        },
        warnings: Vec::new(),
        trajectory,
    }
}
