//! A scene before it is planned.

use crate::error::PlanError;
use crate::infeasible::Infeasible;
use crate::options::PlanOptions;
use crate::prepare::proofs;
use crate::summary::summarize_scene;
use pairtrawl_model::{Circle, Scene};
use pairtrawl_model::{Scales, Summary};
use pairtrawl_route::visiting_orders;
use pairtrawl_world::{World, WorldError};

/// What is known of a scene before it is planned.
#[derive(Clone, Debug, PartialEq)]
pub struct Preview {
    /// Proofs that there is no plan, or none that gathers everything; none where nothing is known against the scene.
    pub infeasible: Option<Infeasible>,
    /// Everything that a picture shows: the scene, circles and their shortest visiting order, the objects marked that cannot
    /// be swept. It has no trajectory.
    pub summary: Summary,
}

/// Looks at a scene: proofs, circles, the shortest visiting order.
///
/// # Errors
/// When the scene is no input for the planner.
pub fn preview(scene: &Scene, options: &PlanOptions) -> Result<Preview, PlanError> {
    let net_length = options.net_length_for(scene);
    let infeasible = proofs(scene, options);
    let marked = match &infeasible {
        Some(infeasible) => scene.leaving(infeasible.objects()),
        None => scene.clone(),
    };
    let (circles, order) = circles(&marked, net_length)?;
    let mut summary = summarize_scene(&marked, net_length, infeasible.as_ref());
    summary.circles = circles;
    summary.order = order;
    Ok(Preview {
        infeasible,
        summary,
    })
}

/// Circles, in m, and their shortest visiting order; no order where none leads to all of them.
fn circles(
    scene: &Scene,
    net_length: Option<f64>,
) -> Result<(Vec<Circle>, Vec<usize>), WorldError> {
    let scales = Scales::of(scene);
    let scaled = scales.scene(scene);
    let net_length = net_length.map(|length| scales.scaled(length));
    let world = World::new(&scaled, net_length).map_err(|error| error.in_meters(scales.length))?;
    let circles = world.circles.iter().map(|c| scales.circle(c)).collect();
    let orders = visiting_orders(&world, &scaled, 1).unwrap_or_default();
    Ok((circles, orders.into_iter().next().unwrap_or_default()))
}
