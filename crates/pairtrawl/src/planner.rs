//! Planning again when the scene has changed.

use crate::error::PlanError;
use crate::observer::Observer;
use crate::options::{NetLength, PlanOptions};
use crate::plan::{Planned, from_before, from_nothing, plan};
use crate::prepare::prepare;
use crate::run::Run;
use pairtrawl_model::{Plan, Scene, SceneReference, Warning};

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
            match from_before(&prepared, &ahead, before.net_length, reference, &mut run) {
                Err(PlanError::NoPlan(_)) => run.round += 1,
                ended => return ended,
            }
        }
        let mut planned = from_nothing(&prepared, reference, run)?;
        planned.plan.warnings.push(Warning::PlannedFromNothing);
        Ok(planned)
    }
}
