//! Several starts, optimized in parallel; the best one comes first. The result does not depend on the number of threads.

use crate::starts::{Start, Starts};
use crate::{Method, PlanOptions};
use pairtrawl_model::{PairTrajectory, Scene, Side, SolverStatus};
use pairtrawl_route::with_lead;
use pairtrawl_trajopt::{Problem, Settings, optimize};
use pairtrawl_world::World;
use rayon::prelude::*;

/// How a baseline is varied.
#[derive(Clone, Copy, Debug)]
struct Variation {
    /// The left robot is this far ahead, in units of the length scale.
    lead: f64,
    /// This robot is optimized first, the other one held where it is, and then the other one: a round of Algorithm 1.
    first: Option<Side>,
}

const fn varied(lead: f64, first: Option<Side>) -> Variation {
    Variation { lead, first }
}

const VARIATIONS: [Variation; 10] = [
    varied(-0.5, None),
    varied(-0.25, None),
    varied(0.25, None),
    varied(0.5, None),
    varied(0.0, Some(Side::Left)),
    varied(0.0, Some(Side::Right)),
    varied(-0.5, Some(Side::Left)),
    varied(-0.5, Some(Side::Right)),
    varied(0.5, Some(Side::Left)),
    varied(0.5, Some(Side::Right)),
];
/// Baselines are varied of orders that cost at most this many times the least.
const WORTH_VARYING: f64 = 1.02;
/// Waypoints of all variations together, at most: it would take longer than everything else.
const MOST_WAYPOINTS: usize = 30_000;

/// A start, and what the optimum from there costs; infinite when there is none.
struct Explored {
    start: Start,
    objective: f64,
}

/// Puts the visiting order that leads to the least cost first, and before it the variation that betters it most.
pub(crate) fn explore(
    starts: &mut Starts,
    world: &World,
    scene: &Scene,
    net_length: Option<f64>,
    options: &PlanOptions,
) {
    if !options.explore || options.method != Method::Joint {
        return;
    }
    let problem = Problem::new(scene, net_length, &world.pieces);
    let (orders, _) = starts.list.split_at_mut(starts.explored);
    let mut ranked: Vec<(Explored, Option<PairTrajectory>)> = orders
        .par_iter()
        .map(|start| {
            let start = start.with_line(world, scene, options.seed);
            let first = start.baseline(world, scene, options).ok();
            let least = first.as_ref().and_then(|first| optimum(&problem, first));
            let objective = least.unwrap_or(f64::INFINITY);
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
    let mut left = MOST_WAYPOINTS;
    let mut within_budget = |pair: &PairTrajectory| {
        let rest = left.checked_sub(VARIATIONS.len() * pair.len());
        left = rest.unwrap_or(left);
        rest.is_some()
    };
    let varied: Vec<(&Start, &PairTrajectory, Variation)> = ranked
        .iter()
        .filter(|(order, _)| order.objective <= WORTH_VARYING * least)
        .filter_map(|(order, first)| Some((&order.start, first.as_ref()?)))
        .filter(|(_, first)| within_budget(first))
        .flat_map(|(start, first)| VARIATIONS.map(|variation| (start, first, variation)))
        .collect();
    let better = varied
        .par_iter()
        .filter_map(|&(start, baseline, variation)| variation.explored(&problem, start, baseline))
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
        let mut pair = with_lead(baseline, self.lead, problem.planner.max_step);
        if let Some(robot) = self.first {
            let mut one = problem.clone();
            for held in [robot.other(), robot] {
                one.frozen = Some(held);
                pair = optimize(&one, &pair, &Settings::default()).trajectory;
            }
        }
        let objective = optimum(problem, &pair)?;
        let start = start.with_pair(pair);
        Some(Explored { start, objective })
    }
}

/// What the optimum from a pair costs, unless there is none.
fn optimum(problem: &Problem, pair: &PairTrajectory) -> Option<f64> {
    let solution = optimize(problem, pair, &Settings::default());
    (solution.status == SolverStatus::Converged).then_some(solution.objective)
}
