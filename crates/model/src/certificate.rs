use crate::ClaimId;
use pairtrawl_geometry::Point;

/// The verdict on a plan, claim by claim.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Certificate {
    /// In the order of the file format.
    pub claims: Vec<Claim>,
}

impl Certificate {
    /// True when there are claims and every one holds.
    pub fn is_valid(&self) -> bool {
        !self.claims.is_empty() && self.claims.iter().all(|c| c.holds)
    }
}

/// One claim with its tightest place.
#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    /// Which claim.
    pub id: ClaimId,
    /// True when it holds at every instant.
    pub holds: bool,
    /// How much room is left where it is tightest, in the claim's own unit; negative when it fails. Bounds hold to 1e-9.
    /// `INFINITY` where there is nothing to hold the plan against, `NEG_INFINITY` where the input cannot be judged.
    pub margin: f64,
    /// The step or waypoint where it is tightest.
    pub step: Option<usize>,
    /// The place where it is tightest, m.
    pub place: Option<Point>,
    /// What it is about there, for people: the robot, the obstacle, the object; empty when there is nothing to add.
    pub detail: String,
}
