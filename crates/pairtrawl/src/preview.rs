//! A scene before it is planned.

use crate::error::PlanError;
use crate::infeasible::Infeasible;
use crate::options::PlanOptions;
use crate::prepare::{Prepared, proofs};
use crate::summary::summarize_scene;
use pairtrawl_model::{Scene, Summary};
use pairtrawl_route::visiting_orders;
use std::borrow::Cow;

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
    let infeasible = proofs(scene, options);
    let (marked, left_out) = match &infeasible {
        Some(infeasible) => (
            Cow::Owned(scene.leaving(infeasible.objects())),
            infeasible.left_out(),
        ),
        None => (Cow::Borrowed(scene), Vec::new()),
    };
    let prepared = Prepared::new(marked, options, left_out)?;
    let (scales, world) = (&prepared.scales, &prepared.world);
    // No order where none leads to all circles.
    let orders = visiting_orders(world, &prepared.scaled, 1).unwrap_or_default();
    let net_length = options.net_length_for(scene);
    let mut summary = summarize_scene(&prepared.scene, net_length, infeasible.as_ref());
    summary.circles = world.circles.iter().map(|c| scales.circle(c)).collect();
    summary.order = orders.into_iter().next().unwrap_or_default();
    Ok(Preview {
        infeasible,
        summary,
    })
}
