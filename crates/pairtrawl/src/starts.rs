//! Where attempts at a plan begin, the best place first.

use crate::error::PlanError;
use crate::explore::explore;
use crate::observer::Stage;
use crate::options::OrderMethod;
use crate::prepare::Prepared;
use crate::run::Run;
use crate::start::{Candidates, Start, StartName};
use pairtrawl_route::{RouteError, visiting_order, visiting_orders};
use pairtrawl_world::World;

/// Exploring ends when this share of the time limit is over: what it has found by then is planned from.
const EXPLORING: f64 = 0.4;

/// The starts of a scene, the one that leads to the least cost first.
pub(crate) fn starts(prepared: &Prepared, run: &mut Run) -> Result<Vec<Start>, PlanError> {
    let candidates = run
        .stage(Stage::Order, || candidates(prepared))?
        .map_err(|error| prepared.route_error(error))?;
    run.stage_until(EXPLORING, Stage::Explore, |may_go_on| {
        explore(candidates, prepared, may_go_on)
    })
}

/// Visiting orders from the shortest way on, then the shortest by RRT*, then the scene's own order. Whatever the user fixed
/// stays fixed.
fn candidates(prepared: &Prepared) -> Result<Candidates, RouteError> {
    let (options, world) = (prepared.options, &prepared.world);
    let (orders, last) = match options.order {
        OrderMethod::Given => (vec![given(world)], None),
        OrderMethod::Shortest => (
            visiting_orders(world, &prepared.scaled, options.orders.max(1))?,
            Some(given(world)),
        ),
    };
    let methods = options.centerline_methods();
    let mut starts: Vec<Start> = Vec::new();
    let mut add = |start: Start| {
        if !starts.iter().any(|other| other.is_same_way(&start)) {
            starts.push(start);
        }
    };
    for (rank, order) in orders.iter().enumerate() {
        let name = StartName::Ranked(rank + 1);
        add(Start::new(order.clone(), methods[0], name));
    }
    // It takes longer than all the rest, and may pass obstacles on other sides.
    for &method in &methods[1..] {
        add(Start::new(orders[0].clone(), method, StartName::Ranked(1)));
    }
    if let Some(order) = last {
        add(Start::new(order, methods[0], StartName::SceneOrder));
    }
    let explored = orders.len();
    Ok(Candidates { starts, explored })
}

/// The one start along the shortest way that keeps away from closed places.
pub(crate) fn shortest(prepared: &Prepared) -> Result<Start, RouteError> {
    let (options, world) = (prepared.options, &prepared.world);
    let order = match options.order {
        OrderMethod::Given => given(world),
        OrderMethod::Shortest => visiting_order(world, &prepared.scaled)?,
    };
    let method = options.centerline_methods()[0];
    let name = match world.closed.len() {
        0 => StartName::Ranked(1),
        places => StartName::Around(places),
    };
    Ok(Start::new(order, method, name))
}

/// The circles in the order in which the scene lists their first objects.
fn given(world: &World) -> Vec<usize> {
    let mut order: Vec<usize> = (0..world.circles.len()).collect();
    order.sort_by_key(|&circle| world.circles[circle].objects.iter().min().copied());
    order
}
