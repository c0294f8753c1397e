use crate::attempt::{Course, Origin};
use crate::run::Run;
use crate::{Observer, PlanError, PlanOptions, Planned, Stage, plan};
use pairtrawl_certificate::infeasibility;
use pairtrawl_model::{PairPose, PairTrajectory, Plan, Scales, Scene, SceneReference};
use pairtrawl_world::World;

/// Fewest waypoints that are worth a warm start.
const FEWEST: usize = 8;

/// Plans, and plans again when a scene has changed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Planner {
    /// How to plan.
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
    /// within the band, the robots are off the plan or on their way (the new scene then starts where they are and lists
    /// what is still to be gathered). The optimization starts from the rest of the old plan. Where no certified plan
    /// follows from that, the scene is planned from nothing, and a warning says so.
    ///
    /// # Errors
    /// As [`plan`](crate::plan()).
    pub fn replan(
        &self,
        before: &Plan,
        scene: &Scene,
        reference: &SceneReference,
        observer: &mut dyn Observer,
    ) -> Result<Planned, PlanError> {
        let options = &self.options;
        let rest = rest_of(&before.trajectory, &scene.start);
        if rest.len() >= FEWEST {
            match warm(before, &rest, scene, reference, options, observer) {
                Err(PlanError::NoPlan { .. }) => {}
                ended => return ended,
            }
        }
        let mut planned = plan(scene, reference, options, observer)?;
        let warning = "no certified plan followed from the one before: planned from nothing";
        planned.plan.warnings.push(warning.to_owned());
        Ok(planned)
    }
}

fn warm(
    before: &Plan,
    rest: &PairTrajectory,
    scene: &Scene,
    reference: &SceneReference,
    options: &PlanOptions,
    observer: &mut dyn Observer,
) -> Result<Planned, PlanError> {
    let mut run = Run::new(options, observer);
    let net_length = options.net_length_for(scene);
    let proof = run.stage(Stage::Proofs, || infeasibility::prove(scene, net_length))?;
    if let Some(proof) = proof {
        return Err(PlanError::Infeasible {
            proof: proof.message,
        });
    }
    let scales = Scales::of(scene);
    let scaled = scales.scene(scene);
    let net_length = net_length.map(|length| scales.scaled(length));
    let world = run
        .stage(Stage::World, || World::new(&scaled, net_length))?
        .map_err(|error| error.in_meters(scales.length))?;
    // The order is told from the old plan only while there are as many circles.
    let order = if before.order.len() == world.circles.len() {
        before.order.clone()
    } else {
        (0..world.circles.len()).collect()
    };
    let course = Course {
        scene,
        scales,
        scaled: &scaled,
        net_length,
        world: &world,
        order: &order,
        options,
    };
    let rest = scales.scaled_trajectory(rest);
    let origin = Origin::Before(&rest, scales.scaled(before.net_length));
    let (attempt, rehearsal) = course.rehearsed_attempt(&origin, &mut run)?;
    let mut plan = attempt.into_plan(&course, reference, rehearsal.as_ref());
    plan.centerline = before.centerline.clone();
    Ok(Planned {
        plan,
        rehearsal,
        stages: run.stages,
    })
}

/// The part of a trajectory that is still ahead of a pair: from the waypoint that is nearest to it.
fn rest_of(trajectory: &PairTrajectory, pair: &PairPose) -> PairTrajectory {
    let off = |i: usize| {
        let at = trajectory.pair(i);
        at.left.position().distance(pair.left.position())
            + at.right.position().distance(pair.right.position())
    };
    let nearest = (0..trajectory.len()).min_by(|a, b| off(*a).total_cmp(&off(*b)));
    let from = nearest.unwrap_or(0);
    PairTrajectory {
        left: trajectory.left[from..].to_vec(),
        right: trajectory.right[from..].to_vec(),
        step_time: trajectory.step_time,
    }
}
