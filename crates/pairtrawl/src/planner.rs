//! Planning again when the scene has changed.

use crate::attempt::{Course, Origin};
use crate::error::PlanError;
use crate::observer::Observer;
use crate::options::{NetLength, PlanOptions};
use crate::plan::{Planned, from_nothing, plan, rehearsed};
use crate::prepare::{Prepared, prepare};
use crate::run::Run;
use pairtrawl_geometry::Segment;
use pairtrawl_model::{PairTrajectory, Plan, Scene, SceneReference, Warning};

/// Fewest waypoints that are worth a warm start.
const FEWEST: usize = 8;

/// Plans, and plans again when a scene has changed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Planner {
    /// Options of planning.
    pub options: PlanOptions,
}

impl Planner {
    /// A planner with options.
    pub fn new(options: PlanOptions) -> Self {
        Self { options }
    }

    /// Plans a scene from nothing, as [`plan`](crate::plan()).
    ///
    /// # Errors
    /// As [`plan`](crate::plan()).
    pub fn plan(
        &self,
        scene: &Scene,
        reference: &SceneReference,
        observer: &mut dyn Observer,
    ) -> Result<Planned, PlanError> {
        plan(scene, reference, &self.options, observer)
    }

    /// Plans a scene that has changed since `before` was planned: an obstacle moved by centimeters, an object was found
    /// within the band, the robots are off the plan or on their way. The new scene starts where the robots are and lists
    /// what is still to be gathered.
    ///
    /// `passed` is the last waypoint of `before` that the pair has passed: 0 before it sets out, later
    /// [`Plan::waypoint_at`] the time of the drive. It is not told from the robots' places, since a way may pass the same
    /// place twice. The net keeps the length that it has in `before`, whatever the options say: it is in tow.
    ///
    /// The optimization starts from the waypoints ahead. Where no certified plan follows from them, the scene is planned
    /// from nothing, and a warning says so.
    ///
    /// # Errors
    /// As [`plan`](crate::plan()).
    pub fn replan(
        &self,
        before: &Plan,
        passed: usize,
        scene: &Scene,
        reference: &SceneReference,
        observer: &mut dyn Observer,
    ) -> Result<Planned, PlanError> {
        let options = PlanOptions {
            net_length: Some(NetLength::Fixed(before.net_length)),
            ..self.options.clone()
        };
        let mut run = Run::new(&options, observer);
        let prepared = prepare(scene, &options, &mut run)?;
        let ahead = before.trajectory.from_waypoint(passed);
        if ahead.len() >= FEWEST {
            match warm(&prepared, &ahead, reference, &mut run) {
                Err(PlanError::NoPlan(_)) => run.round += 1,
                ended => return ended,
            }
        }
        let mut planned = from_nothing(&prepared, reference, run)?;
        planned.plan.warnings.push(Warning::PlannedFromNothing);
        Ok(planned)
    }
}

/// Plans from the rest of an earlier plan, in m.
fn warm(
    prepared: &Prepared,
    ahead: &PairTrajectory,
    reference: &SceneReference,
    run: &mut Run,
) -> Result<Planned, PlanError> {
    let ahead = prepared.scales.scaled_trajectory(ahead);
    let net_length = prepared.net_length.unwrap_or_default();
    let order = swept_order(prepared, &ahead);
    let course = Course::new(prepared, &order);
    let (attempt, rehearsal) = rehearsed(&course, &Origin::Before(&ahead, net_length), run)?;
    Ok(Planned {
        plan: attempt.into_plan(&course, reference, rehearsal.as_ref()),
        rehearsal,
        stages: run.stages.clone(),
    })
}

/// The circles in the order in which the line between the robots comes nearest to them.
fn swept_order(prepared: &Prepared, pair: &PairTrajectory) -> Vec<usize> {
    let circles = &prepared.world.circles;
    let nearest = |circle: usize| {
        let distance = |i: &usize| {
            let line = Segment::new(pair.left[*i].position(), pair.right[*i].position());
            line.distance(circles[circle].center)
        };
        (0..pair.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
    };
    let mut order: Vec<usize> = (0..circles.len()).collect();
    order.sort_by_key(|&circle| nearest(circle));
    order
}
