/// What the expansion cost J_e is summed over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum ExpansionPer {
    /// The waypoints, as printed: twice as long steps halve its weight against the driven distance, and with it the length of
    /// net that is best.
    #[default]
    Waypoint,
    /// The way: each waypoint counts in proportion to the longest step `max_step`, as much as in the paper's setup where that
    /// is 0.05 m (for the default robot). The best length of net then hardly depends on how finely the way is sampled.
    Meter,
}

impl ExpansionPer {
    /// All, in the order of their declaration.
    pub const ALL: [Self; 2] = [Self::Waypoint, Self::Meter];

    /// The name in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Waypoint => "waypoint",
            Self::Meter => "meter",
        }
    }

    /// True for the default.
    pub fn is_waypoint(&self) -> bool {
        *self == Self::Waypoint
    }
}
