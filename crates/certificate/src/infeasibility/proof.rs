use pairtrawl_geometry::Point;
use std::fmt;

/// Why no plan can be valid.
#[derive(Clone, Debug, PartialEq)]
pub struct Proof {
    /// Which argument it is, with its numbers.
    pub kind: ProofKind,
    /// The proof for people: the thing, the amount, and the smallest change that would remove this obstruction.
    pub message: String,
}

impl Proof {
    /// The object that cannot be swept; `None` when the proof is not about one: then there is no plan, whatever is left.
    pub fn object(&self) -> Option<usize> {
        match self.kind {
            ProofKind::ObjectTooWide { object, .. }
            | ProofKind::ObjectEnclosed { object }
            | ProofKind::ObjectAtEdge { object, .. }
            | ProofKind::ObjectPinned { object, .. } => Some(object),
            ProofKind::NetTooShort { .. }
            | ProofKind::NetTooLong { .. }
            | ProofKind::TooFewWaypoints { .. }
            | ProofKind::WayCut { .. } => None,
        }
    }
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// The kinds of proof; lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ProofKind {
    /// The net cannot span what it must.
    NetTooShort {
        /// The least length that would do here.
        needed: f64,
    },
    /// The net is so long that the robots stand too close together at the start or end.
    NetTooLong {
        /// The greatest length that would do here.
        most: f64,
    },
    /// The waypoints given do not reach from start to end.
    TooFewWaypoints {
        /// The least number that might do.
        needed: usize,
    },
    /// One robot has no way from its start to its end.
    WayCut {
        /// Where the widest way is narrowest.
        place: Point,
        /// Its width there; 0 where it is closed.
        width: f64,
    },
    /// The net cannot span an object with a robot on each side.
    ObjectTooWide {
        /// Its index.
        object: usize,
        /// The least net length that would do, m.
        needed: f64,
    },
    /// The line between the robots cannot get to an object.
    ObjectEnclosed {
        /// Its index.
        object: usize,
    },
    /// An object is so close to the edge of the area that the line between the robots cannot pass over it.
    ObjectAtEdge {
        /// Its index.
        object: usize,
        /// Distance between its footprint circle and the edge.
        gap: f64,
    },
    /// An object is so close to an obstacle that the line between the robots cannot pass over it.
    ObjectPinned {
        /// Its index.
        object: usize,
        /// Distance between its footprint circle and the obstacle.
        gap: f64,
    },
}

impl ProofKind {
    /// The name in files.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::NetTooShort { .. } => "net_too_short",
            Self::NetTooLong { .. } => "net_too_long",
            Self::TooFewWaypoints { .. } => "too_few_waypoints",
            Self::WayCut { .. } => "way_cut",
            Self::ObjectTooWide { .. } => "object_too_wide",
            Self::ObjectEnclosed { .. } => "object_enclosed",
            Self::ObjectAtEdge { .. } => "object_at_edge",
            Self::ObjectPinned { .. } => "object_pinned",
        }
    }
}

/// What is not yet settled below this much is left open, m: the endpoints' tolerance and the rounding of distances.
pub(super) const CAUTION: f64 = 1e-5;
