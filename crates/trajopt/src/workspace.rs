use crate::filter::Filter;
use crate::iterate::Iterate;
use crate::newton::Newton;
use crate::system::System;
use std::ops::Range;

/// State of the solver, reused from solve to solve so that the loop does not allocate.
#[derive(Clone, Debug, Default)]
pub(crate) struct Workspace {
    pub system: System,
    pub newton: Newton,
    pub trial: Iterate,
    pub filter: Filter,
    /// Parts of the course whose direction is found again.
    pub parts: Vec<Range<usize>>,
}
