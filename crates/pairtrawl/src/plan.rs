//! Planning, on one page of named steps: scene -> world -> order -> centerline -> baseline -> optimise -> certify ->
//! (rehearse) -> plan.

use crate::attempt::Course;
use crate::check::{Candidate, check};
use crate::run::Run;
use crate::{NetLength, Observer, OrderMethod, PlanError, PlanOptions, Stage};
use pairtrawl_certificate::infeasibility;
use pairtrawl_model::{
    Overrides, Plan, Rehearsal, RehearsalRecord, Scene, SceneReference, StageTime,
};
use pairtrawl_route::{RouteError, hybrid_a_star, visiting_order};
use pairtrawl_trajopt::evaluate;
use pairtrawl_world::World;

/// A plan and what planning it showed.
#[derive(Clone, Debug, PartialEq)]
pub struct Planned {
    /// The plan; every claim of its certificate holds.
    pub plan: Plan,
    /// What happened in the rehearsal of this plan, when there was one.
    pub rehearsal: Option<RehearsalRecord>,
    /// Seconds per stage, summed over rounds, in the order of their first start.
    pub stages: Vec<StageTime>,
}

/// Plans a scene; `reference` says which scene file it is and goes into the plan.
///
/// # Errors
/// [`PlanError`]: the input cannot be planned for, there is a proof that no plan exists, none was found within the
/// budget, or someone stopped it.
pub fn plan(
    scene: &Scene,
    reference: &SceneReference,
    options: &PlanOptions,
    observer: &mut dyn Observer,
) -> Result<Planned, PlanError> {
    let mut run = Run::new(options, observer);
    let net_length = match options.net_length {
        None => scene.net.length,
        Some(NetLength::Auto) => None,
        Some(NetLength::Fixed(length)) => Some(length),
    };

    if let Some(proof) = run.stage(Stage::Proofs, || infeasibility::prove(scene, net_length))? {
        return Err(PlanError::Infeasible {
            proof: proof.message,
        });
    }
    let world = run.stage(Stage::World, || World::new(scene, net_length))??;
    let order = run.stage(Stage::Order, || order_of(&world, scene, options.order))??;
    let centerline = run.stage(Stage::Centerline, || {
        hybrid_a_star::centerline(&world, scene, &order)
    })??;

    // Baseline, optimise, certify and rehearse, in rounds.
    let course = Course {
        scene,
        net_length,
        world: &world,
        order: &order,
        centerline: &centerline,
        options,
    };
    let (attempt, rehearsal) = course.rehearsed_attempt(&mut run)?;

    let overrides = Overrides {
        net_length: options.net_length.map(|length| match length {
            NetLength::Auto => None,
            NetLength::Fixed(length) => Some(length),
        }),
    };
    let candidate = Candidate {
        net_length: attempt.net_length,
        trajectory: &attempt.trajectory,
        scene: Some(reference),
        overrides: &overrides,
    };
    Ok(Planned {
        plan: Plan {
            net_length: attempt.net_length,
            certificate: check(scene, reference, &candidate),
            cost: evaluate(scene, &attempt.trajectory, attempt.net_length),
            scene: reference.clone(),
            overrides,
            circles: world.circles,
            order,
            centerline,
            baseline: attempt.baseline,
            trajectory: attempt.trajectory,
            rehearsal: rehearsal
                .as_ref()
                .map_or(Rehearsal::Skipped, |record| record.verdict.clone()),
            solver: attempt.solver,
            warnings: attempt.warnings,
        },
        rehearsal,
        stages: run.stages,
    })
}

/// The visiting order by a method.
pub(crate) fn order_of(
    world: &World,
    scene: &Scene,
    method: OrderMethod,
) -> Result<Vec<usize>, RouteError> {
    match method {
        OrderMethod::Shortest => visiting_order(world, scene),
        OrderMethod::Given => {
            let mut order: Vec<usize> = (0..world.circles.len()).collect();
            order.sort_by_key(|&circle| world.circles[circle].objects.iter().min().copied());
            Ok(order)
        }
    }
}
