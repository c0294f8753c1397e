use crate::attempt::Course;
use crate::{CenterlineMethod, OrderMethod, PlanOptions};
use pairtrawl_geometry::Pose;
use pairtrawl_model::Scene;
use pairtrawl_route::{RouteError, hybrid_a_star, rrt_star, visiting_orders};
use pairtrawl_world::World;

/// Samples for each leg of an RRT* centerline.
const SAMPLES: usize = 3000;

/// The visiting orders to try, the best first; never empty.
pub(crate) fn orders_of(
    world: &World,
    scene: &Scene,
    options: &PlanOptions,
) -> Result<Vec<Vec<usize>>, RouteError> {
    match options.order {
        OrderMethod::Shortest => visiting_orders(world, scene, options.orders.max(1)),
        OrderMethod::Given => {
            let mut order: Vec<usize> = (0..world.circles.len()).collect();
            order.sort_by_key(|&circle| world.circles[circle].objects.iter().min().copied());
            Ok(vec![order])
        }
    }
}

/// The centerline along an order.
pub(crate) fn centerline_of(course: &Course) -> Result<Vec<Pose>, RouteError> {
    let Course {
        scene,
        world,
        order,
        options,
        ..
    } = *course;
    match options.centerline {
        CenterlineMethod::HybridAStar => hybrid_a_star::centerline(world, scene, order),
        CenterlineMethod::RrtStar => {
            rrt_star::centerline(world, scene, order, options.seed, SAMPLES)
        }
    }
}
