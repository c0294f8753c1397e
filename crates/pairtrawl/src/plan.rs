//! Planning, on one page of named steps: scene -> world -> order -> explore -> centerline -> baseline -> optimize -> certify ->
//! (rehearse) -> plan.

use crate::attempt::{Course, Origin};
use crate::explore::explore;
use crate::run::Run;
use crate::starts::starts;
use crate::{Observer, PlanError, PlanOptions, Stage, waypoints};
use pairtrawl_certificate::infeasibility;
use pairtrawl_model::{Plan, RehearsalRecord, Scales, Scene, SceneReference, StageTime};
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
    let net_length = options.net_length_for(scene);

    let proof = run.stage(Stage::Proofs, || {
        let scenes = infeasibility::prove(scene, net_length).map(|proof| proof.message);
        scenes.or_else(|| waypoints::too_few(scene, options))
    })?;
    if let Some(proof) = proof {
        return Err(PlanError::Infeasible { proof });
    }
    let scales = Scales::of(scene);
    let scaled = scales.scene(scene);
    let net_length = net_length.map(|length| scales.scaled(length));
    let world = run
        .stage(Stage::World, || World::new(&scaled, net_length))?
        .map_err(|error| error.in_meters(scales.length))?;
    let mut starts = run
        .stage(Stage::Order, || starts(&world, &scaled, options))?
        .map_err(|error| error.in_meters(scales.length))?;
    run.stage(Stage::Explore, || {
        explore(&mut starts, &world, &scaled, net_length, options);
    })?;

    // The best start first; the others only while no certified plan is found.
    let mut refused = None;
    for (failed, start) in starts.list.iter().enumerate() {
        let course = Course {
            scene,
            scales,
            scaled: &scaled,
            net_length,
            world: &world,
            order: &start.order,
            options,
        };
        let attempt = run
            .stage(Stage::Centerline, || {
                start.centerline(&world, &scaled, options.seed)
            })?
            .map_err(|error| PlanError::from(error.in_meters(scales.length)))
            .and_then(|line| {
                course.rehearsed_attempt(&Origin::Centerline(line, start.pair.clone()), &mut run)
            });
        match attempt {
            Ok((attempt, rehearsal)) => {
                let mut plan = attempt.into_plan(&course, reference, rehearsal.as_ref());
                if failed > 0 {
                    plan.warnings.push(format!(
                        "no certified plan was found from {failed} other start(s); this one takes {}",
                        start.name
                    ));
                }
                return Ok(Planned {
                    plan,
                    rehearsal,
                    stages: run.stages,
                });
            }
            Err(error @ PlanError::NoPlan { .. }) => {
                refused.get_or_insert(error);
                run.round += 1;
            }
            Err(error) => return Err(error),
        }
    }
    Err(refused.unwrap_or_else(PlanError::no_start))
}
