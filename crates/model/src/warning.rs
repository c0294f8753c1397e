use crate::{ClaimId, numbers};
use pairtrawl_geometry::Point;
use std::fmt;

/// Something that a person should know about a result that stands all the same.
#[derive(Clone, Debug, PartialEq)]
pub enum Warning {
    /// A margin that was wished for had no room.
    MarginShrunk {
        /// The claim beyond which the margin lies.
        claim: ClaimId,
        /// What is left of the margin, m.
        left: f64,
        /// `planner.clearance`, m.
        wished: f64,
        /// At which waypoint.
        waypoint: usize,
        /// Where, m.
        place: Point,
    },
    /// No certified plan was found from the starts that seemed best.
    OtherStart {
        /// How many starts failed.
        failed: usize,
        /// The start that did not.
        start: String,
    },
    /// The plan is certified, but the time was up before it was finished.
    TimeLimit {
        /// The time limit, s.
        limit: f64,
        /// What was not done any more.
        missing: &'static str,
    },
    /// Planning again did not succeed from the rest of the plan before.
    PlannedFromNothing,
    /// The plan is certified, but its rehearsal fails.
    RehearsalFails {
        /// What happened first.
        event: String,
        /// When, s.
        time: f64,
        /// Where, m.
        place: Point,
    },
    /// The optimizer could not bring the residual as low as it was asked to.
    NotPolished {
        /// Relative optimality residual of the plan.
        residual: f64,
        /// What was asked for.
        tolerance: f64,
    },
    /// The plan that is driven is not certified.
    Unproven {
        /// The claims that fail.
        claims: Vec<ClaimId>,
    },
    /// On the smooth curve that is driven a claim fails.
    CurveFails {
        /// The claim.
        claim: ClaimId,
        /// By how much, in its unit; negative.
        margin: f64,
        /// What the claim says about it.
        detail: String,
    },
    /// The net does not fit behind the robots at the start, and begins folded.
    NetFolded,
    /// The net fits nowhere behind the robots at the start.
    NetOverlaps {
        /// How many of its links overlap something.
        overlapping: usize,
        /// How many links it has.
        links: usize,
    },
    /// The net cannot lie on the given line, which has another length.
    NetOffStartLine {
        /// The length of `net.start`, m.
        line: f64,
        /// The net's length, m.
        net: f64,
    },
    /// A map's threshold makes cells free that are unknown.
    UnknownCellsFree {
        /// `free_thresh` of the map.
        free_threshold: f64,
        /// How many cells.
        cells: usize,
    },
    /// The pair drives far below what it could.
    SlowCruise {
        /// `planner.cruise`, m/s.
        cruise: f64,
        /// `robot.v_max`, m/s.
        v_max: f64,
    },
    /// A key of the scene says nothing, because another one does.
    Unused {
        /// The key.
        key: &'static str,
        /// What counts instead.
        instead: &'static str,
    },
    /// A warning about a file.
    InFile {
        /// Its path.
        file: String,
        /// What is to be known about it.
        warning: Box<Warning>,
    },
    /// A warning in the words of the plan file that it was read from.
    Stated(String),
}

impl Warning {
    /// The same with the lengths of the net in meters, after it was laid in units of `length` meters.
    #[must_use]
    pub fn in_meters(self, length: f64) -> Self {
        match self {
            Self::NetOffStartLine { line, net } => Self::NetOffStartLine {
                line: line * length,
                net: net * length,
            },
            other => other,
        }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::MarginShrunk {
                claim,
                left,
                wished,
                waypoint,
                place,
            } => {
                let what = match claim {
                    ClaimId::NetEnclosesNoObstacle => "net and obstacle",
                    ClaimId::RobotsMissObjects => "robot and object",
                    _ => "robot and obstacle",
                };
                let (left, wished) = (numbers::length(*left), numbers::length(*wished));
                let place = numbers::place(*place);
                write!(
                    f,
                    "the margin between {what} shrinks to {left} of the {wished} wished for, at waypoint {waypoint} near {place}"
                )
            }
            Self::OtherStart { failed, start } => write!(
                f,
                "no certified plan was found from {failed} other start(s); this one takes {start}"
            ),
            Self::TimeLimit { limit, missing } => {
                let limit = numbers::duration(*limit);
                write!(
                    f,
                    "the time limit of {limit} ran out: the plan is certified, but {missing}"
                )
            }
            Self::PlannedFromNothing => {
                f.write_str("no certified plan followed from the one before: planned from nothing")
            }
            Self::RehearsalFails { event, time, place } => {
                let (time, place) = (numbers::duration(*time), numbers::place(*place));
                write!(
                    f,
                    "the plan is certified, but its rehearsal fails: {event} at {time} near {place}"
                )
            }
            Self::NotPolished {
                residual,
                tolerance,
            } => write!(
                f,
                "the optimizer stopped at a residual of {residual:.1e} instead of {tolerance:.1e}: the plan is certified, its \
                 cost is that of the default tolerance"
            ),
            Self::Unproven { claims } => {
                let names: Vec<_> = claims.iter().map(|claim| claim.name()).collect();
                write!(f, "the plan cannot be proven: {} fails", names.join(", "))
            }
            Self::CurveFails {
                claim,
                margin,
                detail,
            } => {
                let amount = numbers::quantity(-margin, claim.unit());
                write!(
                    f,
                    "on the smooth curve that is driven, the claim {claim} fails by {amount}: {detail}"
                )
            }
            Self::NetFolded => f.write_str(
                "the net does not fit as a U behind the robots at the start: it is folded",
            ),
            Self::NetOverlaps { overlapping, links } => write!(
                f,
                "the net fits neither as a U nor folded behind the robots at the start: {overlapping} of {links} links \
                 overlap something; give net.start"
            ),
            Self::NetOffStartLine { line, net } => write!(
                f,
                "net.start is {} long, the net {}: the net lies near that line, not on it",
                numbers::length(*line),
                numbers::length(*net)
            ),
            Self::UnknownCellsFree {
                free_threshold,
                cells,
            } => write!(
                f,
                "free_thresh {free_threshold} makes {cells} cells free that hold gray 205, which map_saver writes for \
                 unknown cells (occ 0.196): set free_thresh to 0.196 to keep them unknown"
            ),
            Self::SlowCruise { cruise, v_max } => write!(
                f,
                "planner.cruise is {}, less than a fifth of robot.v_max, {}: the run takes {:.0} times as long as it need",
                numbers::speed(*cruise),
                numbers::speed(*v_max),
                v_max / cruise
            ),
            Self::Unused { key, instead } => {
                write!(
                    f,
                    "{key} is not used, because {instead} gives the same: leave it out"
                )
            }
            Self::InFile { file, warning } => write!(f, "{file}: {warning}"),
            Self::Stated(words) => f.write_str(words),
        }
    }
}
