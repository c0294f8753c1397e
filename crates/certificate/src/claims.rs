//! One claim a file.

mod abreast;
mod endpoints;
mod every_object_covered;
mod forward;
mod inside_area;
mod net_encloses_no_obstacle;
mod net_reach;
mod no_sideways_slip;
mod robot_clearance;
mod robots_miss_objects;
mod separation;
mod speed;
mod step;
mod turn;

use crate::TOLERANCE;
use crate::subject::Subject;
use crate::tightest::Tightest;

/// A claim: its name in the file format, how it is judged, and the slack that its bound has.
pub(crate) struct Judge {
    pub(crate) name: &'static str,
    pub(crate) judge: fn(&Subject<'_>) -> Tightest,
    pub(crate) tolerance: f64,
}

const fn claim(name: &'static str, judge: fn(&Subject<'_>) -> Tightest, tolerance: f64) -> Judge {
    Judge {
        name,
        judge,
        tolerance,
    }
}

/// In the order of the file format. Claims whose bound is itself a tolerance have no further slack.
pub(crate) const ALL: [Judge; 14] = [
    claim("endpoints", endpoints::judge, 0.0),
    claim("step", step::judge, TOLERANCE),
    claim("turn", turn::judge, TOLERANCE),
    claim("forward", forward::judge, 0.0),
    claim("no_sideways_slip", no_sideways_slip::judge, 0.0),
    claim("speed", speed::judge, TOLERANCE),
    claim("abreast", abreast::judge, TOLERANCE),
    claim("robot_clearance", robot_clearance::judge, TOLERANCE),
    claim("robots_miss_objects", robots_miss_objects::judge, TOLERANCE),
    claim(
        "net_encloses_no_obstacle",
        net_encloses_no_obstacle::judge,
        TOLERANCE,
    ),
    claim(
        "every_object_covered",
        every_object_covered::judge,
        TOLERANCE,
    ),
    claim("separation", separation::judge, TOLERANCE),
    claim("net_reach", net_reach::judge, TOLERANCE),
    claim("inside_area", inside_area::judge, TOLERANCE),
];
