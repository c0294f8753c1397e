use super::FORMAT;
use super::file::{
    Baseline, File, FileCertificate, FileCircle, FileLeftOut, FileOverrides, FileRehearsal,
    FileSolver,
};
use super::layout::lines;
use crate::files::parts::{FileClaim, FileCost, Reference, finite};
use pairtrawl_geometry::Pose;
use pairtrawl_model::{Certificate, Plan, Rehearsal, SolverReport};

/// The plan as one JSON object, a line for each field, with a line end. Numbers are the shortest that read back as the
/// same bits; a margin that nothing bounds (no obstacle to keep clear of) is null.
///
/// # Errors
/// Never for a plan that fits into memory; the JSON library wants it.
pub fn plan_json(plan: &Plan) -> Result<String, serde_json::Error> {
    lines(&File::from(plan))
}

impl From<&Plan> for File {
    fn from(plan: &Plan) -> Self {
        Self {
            format: FORMAT.to_owned(),
            net_length: plan.net_length,
            left: poses(&plan.trajectory.left),
            right: poses(&plan.trajectory.right),
            step_time: Some(plan.trajectory.step_time),
            time_law: Some(plan.time_law.clone()),
            scene: Some(Reference::from(&plan.scene)),
            overrides: Some(FileOverrides::from(&plan.overrides)),
            centerline: Some(poses(&plan.centerline)),
            baseline: Some(Baseline {
                left: poses(&plan.baseline.left),
                right: poses(&plan.baseline.right),
            }),
            circles: Some(
                (plan.circles.iter())
                    .map(|circle| FileCircle {
                        center: circle.center.into(),
                        radius: circle.radius,
                        objects: circle.objects.clone(),
                    })
                    .collect(),
            ),
            order: Some(plan.order.clone()),
            left_out: plan.left_out.iter().map(FileLeftOut::from).collect(),
            cost: Some(FileCost::from(plan.cost)),
            certificate: Some(FileCertificate::from(&plan.certificate)),
            rehearsal: Some(FileRehearsal::from(&plan.rehearsal)),
            solver: Some(FileSolver::from(&plan.solver)),
            warnings: Some(plan.warnings.iter().map(ToString::to_string).collect()),
        }
    }
}

fn poses(poses: &[Pose]) -> Vec<[f64; 3]> {
    poses.iter().map(|&pose| pose.into()).collect()
}

impl From<&Certificate> for FileCertificate {
    fn from(certificate: &Certificate) -> Self {
        Self {
            valid: certificate.is_valid(),
            claims: certificate.claims.iter().map(FileClaim::from).collect(),
        }
    }
}

impl From<&Rehearsal> for FileRehearsal {
    fn from(rehearsal: &Rehearsal) -> Self {
        match rehearsal {
            Rehearsal::Passed => Self::Passed,
            Rehearsal::Failed { event, time, place } => Self::Failed {
                event: event.clone(),
                time: *time,
                place: (*place).into(),
            },
            Rehearsal::Skipped => Self::Skipped,
        }
    }
}

impl From<&SolverReport> for FileSolver {
    fn from(solver: &SolverReport) -> Self {
        Self {
            status: solver.status.name().to_owned(),
            iterations: solver.iterations,
            kkt_error: finite(solver.kkt_error),
            seconds: solver.seconds,
        }
    }
}
