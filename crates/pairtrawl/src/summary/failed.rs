//! What is shown of a scene without a plan.

use super::rings::free_rings;
use super::summarize;
use crate::error::PlanError;
use crate::infeasible::Infeasible;
use crate::no_plan::NoPlan;
use crate::not_found::NotFound;
use crate::options::PlanOptions;
use pairtrawl_certificate::infeasibility::ProofKind;
use pairtrawl_model::numbers::quantity;
use pairtrawl_model::{
    Cost, FailedSummary, Mark, PairTrajectory, Rehearsal, Scene, SceneOutline, SolverReport,
    Summary,
};

/// A scene as it is drawn before it is planned; `net_length` in m, `None`: open. The objects that are proven to be out of
/// reach are marked, and so is the place where a way is cut.
pub fn summarize_scene(
    scene: &Scene,
    net_length: Option<f64>,
    infeasible: Option<&Infeasible>,
) -> Summary {
    let proofs = infeasible.map_or(&[][..], |infeasible| &infeasible.proofs);
    let marks = proofs.iter().filter_map(|proof| {
        let place = match proof.kind {
            ProofKind::WayCut { place, .. } => place,
            _ => scene.objects.get(proof.object()?)?.position,
        };
        Some(Mark {
            place,
            toward: proof.least_move.map(|least| least.to),
            text: proof.message.clone(),
        })
    });
    Summary {
        title: scene.name.clone(),
        net_length: net_length.unwrap_or(f64::NAN),
        net_length_chosen: net_length.is_none(),
        outline: SceneOutline {
            area: scene.area,
            obstacles: scene.obstacles.clone(),
            free_rings: scene.map.as_ref().map(free_rings),
            objects: scene.objects.clone(),
            robot: scene.robot,
            start: scene.start,
            end: scene.end,
        },
        circles: Vec::new(),
        order: Vec::new(),
        left_out: infeasible.map_or_else(Vec::new, Infeasible::left_out),
        centerline: Vec::new(),
        baseline: PairTrajectory::default(),
        trajectory: PairTrajectory::default(),
        times: Vec::new(),
        left_length: 0.0,
        right_length: 0.0,
        duration: 0.0,
        swept_at: vec![None; scene.objects.len()],
        panels: Vec::new(),
        cost: Cost::default(),
        claims: Vec::new(),
        rehearsal: Rehearsal::Skipped,
        solver: SolverReport::NOT_STATED,
        stages: Vec::new(),
        warnings: Vec::new(),
        marks: marks.collect(),
        frames: None,
        execution: None,
    }
}

/// What is shown when planning a scene failed: with a proof, after a search, or for want of time. `None` for bad input and
/// for a run that somebody stopped: there is nothing to see. `options` are those that the scene was planned with.
pub fn summarize_failure(
    scene: &Scene,
    options: &PlanOptions,
    error: &PlanError,
) -> Option<FailedSummary> {
    let net_length = options.net_length_for(scene);
    let (verdict, summary, tried) = match error {
        PlanError::Infeasible(infeasible) => {
            let marked = scene.leaving(infeasible.objects());
            let summary = summarize_scene(&marked, net_length, Some(infeasible));
            ("proven infeasible", summary, Vec::new())
        }
        PlanError::NoPlan(not_found) => {
            let tried = not_found.tried.iter();
            let tried = tried.map(|tried| (tried.start.clone(), tried.missing.to_string()));
            let summary = attempted(scene, net_length, not_found);
            ("no certified plan was found", summary, tried.collect())
        }
        PlanError::TimeLimit { .. } => {
            let summary = summarize_scene(scene, net_length, None);
            ("the time ran out", summary, Vec::new())
        }
        PlanError::BadInput(_) | PlanError::Interrupted => return None,
    };
    Some(FailedSummary {
        summary,
        verdict: verdict.to_owned(),
        message: error.to_string(),
        help: error.remedy(),
        tried,
    })
}

/// The best attempt, with everything marked that is wrong with it; the scene where there is none.
fn attempted(scene: &Scene, net_length: Option<f64>, not_found: &NotFound) -> Summary {
    let Some(best) = &not_found.best else {
        let mut summary = summarize_scene(scene, net_length, None);
        summary.marks = (not_found.missing.place().into_iter())
            .map(|place| Mark {
                place,
                toward: None,
                text: not_found.missing.to_string(),
            })
            .collect();
        return summary;
    };
    let mut summary = summarize(scene, best, &[], None);
    let missed = |(object, swept): (usize, &Option<f64>)| {
        let thing = summary.outline.objects.get(object)?;
        (swept.is_none() && !thing.leave).then(|| Mark {
            place: thing.position,
            toward: None,
            text: format!("object {object} is not swept"),
        })
    };
    let mut marks: Vec<Mark> = (summary.swept_at.iter().enumerate())
        .filter_map(missed)
        .collect();
    for claim in summary.claims.iter().filter(|claim| !claim.claim.holds) {
        let (unit, claim) = (claim.unit, &claim.claim);
        let Some(place) = claim.place else { continue };
        let mut text = format!("{} fails", claim.id);
        if claim.margin.is_finite() {
            text += &format!(" by {}", quantity(-claim.margin, unit));
        }
        if !claim.detail.is_empty() {
            text += &format!(": {}", claim.detail);
        }
        match marks.iter_mut().find(|mark| mark.place == place) {
            Some(mark) => mark.text = text,
            None => marks.push(Mark {
                place,
                toward: None,
                text,
            }),
        }
    }
    if let NoPlan::RehearsalFails { event, place, .. } = &not_found.missing {
        marks.push(Mark {
            place: *place,
            toward: None,
            text: format!("the rehearsal fails: {event}"),
        });
    }
    summary.marks = marks;
    summary
}
