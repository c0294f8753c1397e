/// A step of planning, in the order in which they run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// Looking for a proof that there is no plan.
    Proofs,
    /// Occupancy grid, distance field, circles.
    World,
    /// The order in which the circles are visited.
    Order,
    /// Several starts, optimized once each.
    Explore,
    /// The pair's centerline.
    Centerline,
    /// The baseline pair.
    Baseline,
    /// Trajectories and net length.
    Optimize,
    /// The certificate.
    Certify,
    /// The rehearsal.
    Rehearse,
}

impl Stage {
    /// Its name in summaries and machine-readable output.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Proofs => "proofs",
            Self::World => "world",
            Self::Order => "order",
            Self::Explore => "explore",
            Self::Centerline => "centerline",
            Self::Baseline => "baseline",
            Self::Optimize => "optimize",
            Self::Certify => "certify",
            Self::Rehearse => "rehearse",
        }
    }
}

/// Watches a planner at work and may stop it. `()` watches nothing. It is asked from several threads.
pub trait Observer: Sync {
    /// A stage begins; `round` counts from 1 and rises when a failed claim makes the planner try again.
    fn started(&mut self, _stage: Stage, _round: usize) {}

    /// A stage ended after this many seconds.
    fn finished(&mut self, _stage: Stage, _seconds: f64) {}

    /// Something that a person may want to know while it runs.
    fn noted(&mut self, _message: &str) {}

    /// Seconds since some fixed instant. The time limit and the seconds of stages come from it, and nothing else does. By
    /// default the system's clock; without feature `fs` there is none: time stands still, no limit is reached.
    fn now(&self) -> f64 {
        crate::clock::seconds()
    }

    /// Asked between stages, between rounds, and many times while starts are explored and trajectories optimized: true ends the work with `PlanError::Interrupted`.
    fn interrupted(&self) -> bool {
        false
    }
}

impl Observer for () {}
