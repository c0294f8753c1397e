use crate::{PairPose, Rehearsal, Side, Warning};
use pairtrawl_geometry::{Point, Pose};

/// What happened when a plan was driven in physics.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RehearsalRecord {
    /// Passed, or the first event. Never [`Rehearsal::Skipped`].
    pub verdict: Rehearsal,
    /// Everything that must not happen and did, in order of time.
    pub events: Vec<RehearsalEvent>,
    /// Per object: true when at the end its center lies inside the region bounded by the net and the hitch line.
    pub gathered: Vec<bool>,
    /// Objects that were to be left where they are: it does not matter whether they are in the net.
    pub left: Vec<usize>,
    /// Greatest tension at the (left, right) hitch, mean over 20 ms, N.
    pub max_tension: [f64; 2],
    /// Greatest distance of the (left, right) robot from its place in the plan, m.
    pub max_deviation: [f64; 2],
    /// Mean force with which the (left, right) robot drove along its heading, over the whole run, N.
    pub mean_drive_force: [f64; 2],
    /// Simulated time, s.
    pub duration: f64,
    /// What was seen, at even intervals of time; the first frame is the start, the last one the end.
    pub frames: Vec<RehearsalFrame>,
    /// Warnings for people, such as a net that had to be folded to fit at the start.
    pub warnings: Vec<Warning>,
}

impl RehearsalRecord {
    /// How many of the objects that were to be gathered are in the net at the end.
    pub fn gathered_count(&self) -> usize {
        gathered_count(&self.gathered, &self.left)
    }

    /// How many objects were to be gathered.
    pub fn wanted(&self) -> usize {
        self.gathered.len() - self.left.len()
    }

    /// The events that count against it: an object that slipped out and was caught again is reported but does no harm.
    pub fn failures(&self) -> impl Iterator<Item = &RehearsalEvent> {
        self.events.iter().filter(|event| match event.kind {
            RehearsalEventKind::ObjectEscapes { object } => {
                self.gathered.get(object) != Some(&true)
            }
            _ => true,
        })
    }
}

/// How many objects are gathered, those apart that were to be left.
pub(crate) fn gathered_count(gathered: &[bool], left: &[usize]) -> usize {
    let counted = gathered.iter().enumerate();
    counted.filter(|(i, g)| **g && !left.contains(i)).count()
}

/// One instant of a rehearsal.
#[derive(Clone, Debug, PartialEq)]
pub struct RehearsalFrame {
    /// Time since the start, s.
    pub time: f64,
    /// Axle centers and headings of the robots.
    pub robots: PairPose,
    /// The net from the left hitch to the right one, m: both hitches and every hinge between them.
    pub net: Vec<Point>,
    /// Center and turn of each object, in the scene's order.
    pub objects: Vec<Pose>,
    /// Tension at the (left, right) hitch, mean since the frame before, N.
    pub tension: [f64; 2],
    /// Force with which the (left, right) robot drives along its heading, mean since the frame before, N.
    pub drive_force: [f64; 2],
}

/// Something that must not happen in a rehearsal.
#[derive(Clone, Debug, PartialEq)]
pub struct RehearsalEvent {
    /// What happened.
    pub kind: RehearsalEventKind,
    /// When it began, s.
    pub time: f64,
    /// Where, m.
    pub place: Point,
}

/// What can go wrong in a rehearsal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RehearsalEventKind {
    /// The net touched an obstacle (its index in the scene; `None`: a cell of the map).
    NetTouchesObstacle {
        /// Index in `scene.obstacles`.
        obstacle: Option<usize>,
    },
    /// The tension at a hitch rose above the scene's `tension_limit`.
    Snag {
        /// At which robot.
        robot: Side,
    },
    /// A robot touched an object from outside the net.
    RobotTouchesObject {
        /// Which robot.
        robot: Side,
        /// Index in `scene.objects`.
        object: usize,
    },
    /// The robots touched each other.
    RobotsTouch,
    /// A robot touched an obstacle.
    RobotTouchesObstacle {
        /// Which robot.
        robot: Side,
        /// Index in `scene.obstacles`; `None`: a cell of the map.
        obstacle: Option<usize>,
    },
    /// An object that was inside the net came out again.
    ObjectEscapes {
        /// Index in `scene.objects`.
        object: usize,
    },
    /// A robot was held off its path by the net.
    RobotCaught {
        /// Which robot.
        robot: Side,
    },
    /// At the end an object lay outside the net.
    ObjectNotGathered {
        /// Index in `scene.objects`.
        object: usize,
    },
}

impl RehearsalEventKind {
    /// The event in a few words, for people.
    pub fn describe(&self) -> String {
        let obstacle_name = |obstacle: &Option<usize>| match obstacle {
            Some(i) => format!("obstacle {i}"),
            None => "the map's obstacles".to_owned(),
        };
        match self {
            Self::NetTouchesObstacle { obstacle } => {
                format!("the net touches {}", obstacle_name(obstacle))
            }
            Self::Snag { robot } => format!(
                "the net is snagged: tension over the limit at the {} robot",
                robot.name()
            ),
            Self::RobotTouchesObject { robot, object } => {
                format!(
                    "the {} robot touches object {object} from outside the net",
                    robot.name()
                )
            }
            Self::RobotsTouch => "the robots touch each other".to_owned(),
            Self::RobotTouchesObstacle { robot, obstacle } => {
                format!(
                    "the {} robot touches {}",
                    robot.name(),
                    obstacle_name(obstacle)
                )
            }
            Self::ObjectEscapes { object } => format!("object {object} escapes from the net"),
            Self::RobotCaught { robot } => {
                format!("the {} robot is held off its path", robot.name())
            }
            Self::ObjectNotGathered { object } => {
                format!("object {object} is not in the net at the end")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_object_that_comes_back_does_no_harm() {
        let event = |kind| RehearsalEvent {
            kind,
            time: 1.0,
            place: Point::ZERO,
        };
        let escapes = |object| event(RehearsalEventKind::ObjectEscapes { object });
        let touch = event(RehearsalEventKind::RobotsTouch);
        let record = RehearsalRecord {
            events: vec![escapes(0), escapes(1), touch.clone()],
            gathered: vec![true, false],
            ..RehearsalRecord::default()
        };
        let failures: Vec<_> = record.failures().cloned().collect();
        assert_eq!(failures, [escapes(1), touch]);
    }
}
