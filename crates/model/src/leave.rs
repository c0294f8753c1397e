/// What is done with objects that cannot be gathered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Leave {
    /// Nothing is left: one object that cannot be gathered refuses the whole plan.
    #[default]
    None,
    /// They are left where they are, and everything else is gathered.
    Unreachable,
}

impl Leave {
    /// All, in the order of their declaration.
    pub const ALL: [Self; 2] = [Self::None, Self::Unreachable];

    /// The name in files and on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Unreachable => "unreachable",
        }
    }

    /// True for the default.
    pub fn is_none(&self) -> bool {
        *self == Self::None
    }
}
