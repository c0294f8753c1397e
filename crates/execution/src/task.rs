use crate::{ExecutionObserver, ExecutionOptions};
use pairtrawl_model::{Cost, PairTrajectory, Scene};
use pairtrawl_reference::Reference;

/// What is driven, and how.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    /// The world; trials change what their conditions say.
    pub scene: &'a Scene,
    /// d_max, m.
    pub net_length: f64,
    /// The plan's waypoints.
    pub trajectory: &'a PairTrajectory,
    /// The plan's reference.
    pub reference: &'a Reference,
    /// How it is driven.
    pub options: &'a ExecutionOptions,
}

/// What the caller brings along.
#[derive(Clone, Copy)]
pub struct Host<'a> {
    /// Seconds since some instant; only `Trial::seconds` comes from it.
    pub clock: &'a (dyn Fn() -> f64 + Sync),
    /// J of a driven path.
    pub cost: &'a (dyn Fn(&PairTrajectory) -> Cost + Sync),
    /// Watches, and may stop.
    pub observer: &'a dyn ExecutionObserver,
}
