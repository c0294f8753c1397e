use clap::ValueEnum;
use pairtrawl::simulation::Options;

/// What computes the motion.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum EngineArgument {
    /// The engine of this project
    #[default]
    Implicit,
    /// rapier in steps of 1 ms: a second opinion, some twenty times slower
    Rapier,
}

impl EngineArgument {
    /// The options of a rehearsal or a trial with this engine.
    pub fn options(self, quick: bool) -> Options {
        match self {
            Self::Implicit if quick => Options::quick(),
            Self::Implicit => Options::default(),
            Self::Rapier => Options::rapier(),
        }
    }
}
