//! The paper's Algorithm 1: robots are optimized in turn, the other held where it is, the net length with each.

use crate::cost::evaluate;
use crate::merit::Residuals;
use crate::optimize::{Solution, first_net_length, optimize_from};
use crate::problem::Problem;
use crate::settings::Settings;
use pairtrawl_model::{PairTrajectory, Scene, Side, SolverStatus};

/// Which net length Algorithm 1 starts from, when it is free.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FirstLength {
    /// That of the joint problem: the start's separation at rest.
    #[default]
    Bounded,
    /// As printed: `N dL_max`, many times what the task needs.
    Printed,
}

/// What the rounds led to.
#[derive(Clone, Debug)]
pub struct Alternation {
    /// After the last round; iterations are summed.
    pub solution: Solution,
    /// J_total after each round.
    pub costs: Vec<f64>,
    /// d_max after each round, m.
    pub net_lengths: Vec<f64>,
}

/// Runs Algorithm 1 for `scene.planner.alternations` rounds on the costs and constraints of the joint problem, the left
/// robot first. A round that is stopped by `go_on` (iterations, residuals) ends it.
pub fn alternate(
    scene: &Scene,
    problem: &Problem,
    start: &PairTrajectory,
    first_length: FirstLength,
    settings: &Settings,
    go_on: &mut dyn FnMut(usize, &Residuals) -> bool,
) -> Alternation {
    let mut problem = problem.clone();
    let mut net_length = problem.net_length.unwrap_or(match first_length {
        FirstLength::Printed => start.len() as f64 * problem.planner.max_step,
        FirstLength::Bounded => first_net_length(&problem, start),
    });
    let (mut costs, mut net_lengths) = (Vec::new(), Vec::new());
    let mut pair = start.clone();
    let mut iterations = 0;
    let mut last = None;
    for round in 0..scene.planner.alternations.max(1) {
        problem.frozen = Some(Side::BOTH[1 - round % 2]);
        let mut solution = optimize_from(&problem, &pair, net_length, settings, go_on);
        iterations += solution.iterations;
        solution.iterations = iterations;
        pair.clone_from(&solution.trajectory);
        net_length = solution.net_length;
        costs.push(evaluate(scene, &pair, net_length).total());
        net_lengths.push(net_length);
        let stopped = solution.status == SolverStatus::TimeLimit;
        last = Some(solution);
        if stopped {
            break;
        }
    }
    let solution =
        last.unwrap_or_else(|| optimize_from(&problem, &pair, net_length, settings, go_on));
    Alternation {
        solution,
        costs,
        net_lengths,
    }
}
