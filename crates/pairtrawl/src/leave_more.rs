//! Objects that no search could include: what is in the way of the best attempt is left, and the rest is planned for.

use crate::error::PlanError;
use crate::no_plan::NoPlan;
use crate::not_found::NotFound;
use crate::passage::first_passage;
use crate::prepare::Prepared;
use crate::run::Run;
use pairtrawl_geometry::Point;
use pairtrawl_model::{ClaimId, Leave, LeftOut, LeftWhy, Plan, Scene};

/// Times that more is left, at most.
const ROUNDS: usize = 6;
/// An object farther than this from a place where a claim fails has nothing to do with it, in units of the length scale.
const NEAR: f64 = 2.0;

/// Plans by `plan` for what remains of a scene for which no plan was found, leaving more and more. `plan` also returns the
/// objects that its result leaves because no plan was found with them. Where the options do not allow to leave anything,
/// the refusal comes back, and says which objects a plan was found without.
///
/// # Errors
/// [`PlanError`], as without leaving more.
pub(crate) fn leave_more<T>(
    prepared: &Prepared,
    mut refused: Box<NotFound>,
    run: &mut Run,
    mut plan: impl FnMut(&Prepared, &mut Run) -> Result<(T, Vec<usize>), PlanError>,
) -> Result<T, PlanError> {
    let may_leave = prepared.options.leave_for(&prepared.scene) == Leave::Unreachable;
    if !may_leave && matches!(refused.missing, NoPlan::TooFewWaypoints { .. }) {
        // What helps there is known: more waypoints.
        return Err(PlanError::NoPlan(refused));
    }
    let mut latest = refused.clone();
    let mut rest = prepared.leaving(&[]);
    for _ in 0..ROUNDS {
        let in_the_way = in_the_way(&latest, &rest.scene, NEAR * prepared.scales.length);
        let left = |object| LeftOut {
            object,
            why: LeftWhy::NotFound,
            text: format!("no plan was found with it: {}", latest.missing),
        };
        let more: Vec<LeftOut> = in_the_way.into_iter().map(left).collect();
        rest = rest.leaving(&more);
        if more.is_empty() || rest.scene.wanted() == 0 {
            break;
        }
        run.note(&format!(
            "no certified plan; planning again without {} more of the objects",
            more.len()
        ));
        run.round += 1;
        match plan(&rest, run) {
            Ok((planned, still_left)) if may_leave || still_left.is_empty() => return Ok(planned),
            Ok((_, still_left)) => {
                refused.could_leave = still_left;
                break;
            }
            Err(PlanError::NoPlan(next)) => latest = next,
            Err(error) => return Err(error),
        }
    }
    Err(PlanError::NoPlan(refused))
}

/// What a plan leaves because no plan was found with it.
pub(crate) fn not_found(plan: &Plan) -> impl Iterator<Item = &LeftOut> {
    let left_out = plan.left_out.iter();
    left_out.filter(|left| left.why == LeftWhy::NotFound)
}

/// The objects for which no plan was found and that a plan sweeps nevertheless.
pub(crate) fn swept_anyway(plan: &Plan, scene: &Scene) -> Vec<usize> {
    not_found(plan)
        .map(|left| left.object)
        .filter(|&object| first_passage(&plan.trajectory, scene.objects[object].position).is_some())
        .collect()
}

/// The objects that are to be gathered and that an attempt leaves outside, and those nearest to where another claim fails.
fn in_the_way(refused: &NotFound, scene: &Scene, near: f64) -> Vec<usize> {
    let mut found: Vec<usize> = Vec::new();
    let wanted = |index: &usize| !scene.objects[*index].leave;
    let indices = || (0..scene.objects.len()).filter(wanted);
    let nearest = |place: Point| {
        let distance = |&i: &usize| scene.objects[i].position.distance(place);
        indices()
            .filter(|i| distance(i) < near)
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
    };
    if let Some(best) = &refused.best {
        for claim in best.certificate.claims.iter().filter(|claim| !claim.holds) {
            if claim.id == ClaimId::EveryObjectCovered {
                found.extend(indices().filter(|&i| {
                    first_passage(&best.trajectory, scene.objects[i].position).is_none()
                }));
            } else {
                found.extend(claim.place.and_then(nearest));
            }
        }
    }
    if found.is_empty()
        && let Some(best) = &refused.best
        && let Some(stuck) = refused.missing.claim().and_then(|claim| claim.step)
    {
        // The way to the next object does not exist, or was not found.
        let passage = |i: usize| {
            let (step, _) = first_passage(&best.trajectory, scene.objects[i].position)?;
            (step >= stuck).then_some((step, i))
        };
        found.extend(indices().filter_map(passage).min().map(|(_, i)| i));
    }
    if found.is_empty() {
        found.extend(refused.missing.place().and_then(nearest));
    }
    found.sort_unstable();
    found.dedup();
    found
}
