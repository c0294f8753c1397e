//! Costs and constraints that a user adds to the problem.

use crate::term::{PAIR, POINT, Term};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// What a term of the user's is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Added to the objective.
    Cost,
    /// Kept at zero or above, at the price of the planner's own claims.
    Constraint,
}

/// A term of the user's at some waypoints.
#[derive(Clone)]
pub(crate) struct OwnTerm<const K: usize> {
    pub name: String,
    pub role: Role,
    pub waypoints: Range<usize>,
    pub term: Arc<dyn Term<K> + Send + Sync>,
}

/// All terms of the user's.
#[derive(Clone, Debug, Default)]
pub(crate) struct OwnTerms {
    pub pair: Vec<OwnTerm<PAIR>>,
    /// Of the left and of the right robot.
    pub point: [Vec<OwnTerm<POINT>>; 2],
}

impl<const K: usize> OwnTerm<K> {
    /// True when it has this role at a waypoint.
    pub fn is_at(&self, role: Role, stage: usize) -> bool {
        self.role == role && self.waypoints.contains(&stage)
    }
}

impl<const K: usize> fmt::Debug for OwnTerm<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("OwnTerm")
            .field("name", &self.name)
            .field("role", &self.role)
            .field("waypoints", &self.waypoints)
            .finish_non_exhaustive()
    }
}
