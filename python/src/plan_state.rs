//! What the pickle of a plan holds: its file, what the file does not have, its scene and its rehearsal.

use crate::plan::Plan;
use crate::record_state::RecordState;
use crate::scene_state::{SceneState, Source};
use pairtrawl::files::{PlanFile, parse_plan};
use pairtrawl::geometry::Point;
use pairtrawl::model::{
    Certificate, Claim, ClaimId, Cost, PairTrajectory, Plan as LibraryPlan, SolverReport,
    StageTime, Warning,
};
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::sync::Arc;

/// The pickle of a plan.
#[derive(Serialize, Deserialize)]
pub struct PlanState {
    file: String,
    has_time_law: bool,
    cost: [f64; 4],
    kkt_error: f64,
    claims: Vec<ClaimState>,
    warnings: Vec<String>,
    stages: Vec<(String, f64)>,
    record: Option<RecordState>,
    scene: Source,
}

#[derive(Serialize, Deserialize)]
struct ClaimState {
    name: String,
    holds: bool,
    margin: f64,
    step: Option<usize>,
    place: Option<[f64; 2]>,
    detail: String,
}

impl PlanState {
    /// What the pickle of a plan holds.
    pub fn of(plan: &Plan) -> Self {
        let whole = &plan.plan;
        let claims = whole.certificate.claims.iter().map(|claim| ClaimState {
            name: claim.id.name().to_owned(),
            holds: claim.holds,
            margin: claim.margin,
            step: claim.step,
            place: claim.place.map(Into::into),
            detail: claim.detail.clone(),
        });
        let Cost {
            smoothness,
            distance,
            obstacle,
            expansion,
        } = whole.cost;
        Self {
            file: plan.json(),
            has_time_law: !whole.time_law.is_empty(),
            cost: [smoothness, distance, obstacle, expansion],
            kkt_error: whole.solver.kkt_error,
            claims: claims.collect(),
            warnings: whole.warnings.iter().map(ToString::to_string).collect(),
            stages: plan
                .stages
                .iter()
                .map(|stage| (stage.name.clone(), stage.seconds))
                .collect(),
            record: plan.record.as_ref().map(RecordState::of),
            scene: plan.scene.source().clone(),
        }
    }

    /// The plan again.
    pub fn into_plan(self) -> Result<Plan, String> {
        let scene = SceneState::read(self.scene).map_err(|error| error.to_string())?;
        let file =
            parse_plan(&self.file, Path::new("pickle")).map_err(|error| error.to_string())?;
        let claims = self.claims.into_iter().map(ClaimState::into_claim);
        let claims = claims.collect::<Result<Vec<_>, _>>()?;
        let [smoothness, distance, obstacle, expansion] = self.cost;
        let trajectory = file.trajectory(&scene.loaded.scene);
        let PlanFile {
            net_length,
            time_law,
            scene: named,
            overrides,
            centerline,
            baseline,
            circles,
            order,
            ..
        } = file;
        let (left, right) = baseline.unwrap_or_default();
        let plan = LibraryPlan {
            net_length,
            time_law: time_law.filter(|_| self.has_time_law).unwrap_or_default(),
            scene: named.unwrap_or_default(),
            overrides,
            centerline,
            baseline: PairTrajectory {
                left,
                right,
                step_time: trajectory.step_time,
            },
            circles,
            order,
            left_out: file.left_out,
            cost: Cost {
                smoothness,
                distance,
                obstacle,
                expansion,
            },
            certificate: Certificate { claims },
            rehearsal: file.rehearsal,
            solver: SolverReport {
                kkt_error: self.kkt_error,
                ..file.solver
            },
            warnings: self.warnings.into_iter().map(Warning::Stated).collect(),
            trajectory,
        };
        let stages = self
            .stages
            .into_iter()
            .map(|(name, seconds)| StageTime { name, seconds });
        let record = self.record.map(RecordState::into_record);
        Ok(Plan::of(plan, record, stages.collect(), Arc::new(scene)))
    }
}

impl ClaimState {
    fn into_claim(self) -> Result<Claim, String> {
        let id = ClaimId::ALL.into_iter().find(|id| id.name() == self.name);
        Ok(Claim {
            id: id.ok_or_else(|| format!("there is no claim {}", self.name))?,
            holds: self.holds,
            margin: self.margin,
            step: self.step,
            place: self.place.map(Point::from),
            detail: self.detail,
        })
    }
}
