//! Several starts, optimized in parallel; the best one comes first. The result does not depend on the number of threads.

use crate::starts::{Start, Starts};
use crate::{Method, PlanOptions};
use pairtrawl_model::{PairTrajectory, Scene, SolverStatus};
use pairtrawl_route::with_lead;
use pairtrawl_trajopt::{Problem, Settings, Solution, optimize};
use pairtrawl_world::World;
use rayon::prelude::*;

/// How a baseline is varied.
#[derive(Clone, Copy, Debug)]
enum Variation {
    /// The left robot is this many waypoints ahead.
    Lead(f64),
    /// This robot is optimized first, the other one held where it is, and then the other one: a round of Algorithm 1.
    First(usize),
}

const VARIATIONS: [Variation; 6] = [
    Variation::Lead(-10.0),
    Variation::Lead(-5.0),
    Variation::Lead(5.0),
    Variation::Lead(10.0),
    Variation::First(0),
    Variation::First(1),
];
/// Baselines are varied of orders that cost at most this many times the least.
const WORTH_VARYING: f64 = 1.02;
/// Waypoints of a course beyond which nothing is varied: it would take longer than everything else.
const MOST_WAYPOINTS: usize = 5000;

/// A start, and what the optimum from there costs; infinite when there is none.
struct Explored {
    start: Start,
    objective: f64,
}

/// Puts the visiting order that leads to the least cost first, and before it the variation that betters it most.
pub(crate) fn explore(starts: &mut Starts, world: &World, scene: &Scene, options: &PlanOptions) {
    if !options.explore || options.method != Method::Joint {
        return;
    }
    let problem = Problem::new(scene, options.net_length_for(scene), &world.pieces);
    let (orders, _) = starts.list.split_at_mut(starts.explored);
    let mut ranked: Vec<(Explored, Option<PairTrajectory>)> = orders
        .par_iter()
        .map(|start| {
            let first = start.baseline(world, scene, options).ok();
            let cost = |first| optimum(&problem, first).map(|s| s.objective);
            let objective = first.as_ref().and_then(cost).unwrap_or(f64::INFINITY);
            let start = start.clone();
            (Explored { start, objective }, first)
        })
        .collect();
    // Stable: equal costs keep the shorter way first.
    ranked.sort_by(|a, b| a.0.objective.total_cmp(&b.0.objective));
    for (slot, (order, _)) in orders.iter_mut().zip(&ranked) {
        *slot = order.start.clone();
    }
    let Some(least) = ranked.first().map(|(order, _)| order.objective) else {
        return;
    };
    let varied: Vec<(&Start, &PairTrajectory, Variation)> = ranked
        .iter()
        .filter(|(order, _)| order.objective <= WORTH_VARYING * least)
        .filter_map(|(order, first)| Some((&order.start, first.as_ref()?)))
        .filter(|(_, first)| first.len() <= MOST_WAYPOINTS)
        .flat_map(|(start, first)| VARIATIONS.map(|variation| (start, first, variation)))
        .collect();
    let better = varied
        .par_iter()
        .filter_map(|&(start, first, variation)| variation.explored(&problem, start, first))
        .collect::<Vec<_>>()
        .into_iter()
        .filter(|varied| varied.objective < least)
        .min_by(|a, b| a.objective.total_cmp(&b.objective));
    if let Some(better) = better {
        starts.list.insert(0, better.start);
    }
}

impl Variation {
    /// The start with this variation of its baseline.
    fn explored(
        self,
        problem: &Problem,
        start: &Start,
        baseline: &PairTrajectory,
    ) -> Option<Explored> {
        let pair = match self {
            Self::Lead(lead) => with_lead(baseline, lead),
            Self::First(robot) => {
                let mut one = problem.clone();
                one.frozen = Some(1 - robot);
                let first = optimize(&one, baseline, &Settings::default());
                one.frozen = Some(robot);
                optimize(&one, &first.trajectory, &Settings::default()).trajectory
            }
        };
        let objective = optimum(problem, &pair)?.objective;
        let start = Start {
            pair: Some(pair),
            ..start.clone()
        };
        Some(Explored { start, objective })
    }
}

/// The optimum from a pair, unless there is none.
fn optimum(problem: &Problem, pair: &PairTrajectory) -> Option<Solution> {
    let solution = optimize(problem, pair, &Settings::default());
    (solution.status == SolverStatus::Converged).then_some(solution)
}
