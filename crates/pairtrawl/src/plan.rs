//! Planning on one page: every step by name, and the three loops that try again.
//!
//! `prepare` (proofs, scales, world) -> `starts` (visiting orders, explored) -> for each start its centerline, then
//! `rehearsed` { `certified` { `attempt`: baseline -> optimize -> certify } -> rehearse } -> plan.

use crate::attempt::{Attempt, Course, Origin};
use crate::detour::{DETOURS, closing_where_stuck};
use crate::error::PlanError;
use crate::leave_more::{leave_more, not_found, swept_anyway};
use crate::no_plan::NoPlan;
use crate::not_found::{NotFound, Tried};
use crate::observer::{Observer, Stage};
use crate::options::{PlanOptions, RehearsalMode};
use crate::prepare::{Prepared, prepare};
use crate::run::Run;
use crate::start::Start;
use crate::starts::{shortest, starts};
use crate::tighten::Tightening;
use pairtrawl_model::{
    LeftOut, PairTrajectory, Plan, Rehearsal, RehearsalRecord, Scene, SceneReference, StageTime,
};
use std::borrow::Cow;

/// More rounds in a row that mend nothing are not made, and the share of a miss that is left where a round mends something.
const MOST_IN_VAIN: usize = 1;
const GAIN: f64 = 0.7;

/// A plan, and what came to light while it was made.
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
    let prepared = prepare(scene, options, &mut run)?;
    from_nothing(&prepared, reference, run)
}

/// Plans a prepared scene from its starts; without what is in the way when none leads to a plan.
pub(crate) fn from_nothing(
    prepared: &Prepared,
    reference: &SceneReference,
    mut run: Run,
) -> Result<Planned, PlanError> {
    match from_starts(prepared, reference, &mut run) {
        Err(PlanError::NoPlan(refused)) => leave_more(prepared, refused, &mut run, |rest, run| {
            let planned = from_shortest(rest, reference, run)?;
            let planned = take_back(prepared, planned, reference, run)?;
            let left = not_found(&planned.plan).map(|left| left.object).collect();
            Ok((planned, left))
        }),
        other => other,
    }
}

/// What a plan sweeps although it was left is gathered after all: the same plan, optimized with it.
fn take_back(
    prepared: &Prepared,
    mut planned: Planned,
    reference: &SceneReference,
    run: &mut Run,
) -> Result<Planned, PlanError> {
    for object in swept_anyway(&planned.plan, &prepared.scene) {
        let others = not_found(&planned.plan).filter(|left| left.object != object);
        let left: Vec<LeftOut> = others.cloned().collect();
        let fewer = prepared.leaving(&left);
        let before = (&planned.plan.trajectory, planned.plan.net_length);
        match from_before(&fewer, before.0, before.1, reference, run) {
            Ok(more) => planned = more,
            Err(PlanError::NoPlan(_)) => run.round += 1,
            // What is at hand is a plan.
            Err(PlanError::TimeLimit { .. }) => break,
            Err(error) => return Err(error),
        }
    }
    Ok(planned)
}

/// Plans from the waypoints of an earlier plan and its net length, in m.
pub(crate) fn from_before(
    prepared: &Prepared,
    waypoints: &PairTrajectory,
    net_length: f64,
    reference: &SceneReference,
    run: &mut Run,
) -> Result<Planned, PlanError> {
    let waypoints = prepared.scales.scaled_trajectory(waypoints);
    let first_length = prepared.scales.scaled(net_length);
    let net_length = prepared.net_length.unwrap_or(first_length);
    let order = prepared.swept_order(&waypoints);
    let course = Course::new(prepared, &order);
    let (attempt, rehearsal) = rehearsed(&course, &Origin::Before(&waypoints, net_length), run)?;
    Ok(Planned {
        plan: attempt.into_plan(&course, reference, rehearsal.as_ref()),
        rehearsal,
        stages: run.stages.clone(),
    })
}

/// Plans a prepared scene from its starts. The best start comes first; the others are tried only while no certified plan is
/// found, after ways around the places where the first one gets stuck.
fn from_starts(
    prepared: &Prepared,
    reference: &SceneReference,
    run: &mut Run,
) -> Result<Planned, PlanError> {
    let starts = starts(prepared, run)?;
    let mut trials = Trials::default();
    for (failed, start) in starts.iter().enumerate() {
        if let Some(planned) = trials.start(prepared, start, reference, run)? {
            return Ok(planned);
        }
        if failed == 0
            && let Some(planned) = trials.around(prepared, reference, run)?
        {
            return Ok(planned);
        }
    }
    Err(PlanError::NoPlan(trials.refused(reference)))
}

/// Plans a prepared scene from the shortest way alone, and along ways around the places where that gets stuck.
fn from_shortest(
    prepared: &Prepared,
    reference: &SceneReference,
    run: &mut Run,
) -> Result<Planned, PlanError> {
    let mut trials = Trials::default();
    let start = run
        .stage(Stage::Order, || shortest(prepared))?
        .map_err(|error| prepared.route_error(error))?;
    if let Some(planned) = trials.start(prepared, &start, reference, run)? {
        return Ok(planned);
    }
    match trials.around(prepared, reference, run)? {
        Some(planned) => Ok(planned),
        None => Err(PlanError::NoPlan(trials.refused(reference))),
    }
}

/// Starts that led to no certified plan.
#[derive(Default)]
struct Trials {
    tried: Vec<Tried>,
    best: Option<Box<NotFound>>,
    latest: Option<Box<NotFound>>,
}

impl Trials {
    /// Plans from one start; `None` when that leads to no certified plan.
    fn start(
        &mut self,
        prepared: &Prepared,
        start: &Start,
        reference: &SceneReference,
        run: &mut Run,
    ) -> Result<Option<Planned>, PlanError> {
        let course = Course::new(prepared, &start.order);
        let line = run.stage(Stage::Centerline, || start.centerline(prepared))?;
        let found = line
            .map_err(|error| prepared.route_error(error))
            .and_then(|line| rehearsed(&course, &Origin::Centerline(&line, start.pair()), run));
        match found {
            Ok((mut attempt, rehearsal)) => {
                if !self.tried.is_empty() {
                    attempt.warn_of_other_start(self.tried.len(), start.name());
                }
                let plan = attempt.into_plan(&course, reference, rehearsal.as_ref());
                Ok(Some(Planned {
                    plan,
                    rehearsal,
                    stages: run.stages.clone(),
                }))
            }
            Err(PlanError::NoPlan(refused)) => {
                self.tried.push(Tried {
                    start: start.name(),
                    missing: refused.missing.clone(),
                });
                if (self.best.as_ref()).is_none_or(|best| refused.is_better_than(best)) {
                    self.best = Some(refused.clone());
                }
                self.latest = Some(refused);
                run.round += 1;
                Ok(None)
            }
            Err(error) => Err(error),
        }
    }

    /// Plans along other ways, which keep away from the places where the latest attempts got stuck.
    fn around(
        &mut self,
        prepared: &Prepared,
        reference: &SceneReference,
        run: &mut Run,
    ) -> Result<Option<Planned>, PlanError> {
        let mut rest = Cow::Borrowed(prepared);
        for _ in 0..DETOURS {
            let latest = self.latest.as_deref();
            let Some(closed) = latest.and_then(|refused| closing_where_stuck(&rest, refused))
            else {
                break;
            };
            rest = Cow::Owned(closed);
            // Nothing is reached any more: what is closed is not only where the attempts got stuck.
            let Ok(start) = run.stage(Stage::Order, || shortest(&rest))? else {
                break;
            };
            if let Some(planned) = self.start(&rest, &start, reference, run)? {
                return Ok(Some(planned));
            }
        }
        Ok(None)
    }

    /// The refusal: the best attempt, and everything that was tried.
    fn refused(self, reference: &SceneReference) -> Box<NotFound> {
        let mut refused = self
            .best
            .unwrap_or_else(|| Box::new(NoPlan::NoStart.into()));
        refused.tried = self.tried;
        if let Some(best) = &mut refused.best {
            best.scene = reference.clone();
        }
        refused
    }
}

/// A certified attempt, and its rehearsal unless that is to be skipped. One whose rehearsal fails is made again with more
/// margin, a bounded number of times; the one with the fewest events counts.
pub(crate) fn rehearsed(
    course: &Course,
    origin: &Origin,
    run: &mut Run,
) -> Result<(Attempt, Option<RehearsalRecord>), PlanError> {
    let options = course.prepared.options;
    let mut tightening = Tightening::NONE;
    let mut best = certified(course, origin, &mut tightening, run)?;
    if options.rehearsal == RehearsalMode::Skip {
        return Ok((best, None));
    }
    let mut record = match course.rehearse(&best, run) {
        Ok(record) => record,
        Err(PlanError::TimeLimit { limit, .. }) if options.rehearsal == RehearsalMode::Report => {
            best.warn_of_time_limit(limit, "it was not rehearsed");
            return Ok((best, None));
        }
        Err(error) => return Err(error),
    };
    let mut latest = record.clone();
    let mut length = best.net_length;
    for _ in 0..options.rehearsal_rounds {
        let Some(failed) = latest.failures().next() else {
            break;
        };
        run.note(&format!(
            "rehearsal: {}; planning again with more margin",
            failed.kind.describe()
        ));
        let net_length = course.prepared.scales.scaled(length);
        let may_choose = course.prepared.net_length.is_none();
        tightening = tightening.after_event(&failed.kind, net_length, may_choose);
        run.round += 1;
        let next = certified(course, origin, &mut tightening, run)
            .and_then(|next| Ok((course.rehearse(&next, run)?, next)));
        match next {
            Ok((rehearsed, next)) => {
                latest = rehearsed;
                length = next.net_length;
                if latest.failures().count() < record.failures().count() {
                    (best, record) = (next, latest.clone());
                }
            }
            // With more margin there is no plan any more: the one at hand stays.
            Err(PlanError::NoPlan(_)) => break,
            Err(PlanError::TimeLimit { limit, .. }) => {
                best.warn_of_time_limit(limit, "one with more margin was not found in time");
                break;
            }
            Err(error) => return Err(error),
        }
    }
    match (&record.verdict, options.rehearsal) {
        (Rehearsal::Failed { event, time, place }, RehearsalMode::Require) => {
            let missing = NoPlan::RehearsalFails {
                event: event.clone(),
                time: *time,
                place: *place,
            };
            Err(PlanError::NoPlan(Box::new(NotFound {
                best: Some(Box::new(best.into_no_plan(course, Some(&record)))),
                ..missing.into()
            })))
        }
        _ => Ok((best, Some(record))),
    }
}

/// An attempt whose every claim holds: optimizes, certifies, tightens where a claim fails, and tries again within the
/// budget of rounds.
pub(crate) fn certified(
    course: &Course,
    origin: &Origin,
    tightening: &mut Tightening,
    run: &mut Run,
) -> Result<Attempt, PlanError> {
    let prepared = course.prepared;
    let mut best = course.attempt(origin, tightening, run)?;
    let (mut rounds, mut in_vain) = (1, 0);
    while rounds < prepared.options.rounds {
        // Misses that no margin makes up for: another start helps, more rounds do not.
        if best.worst().is_none() || best.is_hopeless(&prepared.scales) || in_vain > MOST_IN_VAIN {
            break;
        }
        *tightening = tightening.after_claims(&best.certificate, &prepared.scales);
        (run.round, rounds) = (run.round + 1, rounds + 1);
        let next = course.attempt(origin, tightening, run)?;
        let misses_by = |attempt: &Attempt| attempt.worst().map_or(0.0, |worst| -worst.margin);
        if next.failures() < best.failures() || misses_by(&next) < GAIN * misses_by(&best) {
            in_vain = 0;
        } else {
            in_vain += 1;
        }
        if next.failures() <= best.failures() {
            best = next;
        }
    }
    match best.worst() {
        None => Ok(best),
        Some(worst) => {
            let missing = course.no_plan(&best, worst, rounds);
            Err(PlanError::NoPlan(Box::new(NotFound {
                best: Some(Box::new(best.into_no_plan(course, None))),
                ..missing.into()
            })))
        }
    }
}
