//! One file for each claim.

mod abreast;
mod endpoints;
mod every_object_covered;
mod forward;
mod inside_area;
mod net_encloses_no_obstacle;
mod net_reach;
mod no_sideways_slip;
mod robot_clearance;
mod robots_apart;
mod robots_miss_objects;
mod separation;
mod speed;
mod step;
mod turn;

use crate::limits::TOLERANCE;
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_model::{ClaimId, Robot};

/// A claim: which one, how it is judged, and the slack that its bound has.
pub(crate) struct Judge {
    pub(crate) id: ClaimId,
    pub(crate) judge: fn(&Subject<'_>) -> Tightest,
    pub(crate) tolerance: f64,
}

const fn claim(id: ClaimId, judge: fn(&Subject<'_>) -> Tightest, tolerance: f64) -> Judge {
    Judge {
        id,
        judge,
        tolerance,
    }
}

/// In the order of the file format. Claims whose bound is itself a tolerance have no further slack.
const ALL: [Judge; 15] = [
    claim(ClaimId::Endpoints, endpoints::judge, 0.0),
    claim(ClaimId::Step, step::judge, TOLERANCE),
    claim(ClaimId::Turn, turn::judge, TOLERANCE),
    claim(ClaimId::Forward, forward::judge, 0.0),
    claim(ClaimId::NoSidewaysSlip, no_sideways_slip::judge, 0.0),
    claim(ClaimId::Speed, speed::judge, TOLERANCE),
    claim(ClaimId::Abreast, abreast::judge, TOLERANCE),
    claim(ClaimId::RobotClearance, robot_clearance::judge, TOLERANCE),
    claim(
        ClaimId::RobotsMissObjects,
        robots_miss_objects::judge,
        TOLERANCE,
    ),
    claim(
        ClaimId::NetEnclosesNoObstacle,
        net_encloses_no_obstacle::judge,
        TOLERANCE,
    ),
    claim(
        ClaimId::EveryObjectCovered,
        every_object_covered::judge,
        TOLERANCE,
    ),
    claim(ClaimId::Separation, separation::judge, TOLERANCE),
    claim(ClaimId::NetReach, net_reach::judge, TOLERANCE),
    claim(ClaimId::InsideArea, inside_area::judge, TOLERANCE),
    claim(ClaimId::RobotsApart, robots_apart::judge, TOLERANCE),
];

/// The claims that are made of a robot: `robots_apart` of one with a body, since `separation` says it of a disc.
pub(crate) fn of(robot: &Robot) -> impl Iterator<Item = &'static Judge> {
    let with_body = robot.body.is_some();
    ALL.iter()
        .filter(move |claim| with_body || claim.id != ClaimId::RobotsApart)
}
