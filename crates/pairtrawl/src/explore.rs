//! Several starts, optimized in parallel; the best one comes first. The result does not depend on the number of threads.

use crate::options::Method;
use crate::prepare::Prepared;
use crate::sampling::weighed;
use crate::start::{Candidates, Start};
use pairtrawl_model::{PairTrajectory, Side, SolverStatus};
use pairtrawl_parallel::prelude::*;
use pairtrawl_route::with_lead;
use pairtrawl_trajopt::{Problem, Settings, optimize_watched};

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
/// Waypoints of everything that is optimized to find the best start, at most: what does not fit is not explored.
const MOST_WAYPOINTS: usize = 20_000;
/// The objective of a start that was not explored: worse than any optimum, better than none.
const UNKNOWN: f64 = f64::MAX;

/// Whether the work may go on; asked from several threads.
type MayGoOn<'a> = &'a (dyn Fn() -> bool + Sync);

/// A start with its baseline, and the cost of the optimum from there; infinite when there is none.
struct Explored {
    start: Start,
    baseline: Option<PairTrajectory>,
    objective: f64,
}

/// The starts, with the visiting order that leads to the least cost first, and before it the variation of a baseline that
/// costs least of all, when it costs less. When the work may not go on, those come first that were optimized by then.
pub(crate) fn explore(
    Candidates {
        mut starts,
        explored,
    }: Candidates,
    prepared: &Prepared,
    may_go_on: MayGoOn,
) -> Vec<Start> {
    let options = prepared.options;
    if !options.explore || options.method != Method::Joint {
        return starts;
    }
    let problem = Problem::new(
        &prepared.scaled,
        prepared.net_length,
        &prepared.world.pieces,
    );
    let (orders, _) = starts.split_at_mut(explored);
    let mut left = MOST_WAYPOINTS;
    let mut fits = |waypoints: usize| {
        let rest = left.checked_sub(waypoints);
        left = rest.unwrap_or(left);
        rest.is_some()
    };
    let lines: Vec<(Start, Option<PairTrajectory>)> = orders
        .par_iter()
        .enumerate()
        .map(|(rank, start)| {
            // The shortest way is needed in any case.
            if rank > 0 && !may_go_on() {
                return (start.clone(), None);
            }
            let start = start.with_line(prepared);
            let baseline = start.baseline(prepared).ok();
            (start, baseline)
        })
        .collect();
    let with_room: Vec<bool> = (lines.iter())
        .map(|(_, baseline)| baseline.as_ref().is_none_or(|pair| fits(pair.len())))
        .collect();
    let mut ranked: Vec<Explored> = lines
        .into_par_iter()
        .zip(with_room)
        .map(|((start, baseline), has_room)| {
            let least = || optimum(&problem, baseline.as_ref()?, may_go_on);
            Explored {
                objective: if has_room {
                    least().unwrap_or(f64::INFINITY)
                } else {
                    UNKNOWN
                },
                start,
                baseline,
            }
        })
        .collect();
    // Stable: equal costs keep the shorter way first.
    ranked.sort_by(|a, b| a.objective.total_cmp(&b.objective));
    for (slot, order) in orders.iter_mut().zip(&ranked) {
        *slot = order.start.clone();
    }
    // Where no order leads to an optimum, more than variations of its baseline has to change.
    let least = ranked.first().map(|order| order.objective);
    let Some(least) = least.filter(|least| least.is_finite()) else {
        return starts;
    };
    let varied: Vec<(&Start, &PairTrajectory, Variation)> = ranked
        .iter()
        .filter(|order| order.objective <= WORTH_VARYING * least)
        .filter_map(|order| Some((&order.start, order.baseline.as_ref()?)))
        .flat_map(|(start, baseline)| VARIATIONS.map(|variation| (start, baseline, variation)))
        .filter(|(_, baseline, variation)| fits(variation.solves() * baseline.len()))
        .collect();
    let better = varied
        .par_iter()
        .filter_map(|&(start, baseline, variation)| {
            let pair = variation.of(baseline, &problem, may_go_on);
            let objective = optimum(&problem, &pair, may_go_on)?;
            Some((start.with_pair(pair), objective))
        })
        .collect::<Vec<_>>()
        .into_iter()
        .filter(|(_, objective)| *objective < least)
        .min_by(|a, b| a.1.total_cmp(&b.1));
    if let Some((start, _)) = better {
        starts.insert(0, start);
    }
    starts
}

impl Variation {
    /// How often a pair is optimized to find what it leads to.
    fn solves(self) -> usize {
        if self.first.is_some() { 3 } else { 1 }
    }

    /// A baseline varied in this way.
    fn of(
        self,
        baseline: &PairTrajectory,
        problem: &Problem,
        may_go_on: MayGoOn,
    ) -> PairTrajectory {
        let mut pair = with_lead(baseline, self.lead, problem.planner.max_step);
        if let Some(robot) = self.first {
            let mut one = problem.clone();
            for held in [robot.other(), robot] {
                one.frozen = Some(held);
                let settings = Settings::default();
                pair = optimize_watched(&one, &pair, &settings, &mut |_, _| may_go_on()).trajectory;
            }
        }
        pair
    }
}

/// The cost of the optimum from a pair, unless there is none.
fn optimum(problem: &Problem, pair: &PairTrajectory, may_go_on: MayGoOn) -> Option<f64> {
    let problem = weighed(problem, pair);
    let solution = optimize_watched(&problem, pair, &Settings::default(), &mut |_, _| {
        may_go_on()
    });
    (solution.status == SolverStatus::Converged).then_some(solution.objective)
}
