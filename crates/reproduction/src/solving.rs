//! Optimization alone, without certificate and rehearsal: for variants of the problem whose solutions are no plans.

use crate::lab::Stopped;
use pairtrawl::model::{Cost, PairTrajectory, Scene, SolverStatus};
use pairtrawl::trajopt::{Problem, SeparationRule, Settings, Solution, evaluate, optimize};
use pairtrawl::world::World;
use pairtrawl_route::{baseline, hybrid_a_star, visiting_order};

/// What is asked of the separation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// The U-shaped cost.
    UShape,
    /// Nothing (the paper's baseline 1).
    None,
    /// d = d_rest all along (the paper's baseline 2).
    Rigid,
}

/// A scene of the default machine with a pair of trajectories to optimize from.
#[derive(Clone, Debug)]
pub struct Start {
    /// The scene.
    pub scene: Scene,
    /// Its obstacles and circles.
    pub world: World,
    /// The pair.
    pub pair: PairTrajectory,
}

/// What an optimization found.
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    /// d_max, m; without a rule for the separation the net that the pair needs.
    pub net_length: f64,
    /// J of the scene.
    pub cost: Cost,
    /// Both trajectories.
    pub trajectory: PairTrajectory,
    /// Why it does not count; `None`: it does.
    pub refused: Option<String>,
}

impl Start {
    /// The baseline pair through the shortest order, as many waypoints as its length asks for.
    ///
    /// # Errors
    /// When there is no way.
    pub fn of(scene: &Scene) -> Result<Self, Stopped> {
        let no_way = |error: &dyn std::fmt::Display| Stopped::failed(&scene.name, error);
        let world = World::new(scene, None).map_err(|e| no_way(&e))?;
        let order = visiting_order(&world, scene).map_err(|e| no_way(&e))?;
        let line = hybrid_a_star::centerline(&world, scene, &order).map_err(|e| no_way(&e))?;
        let pair = baseline(&world, scene, &line, &order, None).map_err(|e| no_way(&e))?;
        Ok(Self {
            scene: scene.clone(),
            world,
            pair,
        })
    }

    /// Optimizes with the parameters of a scene that differs from the start's in nothing else; `length` is d_max, m,
    /// `None`: free.
    pub fn solve(&self, scene: &Scene, rule: Rule, length: Option<f64>) -> Solved {
        let mut problem = Problem::new(scene, length, &self.world.pieces);
        match (rule, length) {
            (Rule::Rigid, Some(length)) => {
                problem = problem.with_rigid_separation(self.pair.len(), length);
            }
            (Rule::None, _) => problem.separation = SeparationRule::Free,
            _ => {}
        }
        let solution = optimize(&problem, &self.pair, &Settings::default());
        let needed = needed_length(&solution.trajectory, scene.robot.hitch);
        let net_length = match rule {
            Rule::None => needed,
            _ => solution.net_length,
        };
        Solved {
            net_length,
            cost: evaluate(scene, &solution.trajectory, net_length),
            refused: refused(&solution),
            trajectory: solution.trajectory,
        }
    }
}

/// Why a solution does not count.
fn refused(solution: &Solution) -> Option<String> {
    let worst = solution.violations.first().map(|violation| {
        format!(
            "{} fails by {} at waypoint {}",
            violation.claim,
            pairtrawl::model::numbers::quantity(violation.amount, violation.claim.unit()),
            violation.step
        )
    });
    let unsolved = || {
        let solved = solution.status == SolverStatus::Converged;
        (!solved).then(|| solution.status.describe().to_owned())
    };
    worst.or_else(unsolved)
}

/// The net that reaches between axles and between hitches at every waypoint, m.
pub fn needed_length(pair: &PairTrajectory, hitch: f64) -> f64 {
    (0..pair.len())
        .map(|i| {
            let both = pair.pair(i);
            let hitches = [both.left, both.right].map(|pose| pose.hitch_point(hitch));
            both.separation().max(hitches[0].distance(hitches[1]))
        })
        .fold(0.0, f64::max)
}
