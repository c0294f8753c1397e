/// What the generated course looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Free bends through scattered obstacles.
    Witness,
    /// A hall of parallel lanes between walls, joined by U-turns; hundreds of objects when long.
    Serpentine,
}

impl Kind {
    /// The name in scene names and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Witness => "witness",
            Self::Serpentine => "serpentine",
        }
    }
}
