//! What the pickle of a rehearsal holds.

use pairtrawl::geometry::{Point, Pose};
use pairtrawl::model::{
    PairPose, Rehearsal, RehearsalEvent, RehearsalEventKind, RehearsalFrame, RehearsalRecord, Side,
    Warning,
};
use serde::{Deserialize, Serialize};

/// The pickle of a rehearsal.
#[derive(Serialize, Deserialize)]
pub struct RecordState {
    failed: Option<(String, f64, [f64; 2])>,
    events: Vec<(EventState, f64, [f64; 2])>,
    gathered: Vec<bool>,
    left: Vec<usize>,
    max_tension: [f64; 2],
    max_deviation: [f64; 2],
    mean_drive_force: [f64; 2],
    duration: f64,
    frames: Vec<FrameState>,
    warnings: Vec<String>,
}

#[derive(Serialize, Deserialize)]
struct FrameState {
    time: f64,
    robots: [[f64; 3]; 2],
    net: Vec<[f64; 2]>,
    objects: Vec<[f64; 3]>,
    tension: [f64; 2],
    drive_force: [f64; 2],
}

/// What happened; robots are true for the left one.
#[derive(Serialize, Deserialize)]
enum EventState {
    NetTouchesObstacle(Option<usize>),
    Snag(bool),
    RobotTouchesObject(bool, usize),
    RobotsTouch,
    RobotTouchesObstacle(bool, Option<usize>),
    ObjectEscapes(usize),
    RobotCaught(bool),
    ObjectNotGathered(usize),
}

impl From<RehearsalEventKind> for EventState {
    fn from(kind: RehearsalEventKind) -> Self {
        use RehearsalEventKind as Kind;
        let is_left = |robot: Side| robot == Side::Left;
        match kind {
            Kind::NetTouchesObstacle { obstacle } => Self::NetTouchesObstacle(obstacle),
            Kind::Snag { robot } => Self::Snag(is_left(robot)),
            Kind::RobotTouchesObject { robot, object } => {
                Self::RobotTouchesObject(is_left(robot), object)
            }
            Kind::RobotsTouch => Self::RobotsTouch,
            Kind::RobotTouchesObstacle { robot, obstacle } => {
                Self::RobotTouchesObstacle(is_left(robot), obstacle)
            }
            Kind::ObjectEscapes { object } => Self::ObjectEscapes(object),
            Kind::RobotCaught { robot } => Self::RobotCaught(is_left(robot)),
            Kind::ObjectNotGathered { object } => Self::ObjectNotGathered(object),
        }
    }
}

impl From<EventState> for RehearsalEventKind {
    fn from(state: EventState) -> Self {
        let side = |is_left| if is_left { Side::Left } else { Side::Right };
        match state {
            EventState::NetTouchesObstacle(obstacle) => Self::NetTouchesObstacle { obstacle },
            EventState::Snag(robot) => Self::Snag { robot: side(robot) },
            EventState::RobotTouchesObject(robot, object) => Self::RobotTouchesObject {
                robot: side(robot),
                object,
            },
            EventState::RobotsTouch => Self::RobotsTouch,
            EventState::RobotTouchesObstacle(robot, obstacle) => Self::RobotTouchesObstacle {
                robot: side(robot),
                obstacle,
            },
            EventState::ObjectEscapes(object) => Self::ObjectEscapes { object },
            EventState::RobotCaught(robot) => Self::RobotCaught { robot: side(robot) },
            EventState::ObjectNotGathered(object) => Self::ObjectNotGathered { object },
        }
    }
}

impl RecordState {
    /// What the pickle of a rehearsal holds.
    pub fn of(record: &RehearsalRecord) -> Self {
        let failed = match &record.verdict {
            Rehearsal::Failed { event, time, place } => {
                Some((event.clone(), *time, (*place).into()))
            }
            Rehearsal::Passed | Rehearsal::Skipped => None,
        };
        let events = record.events.iter();
        Self {
            failed,
            events: events
                .map(|event| (event.kind.into(), event.time, event.place.into()))
                .collect(),
            gathered: record.gathered.clone(),
            left: record.left.clone(),
            max_tension: record.max_tension,
            max_deviation: record.max_deviation,
            mean_drive_force: record.mean_drive_force,
            duration: record.duration,
            frames: record.frames.iter().map(FrameState::of).collect(),
            warnings: record.warnings.iter().map(ToString::to_string).collect(),
        }
    }

    /// The rehearsal again.
    pub fn into_record(self) -> RehearsalRecord {
        let verdict = self
            .failed
            .map_or(Rehearsal::Passed, |(event, time, place)| {
                Rehearsal::Failed {
                    event,
                    time,
                    place: place.into(),
                }
            });
        let event = |(kind, time, place): (EventState, f64, [f64; 2])| RehearsalEvent {
            kind: kind.into(),
            time,
            place: place.into(),
        };
        RehearsalRecord {
            verdict,
            events: self.events.into_iter().map(event).collect(),
            gathered: self.gathered,
            left: self.left,
            max_tension: self.max_tension,
            max_deviation: self.max_deviation,
            mean_drive_force: self.mean_drive_force,
            duration: self.duration,
            frames: self
                .frames
                .into_iter()
                .map(FrameState::into_frame)
                .collect(),
            warnings: self.warnings.into_iter().map(Warning::Stated).collect(),
        }
    }
}

impl FrameState {
    fn of(frame: &RehearsalFrame) -> Self {
        Self {
            time: frame.time,
            robots: [frame.robots.left.into(), frame.robots.right.into()],
            net: frame.net.iter().map(|&point| point.into()).collect(),
            objects: frame.objects.iter().map(|&pose| pose.into()).collect(),
            tension: frame.tension,
            drive_force: frame.drive_force,
        }
    }

    fn into_frame(self) -> RehearsalFrame {
        let [left, right] = self.robots.map(Pose::from);
        RehearsalFrame {
            time: self.time,
            robots: PairPose { left, right },
            net: self.net.into_iter().map(Point::from).collect(),
            objects: self.objects.into_iter().map(Pose::from).collect(),
            tension: self.tension,
            drive_force: self.drive_force,
        }
    }
}
