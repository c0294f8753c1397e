use pairtrawl_model::{Leave, Scene};
use std::time::Duration;

/// Options of planning. The defaults are what the program does when no option is given.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanOptions {
    /// The net's length instead of the scene's.
    pub net_length: Option<NetLength>,
    /// N instead of the scene's or the planner's own choice.
    pub waypoints: Option<usize>,
    /// How the visiting order is found.
    pub order: OrderMethod,
    /// Greatest number of visiting orders; those that are not planned with are tried while no certified plan is found.
    pub orders: usize,
    /// Whether several starts are optimized, in parallel, and the best one is planned with: the orders, and of the best of
    /// them baselines in which one robot leads. Else it is the baseline of the shortest order. Only for the joint method.
    pub explore: bool,
    /// How the centerline is found; `None`: by hybrid A*, and by RRT* when that leads to no plan.
    pub centerline: Option<CenterlineMethod>,
    /// How the trajectories are optimized.
    pub method: Method,
    /// Relative optimality residual down to which the plan is polished; `None`: its cost is within about 1e-4 of the optimum
    /// nearby. Where it cannot be reached, the plan has a warning.
    pub tolerance: Option<f64>,
    /// Seed of whatever is random: the centerline by RRT*.
    pub seed: u64,
    /// Gives up after this time, checked between steps of work.
    pub time_limit: Option<Duration>,
    /// What is done with objects that cannot be gathered, instead of what the scene says.
    pub leave: Option<Leave>,
    /// Whether the plan is rehearsed in physics.
    pub rehearsal: RehearsalMode,
    /// Greatest number of optimizations: the first and those after a failed claim. At least 1.
    pub rounds: usize,
    /// Greatest number of plans after the first that are tried when a rehearsal fails.
    pub rehearsal_rounds: usize,
}

impl Default for PlanOptions {
    fn default() -> Self {
        Self {
            net_length: None,
            waypoints: None,
            order: OrderMethod::Shortest,
            orders: 3,
            explore: true,
            centerline: None,
            method: Method::Joint,
            tolerance: None,
            seed: 0,
            time_limit: None,
            leave: None,
            rehearsal: RehearsalMode::Report,
            rounds: 6,
            rehearsal_rounds: 3,
        }
    }
}

impl PlanOptions {
    /// d_max of a run in a scene, m; `None`: the planner chooses it.
    pub(crate) fn net_length_for(&self, scene: &Scene) -> Option<f64> {
        match self.net_length {
            None => scene.net.length,
            Some(length) => length.fixed(),
        }
    }

    /// What a run does with objects that cannot be gathered.
    pub(crate) fn leave_for(&self, scene: &Scene) -> Leave {
        self.leave.unwrap_or(scene.planner.leave)
    }

    /// N of a run in a scene; `None`: the planner chooses it.
    pub(crate) fn waypoints_for(&self, scene: &Scene) -> Option<usize> {
        self.waypoints.or(scene.planner.waypoints)
    }

    /// How centerlines are searched, in the order in which the methods are tried. Never empty.
    pub(crate) fn centerline_methods(&self) -> &'static [CenterlineMethod] {
        use CenterlineMethod::{HybridAStar, RrtStar};
        match self.centerline {
            None => &[HybridAStar, RrtStar],
            Some(HybridAStar) => &[HybridAStar],
            Some(RrtStar) => &[RrtStar],
        }
    }
}

/// The net's length when it is not the scene's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NetLength {
    /// The planner chooses it.
    Auto,
    /// This one, m.
    Fixed(f64),
}

impl NetLength {
    /// d_max, m; `None`: the planner chooses it.
    pub const fn fixed(self) -> Option<f64> {
        match self {
            Self::Auto => None,
            Self::Fixed(length) => Some(length),
        }
    }
}

/// How the visiting order is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OrderMethod {
    /// The order of the objects in the scene; a circle comes when its first object does.
    Given,
    /// The shortest open path through all circles.
    Shortest,
}

/// How the centerline is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CenterlineMethod {
    /// Hybrid A*.
    HybridAStar,
    /// Informed RRT*.
    RrtStar,
}

impl CenterlineMethod {
    /// Its name for people.
    pub const fn name(self) -> &'static str {
        match self {
            Self::HybridAStar => "hybrid A*",
            Self::RrtStar => "RRT*",
        }
    }
}

/// How the trajectories are optimized. All methods have the same costs, constraints and certificate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Both robots and the net length at once.
    Joint,
    /// Algorithm 1 of the paper: one robot at a time, an open net length first N dL_max.
    Alternating,
    /// The same, an open net length first that of the joint method.
    AlternatingBounded,
}

/// What a rehearsal decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RehearsalMode {
    /// There is none.
    Skip,
    /// A failed one is reported with the plan.
    Report,
    /// Without a passed one there is no plan.
    Require,
}
