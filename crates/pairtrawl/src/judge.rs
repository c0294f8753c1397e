use crate::check::{Candidate, check};
use crate::files::PlanFile;
use pairtrawl_model::{PairTrajectory, Plan, Scene, SceneReference};
use pairtrawl_trajopt::evaluate;

impl<'a> Candidate<'a> {
    /// What a plan file states, driven along its own trajectory in a scene ([`PlanFile::trajectory`]).
    pub fn of_file(file: &'a PlanFile, trajectory: &'a PairTrajectory) -> Self {
        Self {
            net_length: file.net_length,
            trajectory,
            scene: file.scene.as_ref(),
            overrides: &file.overrides,
            time_law: file.time_law.as_deref(),
            left_out: &file.left_out,
        }
    }
}

/// A plan from a file, perhaps one made elsewhere, with its cost evaluated and every claim derived again. Its certificate
/// need not hold; what the file states about its solver and its rehearsal is kept.
pub fn judge(scene: &Scene, reference: &SceneReference, file: &PlanFile) -> Plan {
    let trajectory = file.trajectory(scene);
    let candidate = Candidate::of_file(file, &trajectory);
    let (left, right) = file.baseline.clone().unwrap_or_default();
    Plan {
        time_law: file.time_law.clone().unwrap_or_default(),
        net_length: file.net_length,
        cost: evaluate(scene, &trajectory, file.net_length),
        certificate: check(scene, reference, &candidate),
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
        left_out: file.left_out.clone(),
        rehearsal: file.rehearsal.clone(),
        solver: file.solver.clone(),
        warnings: Vec::new(),
        trajectory,
    }
}
