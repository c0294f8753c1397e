use crate::options::CenterlineMethod;
use crate::prepare::Prepared;
use pairtrawl_geometry::Pose;
use pairtrawl_model::PairTrajectory;
use pairtrawl_route::{RouteError, baseline, hybrid_a_star, rrt_star};

/// Samples for each leg of an RRT* centerline.
const SAMPLES: usize = 3000;

/// Where an attempt begins: a visiting order and the way in which the centerline along it is searched. Lengths are in
/// units of the length scale.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Start {
    /// Indices of circles.
    pub order: Vec<usize>,
    method: CenterlineMethod,
    name: StartName,
    /// The centerline, once it is found.
    line: Option<Vec<Pose>>,
    /// The pair to begin with instead of the baseline.
    pair: Option<PairTrajectory>,
}

/// Starts before they are compared.
pub(crate) struct Candidates {
    /// In the order in which they are tried.
    pub starts: Vec<Start>,
    /// How many of them, from the first one on, are worth comparing.
    pub explored: usize,
}

/// What sets a start apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StartName {
    /// The visiting order of this rank by length, from 1.
    Ranked(usize),
    /// A way that keeps away from this number of places where attempts got stuck.
    Around(usize),
    /// The order in which the scene lists the objects.
    SceneOrder,
}

impl Start {
    pub fn new(order: Vec<usize>, method: CenterlineMethod, name: StartName) -> Self {
        Self {
            order,
            method,
            name,
            line: None,
            pair: None,
        }
    }

    /// True when the other one visits the same circles along a centerline that is searched in the same way.
    pub fn is_same_way(&self, other: &Self) -> bool {
        self.order == other.order && self.method == other.method
    }

    /// What it takes, for people.
    pub fn name(&self) -> String {
        match self.name {
            StartName::Ranked(rank) => format!(
                "visiting order {rank} and a centerline by {}",
                self.method.name()
            ),
            StartName::Around(1) => "a way around the place where an attempt got stuck".to_owned(),
            StartName::Around(places) => {
                format!("a way around {places} places where attempts got stuck")
            }
            StartName::SceneOrder => "the scene's own order".to_owned(),
        }
    }

    /// The pair to begin with instead of the baseline.
    pub fn pair(&self) -> Option<&PairTrajectory> {
        self.pair.as_ref()
    }

    /// The same with its centerline found, where there is one: it need not be searched again.
    pub fn with_line(&self, prepared: &Prepared) -> Self {
        Self {
            line: self.centerline(prepared).ok(),
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
    pub fn centerline(&self, prepared: &Prepared) -> Result<Vec<Pose>, RouteError> {
        if let Some(line) = &self.line {
            return Ok(line.clone());
        }
        let (world, scene, order) = (&prepared.world, &prepared.scaled, &self.order);
        match self.method {
            CenterlineMethod::HybridAStar => hybrid_a_star::centerline(world, scene, order),
            CenterlineMethod::RrtStar => {
                rrt_star::centerline(world, scene, order, prepared.options.seed, SAMPLES)
            }
        }
    }

    /// The baseline pair along the centerline.
    pub fn baseline(&self, prepared: &Prepared) -> Result<PairTrajectory, RouteError> {
        let line = self.centerline(prepared)?;
        let waypoints = prepared.options.waypoints_for(&prepared.scene);
        baseline(
            &prepared.world,
            &prepared.scaled,
            &line,
            &self.order,
            waypoints,
        )
    }
}
