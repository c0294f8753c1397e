//! What planning, planning again and the studies over the net length begin with.

use crate::error::PlanError;
use crate::observer::Stage;
use crate::options::PlanOptions;
use crate::run::Run;
use pairtrawl_certificate::infeasibility;
use pairtrawl_model::{Scales, Scene};
use pairtrawl_route::RouteError;
use pairtrawl_world::World;

/// A scene for which no proof rules a plan out, and its world. The stages between here and the certificate see
/// `scaled` and work in units of the length scale; certificate, cost and rehearsal see `scene`, in m.
pub(crate) struct Prepared<'a> {
    pub scene: &'a Scene,
    pub options: &'a PlanOptions,
    pub scales: Scales,
    /// The scene in units of the length scale.
    pub scaled: Scene,
    /// d_max in units of the length scale; `None`: the optimizer chooses it.
    pub net_length: Option<f64>,
    /// Obstacles and circles in units of the length scale.
    pub world: World,
}

/// Looks for proofs that there is no plan, and builds the world.
pub(crate) fn prepare<'a>(
    scene: &'a Scene,
    options: &'a PlanOptions,
    run: &mut Run,
) -> Result<Prepared<'a>, PlanError> {
    let net_length = options.net_length_for(scene);
    let proof = run.stage(Stage::Proofs, || {
        infeasibility::prove(scene, net_length)
            .or_else(|| infeasibility::too_few_waypoints(scene, options.waypoints_for(scene)?))
    })?;
    if let Some(proof) = proof {
        return Err(PlanError::Infeasible(proof));
    }
    let scales = Scales::of(scene);
    let scaled = scales.scene(scene);
    let net_length = net_length.map(|length| scales.scaled(length));
    let world = run
        .stage(Stage::World, || World::new(&scaled, net_length))?
        .map_err(|error| error.in_meters(scales.length))?;
    Ok(Prepared {
        scene,
        options,
        scales,
        scaled,
        net_length,
        world,
    })
}

impl<'a> Prepared<'a> {
    /// The same with a net of this length, m; `None`: free.
    pub fn with_net_length(&self, options: &'a PlanOptions, length: Option<f64>) -> Prepared<'a> {
        Prepared {
            options,
            net_length: length.map(|length| self.scales.scaled(length)),
            scaled: self.scaled.clone(),
            world: self.world.clone(),
            ..*self
        }
    }

    /// A failure of the route in the planner's words, with its places in m.
    pub fn route_error(&self, error: RouteError) -> PlanError {
        error.in_meters(self.scales.length).into()
    }

    /// A length that the optimizer returns, m. One that was given comes back as it was, without rounding.
    pub fn meters(&self, length: f64) -> f64 {
        self.options
            .net_length_for(self.scene)
            .filter(|&given| self.scales.scaled(given) == length)
            .unwrap_or(self.scales.meters(length))
    }
}
