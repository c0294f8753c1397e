//! What planning, planning again and the studies over the net length begin with.

use crate::error::PlanError;
use crate::infeasible::Infeasible;
use crate::observer::Stage;
use crate::options::PlanOptions;
use crate::run::Run;
use pairtrawl_certificate::infeasibility;
use pairtrawl_geometry::Segment;
use pairtrawl_model::{Leave, LeftOut, PairTrajectory, Scales, Scene};
use pairtrawl_route::RouteError;
use pairtrawl_world::{World, WorldError};
use std::borrow::Cow;

/// A scene for which no proof rules a plan out, and its world. The stages between here and the certificate see
/// `scaled` and work in units of the length scale; certificate, cost and rehearsal see `scene`, in m.
#[derive(Clone)]
pub(crate) struct Prepared<'a> {
    /// The scene, with the objects marked that are left where they are.
    pub scene: Cow<'a, Scene>,
    pub options: &'a PlanOptions,
    pub scales: Scales,
    /// The scene in units of the length scale.
    pub scaled: Scene,
    /// d_max in units of the length scale; `None`: the optimizer chooses it.
    pub net_length: Option<f64>,
    /// Obstacles and circles in units of the length scale.
    pub world: World,
    /// The objects that are left and why, ascending.
    pub left_out: Vec<LeftOut>,
}

/// The proofs that no plan gathers everything; `None` where there are none.
pub(crate) fn proofs(scene: &Scene, options: &PlanOptions) -> Option<Infeasible> {
    let mut proofs = infeasibility::prove(scene, options.net_length_for(scene));
    if proofs.iter().all(|proof| proof.object().is_some())
        && let Some(waypoints) = options.waypoints_for(scene)
        && let Some(proof) = infeasibility::too_few_waypoints(scene, waypoints)
    {
        proofs.insert(0, proof);
    }
    (!proofs.is_empty()).then(|| Infeasible {
        proofs,
        wanted: scene.wanted(),
    })
}

/// Looks for proofs that there is no plan, leaves the objects that cannot be swept where the options say so, and builds the
/// world.
pub(crate) fn prepare<'a>(
    scene: &'a Scene,
    options: &'a PlanOptions,
    run: &mut Run,
) -> Result<Prepared<'a>, PlanError> {
    let infeasible = run.stage(Stage::Proofs, || proofs(scene, options))?;
    let (scene, left_out) = match infeasible {
        None => (Cow::Borrowed(scene), Vec::new()),
        Some(some) if options.leave_for(scene) == Leave::Unreachable && some.can_leave() => {
            let marked = scene.leaving(some.objects());
            (Cow::Owned(marked), some.left_out())
        }
        Some(infeasible) => return Err(PlanError::Infeasible(infeasible)),
    };
    let prepared = run.stage(Stage::World, || Prepared::new(scene, options, left_out))?;
    Ok(prepared?)
}

impl<'a> Prepared<'a> {
    /// Scales and world of a scene in which `left_out` are marked.
    pub fn new(
        scene: Cow<'a, Scene>,
        options: &'a PlanOptions,
        left_out: Vec<LeftOut>,
    ) -> Result<Self, WorldError> {
        let scales = Scales::of(&scene);
        let scaled = scales.scene(&scene);
        let net_length = options.net_length_for(&scene);
        let net_length = net_length.map(|length| scales.scaled(length));
        let world = World::new(&scaled, net_length);
        Ok(Self {
            world: world.map_err(|error| error.in_meters(scales.length))?,
            scene,
            options,
            scales,
            scaled,
            net_length,
            left_out,
        })
    }

    /// The same with a net of this length, m; `None`: free.
    pub fn with_net_length(&self, options: &'a PlanOptions, length: Option<f64>) -> Prepared<'a> {
        Prepared {
            options,
            net_length: length.map(|length| self.scales.scaled(length)),
            ..self.clone()
        }
    }

    /// The same with more objects left where they are, because no certified plan was found that includes them: no circle
    /// is made of them and nothing demands that they are covered.
    pub fn leaving(&self, more: &[LeftOut]) -> Prepared<'a> {
        let scene = self.scene.leaving(more.iter().map(|left| left.object));
        let scaled = self.scales.scene(&scene);
        let world = self.world.with_circles_of(&scaled, self.net_length);
        let mut left_out = self.left_out.clone();
        left_out.extend_from_slice(more);
        left_out.sort_by_key(|left| left.object);
        Prepared {
            scene: Cow::Owned(scene),
            scaled,
            world,
            left_out,
            ..*self
        }
    }

    /// The circles in the order in which the line between the robots comes nearest to them.
    pub fn swept_order(&self, pair: &PairTrajectory) -> Vec<usize> {
        let circles = &self.world.circles;
        let nearest = |circle: usize| {
            let distance = |i: &usize| {
                let line = Segment::new(pair.left[*i].position(), pair.right[*i].position());
                line.distance(circles[circle].center)
            };
            (0..pair.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
        };
        let mut order: Vec<usize> = (0..circles.len()).collect();
        order.sort_by_key(|&circle| nearest(circle));
        order
    }

    /// A failure of the route in the planner's words, with its places in m.
    pub fn route_error(&self, error: RouteError) -> PlanError {
        error.in_meters(self.scales.length).into()
    }

    /// A length that the optimizer returns, m. One that was given comes back as it was, without rounding.
    pub fn meters(&self, length: f64) -> f64 {
        self.options
            .net_length_for(&self.scene)
            .filter(|&given| self.scales.scaled(given) == length)
            .unwrap_or(self.scales.meters(length))
    }
}
