use crate::run::Run;
use crate::{CenterlineMethod, OrderMethod, PlanError, PlanOptions, Stage};
use pairtrawl_geometry::Pose;
use pairtrawl_model::{PairTrajectory, Scene, SolverStatus};
use pairtrawl_route::{RouteError, baseline, hybrid_a_star, rrt_star, visiting_orders};
use pairtrawl_trajopt::{Problem, Settings, evaluate, optimize};
use pairtrawl_world::World;
use rayon::prelude::*;

/// Samples for each leg of an RRT* centerline.
const SAMPLES: usize = 3000;

/// Where an attempt begins: a visiting order and the way in which the centerline along it is searched.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Start {
    /// Indices of circles.
    pub order: Vec<usize>,
    method: CenterlineMethod,
    /// What it takes, for people.
    pub name: String,
}

/// The starts to try one after another, the best first, never empty: visiting orders in rising cost, then in rising length
/// by RRT*, then the scene's own order. Whatever the user fixed stays fixed.
pub(crate) fn starts(
    world: &World,
    scene: &Scene,
    options: &PlanOptions,
) -> Result<Vec<Start>, RouteError> {
    let (orders, last) = match options.order {
        OrderMethod::Given => (vec![given(world)], None),
        OrderMethod::Shortest => (
            visiting_orders(world, scene, options.orders.max(1))?,
            Some(given(world)),
        ),
    };
    let methods = match options.centerline {
        Some(method) => vec![method],
        None => vec![CenterlineMethod::HybridAStar, CenterlineMethod::RrtStar],
    };
    let mut starts: Vec<Start> = Vec::new();
    let mut add = |order: &[usize], method: CenterlineMethod, name: String| {
        if !starts
            .iter()
            .any(|s| s.order == order && s.method == method)
        {
            starts.push(Start {
                order: order.to_vec(),
                method,
                name,
            });
        }
    };
    for method in &methods {
        for (rank, order) in orders.iter().enumerate() {
            let name = method.name();
            add(
                order,
                *method,
                format!("visiting order {} and a centerline by {name}", rank + 1),
            );
        }
    }
    if let (Some(order), Some(method)) = (last, methods.first()) {
        add(&order, *method, "the scene's own order".to_owned());
    }
    let explored = orders.len();
    rank_by_cost(&mut starts[..explored], world, scene, options);
    Ok(starts)
}

/// Puts the starts that lead to the least cost first: each is optimized once, in parallel. Those without a solution keep
/// their places behind.
fn rank_by_cost(starts: &mut [Start], world: &World, scene: &Scene, options: &PlanOptions) {
    if starts.len() < 2 {
        return;
    }
    let net_length = options.net_length_for(scene);
    let given = options.waypoints.or(scene.planner.waypoints);
    let cost = |start: &Start| -> Option<f64> {
        let line = start.centerline(world, scene, options.seed).ok()?;
        let first = baseline(world, scene, &line, &start.order, given).ok()?;
        let problem = Problem::new(scene, net_length, &world.pieces);
        let solution = optimize(&problem, &first, &Settings::default());
        (solution.status == SolverStatus::Converged)
            .then(|| evaluate(scene, &solution.trajectory, solution.net_length).total())
    };
    let costs: Vec<Option<f64>> = starts.par_iter().map(cost).collect();
    let mut ranked: Vec<(f64, Start)> = costs
        .into_iter()
        .map(|cost| cost.unwrap_or(f64::INFINITY))
        .zip(starts.iter().cloned())
        .collect();
    // Stable: equal costs keep the shorter way first.
    ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (slot, (_, start)) in starts.iter_mut().zip(ranked) {
        *slot = start;
    }
}

/// What studies over the net length have in common: the same start for every length.
pub(crate) struct CommonStart {
    pub world: World,
    pub order: Vec<usize>,
    pub centerline: Vec<Pose>,
    pub baseline: PairTrajectory,
}

impl CommonStart {
    /// The first start of a scene whose net length is open.
    pub fn new(scene: &Scene, options: &PlanOptions, run: &mut Run) -> Result<Self, PlanError> {
        let world = run.stage(Stage::World, || World::new(scene, None))??;
        let starts = run.stage(Stage::Order, || starts(&world, scene, options))??;
        let start = starts.into_iter().next().ok_or_else(PlanError::no_start)?;
        let centerline = run.stage(Stage::Centerline, || {
            start.centerline(&world, scene, options.seed)
        })??;
        let given = options.waypoints.or(scene.planner.waypoints);
        let baseline = run.stage(Stage::Baseline, || {
            baseline(&world, scene, &centerline, &start.order, given)
        })??;
        Ok(Self {
            world,
            order: start.order,
            centerline,
            baseline,
        })
    }
}

impl Start {
    /// The pair's centerline from here.
    pub fn centerline(
        &self,
        world: &World,
        scene: &Scene,
        seed: u64,
    ) -> Result<Vec<Pose>, RouteError> {
        match self.method {
            CenterlineMethod::HybridAStar => hybrid_a_star::centerline(world, scene, &self.order),
            CenterlineMethod::RrtStar => {
                rrt_star::centerline(world, scene, &self.order, seed, SAMPLES)
            }
        }
    }
}

/// The circles in the order in which the scene lists their first objects.
fn given(world: &World) -> Vec<usize> {
    let mut order: Vec<usize> = (0..world.circles.len()).collect();
    order.sort_by_key(|&circle| world.circles[circle].objects.iter().min().copied());
    order
}
