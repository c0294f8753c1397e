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
    /// A warning in words: from a file, or from a part of the program that has no data to add.
    Stated(String),
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
            Self::Stated(words) => f.write_str(words),
        }
    }
}

impl From<String> for Warning {
    fn from(words: String) -> Self {
        Self::Stated(words)
    }
}
