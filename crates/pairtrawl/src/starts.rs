use crate::explore::explore;
use crate::run::Run;
use crate::{CenterlineMethod, OrderMethod, PlanError, PlanOptions, Stage};
use pairtrawl_geometry::Pose;
use pairtrawl_model::{PairTrajectory, Scales, Scene};
use pairtrawl_route::{RouteError, baseline, hybrid_a_star, rrt_star, visiting_orders};
use pairtrawl_world::World;

/// Samples for each leg of an RRT* centerline.
const SAMPLES: usize = 3000;

/// Where an attempt begins: a visiting order and the way in which the centerline along it is searched.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Start {
    /// Indices of circles.
    pub order: Vec<usize>,
    method: CenterlineMethod,
    /// The centerline, once it is found.
    line: Option<Vec<Pose>>,
    /// The pair to begin with instead of the baseline.
    pub pair: Option<PairTrajectory>,
    /// What it takes, for people.
    pub name: String,
}

/// Starts to try one after another.
pub(crate) struct Starts {
    /// Never empty.
    pub list: Vec<Start>,
    /// So many of the first ones are worth comparing.
    pub explored: usize,
}

/// The starts of a scene: visiting orders in rising length, then the same by RRT*, then the scene's own order. Whatever the
/// user fixed stays fixed.
pub(crate) fn starts(
    world: &World,
    scene: &Scene,
    options: &PlanOptions,
) -> Result<Starts, RouteError> {
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
                line: None,
                pair: None,
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
    // The orders, and the shortest one along the way that RRT* finds, which may pass obstacles on other sides.
    let explored = orders.len() + methods.len() - 1;
    Ok(Starts {
        explored,
        list: starts,
    })
}

/// What studies over the net length have in common: the same start for every length.
pub(crate) struct CommonStart {
    pub scales: Scales,
    /// The scene in units of the length scale, as everything below.
    pub scaled: Scene,
    pub world: World,
    pub order: Vec<usize>,
    pub centerline: Vec<Pose>,
    /// What is optimized from.
    pub pair: PairTrajectory,
}

impl CommonStart {
    /// The start that is best with the net length open.
    pub fn new(scene: &Scene, options: &PlanOptions, run: &mut Run) -> Result<Self, PlanError> {
        let scales = Scales::of(scene);
        let scaled = scales.scene(scene);
        let world = run
            .stage(Stage::World, || World::new(&scaled, None))?
            .map_err(|error| error.in_meters(scales.length))?;
        let mut starts = run
            .stage(Stage::Order, || starts(&world, &scaled, options))?
            .map_err(|error| error.in_meters(scales.length))?;
        run.stage(Stage::Explore, || {
            explore(&mut starts, &world, &scaled, None, options);
        })?;
        let start = starts
            .list
            .into_iter()
            .next()
            .ok_or_else(PlanError::no_start)?;
        let centerline = run
            .stage(Stage::Centerline, || {
                start.centerline(&world, &scaled, options.seed)
            })?
            .map_err(|error| error.in_meters(scales.length))?;
        let given = options.waypoints.or(scene.planner.waypoints);
        let pair = match start.pair {
            Some(pair) => pair,
            None => run
                .stage(Stage::Baseline, || {
                    baseline(&world, &scaled, &centerline, &start.order, given)
                })?
                .map_err(|error| error.in_meters(scales.length))?,
        };
        Ok(Self {
            scales,
            scaled,
            world,
            order: start.order,
            centerline,
            pair,
        })
    }
}

impl Start {
    /// The baseline pair from here.
    pub fn baseline(
        &self,
        world: &World,
        scene: &Scene,
        options: &PlanOptions,
    ) -> Result<PairTrajectory, RouteError> {
        let line = self.centerline(world, scene, options.seed)?;
        let given = options.waypoints.or(scene.planner.waypoints);
        baseline(world, scene, &line, &self.order, given)
    }

    /// The same with its centerline found, where there is one: it need not be searched again.
    pub fn with_line(&self, world: &World, scene: &Scene, seed: u64) -> Self {
        Self {
            line: self.centerline(world, scene, seed).ok(),
            ..self.clone()
        }
    }

    /// The same beginning with another pair than its baseline.
    pub fn with_pair(&self, pair: PairTrajectory) -> Self {
        Self {
            pair: Some(pair),
            ..self.clone()
        }
    }

    /// The pair's centerline from here.
    pub fn centerline(
        &self,
        world: &World,
        scene: &Scene,
        seed: u64,
    ) -> Result<Vec<Pose>, RouteError> {
        if let Some(line) = &self.line {
            return Ok(line.clone());
        }
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
