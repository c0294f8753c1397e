//! What the next attempt does differently after a claim or a rehearsal failed.
//!
//! Lengths are in units of the length scale. Every change only makes the next problem stricter or finer; whatever comes out of it is judged against the scene itself.

use pairtrawl_geometry::Point;
use pairtrawl_model::{Certificate, ClaimId, RehearsalEventKind, Scales};
use pairtrawl_trajopt::Problem;

/// Kept at least beyond a claim that failed once, a length or an angle.
const LEAST_RESERVE: f64 = 1e-3;
/// A claim that failed by some amount gets this many times the amount in reserve.
const RESERVE_FACTOR: f64 = 1.5;
/// What is kept where the wished-for clearance has no room grows by at most this: the curve strays no farther between waypoints.
const MOST_SAG: f64 = 2e-3;
/// So many more waypoints when an attempt did not fit its steps.
const MORE_WAYPOINTS: f64 = 1.1;
/// Added to clearances when something was touched in a rehearsal.
const MORE_CLEARANCE: f64 = 0.03;
/// Headings kept closer to abreast after a snag, rad.
const LESS_SKEW: f64 = 0.15;
/// The net gets this many times as long where what is in it came in the way of a robot or escaped: a full net needs a belly.
const LONGER: f64 = 1.2;
/// Gentler turns after a snag: by this factor.
const GENTLER_TURNS: f64 = 0.75;

/// What is asked beyond the scene's own margins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tightening {
    /// Added to the wished distance of robots from obstacles and objects.
    clearance: f64,
    /// Added to the distance of robots and net from obstacles and objects that is kept even where what is wished for gives way.
    sag: f64,
    /// Added to the wished distance of the net's straight line from obstacles.
    net_clearance: f64,
    /// Added to both bounds of the separation.
    separation: f64,
    /// Subtracted from the net's reach.
    net_reach: f64,
    /// Subtracted from max_skew, rad.
    skew: f64,
    /// Taken from every side of the area that bounds the robots' centers.
    area: f64,
    /// max_turn becomes this many times what it is.
    turn: f64,
    /// Length of the net where the optimizer is to choose it.
    net_length: Option<f64>,
    /// N becomes this many times what the baseline takes, unless the user fixed it.
    pub waypoints: f64,
}

impl Tightening {
    /// Nothing beyond the scene.
    pub const NONE: Self = Self {
        clearance: 0.0,
        sag: 0.0,
        net_clearance: 0.0,
        separation: 0.0,
        net_reach: 0.0,
        skew: 0.0,
        area: 0.0,
        turn: 1.0,
        net_length: None,
        waypoints: 1.0,
    };

    /// Makes a problem stricter.
    pub fn apply(&self, problem: &mut Problem) {
        problem.reserve.clearance += self.clearance;
        problem.reserve.sag += self.sag;
        problem.reserve.net_clearance += self.net_clearance;
        problem.reserve.separation += self.separation;
        problem.reserve.greatest_separation += self.separation;
        problem.reserve.net_reach += self.net_reach;
        problem.reserve.skew += self.skew;
        let inset = Point::new(self.area, self.area);
        problem.area.min += inset;
        problem.area.max -= inset;
        problem.planner.max_turn *= self.turn;
        problem.net_length = problem.net_length.or(self.net_length);
    }

    /// The same and more, after a certificate that does not hold.
    pub fn after_claims(self, certificate: &Certificate, scales: &Scales) -> Self {
        let mut next = self;
        for claim in certificate.claims.iter().filter(|claim| !claim.holds) {
            let unit = if claim.id.unit() == "m" {
                scales.length
            } else {
                1.0
            };
            let more = (-RESERVE_FACTOR * claim.margin / unit).clamp(LEAST_RESERVE, 0.1);
            match claim.id {
                ClaimId::RobotClearance | ClaimId::RobotsMissObjects => {
                    next.clearance += more;
                    next.sag += more.min(MOST_SAG);
                }
                ClaimId::NetEnclosesNoObstacle => {
                    next.net_clearance += more;
                    next.sag += more.min(MOST_SAG);
                }
                ClaimId::Separation | ClaimId::RobotsApart => next.separation += more,
                ClaimId::NetReach => next.net_reach += more,
                ClaimId::Abreast => next.skew += more,
                ClaimId::InsideArea => next.area += more,
                // More waypoints are all that helps.
                ClaimId::Scene
                | ClaimId::NetLength
                | ClaimId::Endpoints
                | ClaimId::Step
                | ClaimId::Turn
                | ClaimId::Forward
                | ClaimId::NoSidewaysSlip
                | ClaimId::Speed
                | ClaimId::EveryObjectCovered => {}
            }
        }
        next.waypoints *= MORE_WAYPOINTS;
        next
    }

    /// The same and more, after a rehearsal that ended with this event first. `net_length` is that of its net; a longer one
    /// is of use only where the planner may choose it.
    pub fn after_event(
        self,
        event: &RehearsalEventKind,
        net_length: f64,
        may_choose: bool,
    ) -> Self {
        use RehearsalEventKind as Kind;
        let mut next = self;
        match event {
            // The trailing net cuts corners on the inner side of turns.
            Kind::NetTouchesObstacle { .. } | Kind::RobotTouchesObstacle { .. } => {
                next.clearance += MORE_CLEARANCE;
                next.net_clearance += MORE_CLEARANCE;
                next.turn *= GENTLER_TURNS;
            }
            Kind::Snag { .. } | Kind::RobotCaught { .. } | Kind::RobotsTouch => {
                next.skew += LESS_SKEW;
                next.turn *= GENTLER_TURNS;
                next.net_clearance += MORE_CLEARANCE;
            }
            // A longer net first, then margins too: there may be no room for those.
            Kind::RobotTouchesObject { .. }
            | Kind::ObjectEscapes { .. }
            | Kind::ObjectNotGathered { .. } => {
                next.net_length = Some(LONGER * net_length);
                if self.net_length.is_some() || !may_choose {
                    next.clearance += MORE_CLEARANCE;
                    next.skew += LESS_SKEW;
                }
            }
        }
        next
    }
}
