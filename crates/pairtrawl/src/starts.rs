use crate::{CenterlineMethod, OrderMethod, PlanOptions};
use pairtrawl_geometry::Pose;
use pairtrawl_model::Scene;
use pairtrawl_route::{RouteError, hybrid_a_star, rrt_star, visiting_orders};
use pairtrawl_world::World;

/// Samples for each leg of an RRT* centerline.
const SAMPLES: usize = 3000;

/// Where an attempt begins: a visiting order and the way in which the centerline along it is searched.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Start {
    /// Indices of circles.
    pub order: Vec<usize>,
    method: CenterlineMethod,
    /// What a person should know when the plan comes from here; empty for the first start.
    pub warning: String,
}

/// The starts to try one after another, the best first, never empty: visiting orders in rising length, then the same by
/// RRT*, then the scene's own order. Whatever the user fixed stays fixed.
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
    let mut add = |order: &[usize], method: CenterlineMethod, what: String| {
        if !starts
            .iter()
            .any(|s| s.order == order && s.method == method)
        {
            let warning = match starts.len() {
                0 => String::new(),
                failed => format!(
                    "no certified plan was found from {failed} other start(s); this one takes {what}"
                ),
            };
            starts.push(Start {
                order: order.to_vec(),
                method,
                warning,
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
    Ok(starts)
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
