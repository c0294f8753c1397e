//! What is looked at while a plan is driven.

use crate::{Options, Part, Simulation, distance_outside, encloses};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    PairPose, Rehearsal, RehearsalEvent, RehearsalEventKind as Kind, RehearsalFrame,
    RehearsalRecord, Scene, Side, Units,
};

// In units of the machine, as the physics: for the default machine s and m.

/// Tension is a mean over this long.
const TENSION_WINDOW: f64 = 0.02;
/// Contacts and objects are looked at this often.
const LOOK_INTERVAL: f64 = 0.01;
/// The same thing again within this time is the same event.
const EPISODE: f64 = 1.0;
/// An object that was in the net this long is held.
const HELD_TIME: f64 = 0.5;
/// A held object farther outside than this beyond its own radius has escaped.
const ESCAPE_DISTANCE: f64 = 0.03;

/// Looks at a simulation step by step and keeps the record: events, tension, frames.
pub struct Watch {
    options: Options,
    units: Units,
    radii: Vec<f64>,
    tension_limit: f64,
    look_every: u64,
    frame_every: u64,
    window_every: u64,
    steps: u64,
    window: [Point; 2],
    frame: Sums,
    whole: Sums,
    held: Vec<Holding>,
    open: Vec<(Kind, f64)>,
    record: RehearsalRecord,
}

/// Sums over steps.
#[derive(Clone, Copy, Default)]
struct Sums {
    steps: f64,
    load: [Point; 2],
    drive: [f64; 2],
}

/// Where things are at an instant.
struct Seen {
    net: Vec<Point>,
    objects: Vec<Pose>,
}

impl Seen {
    fn of(simulation: &Simulation) -> Self {
        Self {
            net: simulation.net(),
            objects: simulation.objects(),
        }
    }
}

/// Since when an object has been in the net.
#[derive(Clone, Copy)]
enum Holding {
    Outside,
    Since(f64),
}

impl Watch {
    /// For a simulation at its start.
    pub fn new(scene: &Scene, options: &Options, simulation: &Simulation) -> Self {
        let units = simulation.units();
        let every = |interval: f64| (interval / options.time_step).round().max(1.0) as u64;
        let mut watch = Self {
            options: *options,
            units,
            radii: scene.objects.iter().map(|o| o.footprint_radius()).collect(),
            tension_limit: scene.physics.tension_limit,
            look_every: every(LOOK_INTERVAL * units.time),
            frame_every: every(options.frame_interval),
            window_every: every(TENSION_WINDOW * units.time),
            steps: 0,
            window: [Point::ZERO; 2],
            frame: Sums::default(),
            whole: Sums::default(),
            held: vec![Holding::Outside; scene.objects.len()],
            open: Vec::new(),
            record: RehearsalRecord {
                left: scene.left(),
                warnings: simulation.warnings().to_vec(),
                ..RehearsalRecord::default()
            },
        };
        watch.record_frame(simulation, Seen::of(simulation));
        watch
    }

    /// To be called after every step. `wanted` says, when it is asked, where the robots should be now; `None`: that is looked
    /// at elsewhere, and nothing is said of deviations.
    pub fn observe(&mut self, simulation: &Simulation, wanted: impl FnOnce() -> Option<PairPose>) {
        self.steps += 1;
        let loads = simulation.loads();
        for sums in [&mut self.frame, &mut self.whole] {
            sums.steps += 1.0;
            for (side, load) in loads.iter().enumerate() {
                sums.load[side] += load.load;
                sums.drive[side] += load.drive_force;
            }
        }
        for (side, load) in loads.iter().enumerate() {
            self.window[side] += load.load;
        }
        if self.steps.is_multiple_of(self.window_every) {
            self.look_at_tension(simulation);
        }
        let (looks, frame) = (
            self.steps.is_multiple_of(self.look_every),
            self.steps.is_multiple_of(self.frame_every),
        );
        if !looks && !frame {
            return;
        }
        let seen = Seen::of(simulation);
        if looks {
            if let Some(wanted) = wanted() {
                self.look_at_paths(simulation, wanted);
            }
            self.look_at_contacts(simulation, &seen);
            self.look_at_objects(simulation.time(), &seen);
        }
        if frame {
            self.record_frame(simulation, seen);
        }
    }

    /// The record, with the verdict.
    pub fn finish(mut self, simulation: &Simulation) -> RehearsalRecord {
        let seen = Seen::of(simulation);
        self.record.gathered = simulation.gathered();
        self.record.duration = simulation.time();
        self.record.mean_drive_force = self.whole.drive.map(|sum| sum / self.whole.steps.max(1.0));
        for (object, pose) in seen.objects.iter().enumerate() {
            if !self.record.gathered[object] && !self.is_left(object) {
                self.happened(
                    Kind::ObjectNotGathered { object },
                    simulation.time(),
                    pose.position(),
                );
            }
        }
        if self.frame.steps > 0.0 {
            self.record_frame(simulation, seen);
        }
        let verdict = match self.record.failures().next() {
            None => Rehearsal::Passed,
            Some(event) => Rehearsal::Failed {
                event: event.kind.describe(),
                time: event.time,
                place: event.place,
            },
        };
        self.record.verdict = verdict;
        self.record
    }

    fn look_at_tension(&mut self, simulation: &Simulation) {
        let hitches = simulation.hitches();
        for side in Side::BOTH {
            let i = side.index();
            let tension = self.window[i].norm() / self.window_every as f64;
            self.record.max_tension[i] = self.record.max_tension[i].max(tension);
            if tension > self.tension_limit {
                self.happened(Kind::Snag { robot: side }, simulation.time(), hitches[i]);
            }
        }
        self.window = [Point::ZERO; 2];
    }

    fn look_at_paths(&mut self, simulation: &Simulation, wanted: PairPose) {
        let wanted = [wanted.left, wanted.right];
        let robots = simulation.robots();
        for side in Side::BOTH {
            let i = side.index();
            let place = robots[i].pose.position();
            let deviation = (place - wanted[i].position()).norm();
            self.record.max_deviation[i] = self.record.max_deviation[i].max(deviation);
            if deviation > self.options.max_deviation {
                self.happened(Kind::RobotCaught { robot: side }, simulation.time(), place);
            }
        }
    }

    fn look_at_contacts(&mut self, simulation: &Simulation, seen: &Seen) {
        for contact in simulation.contacts() {
            let kind = match (contact.first, contact.second) {
                (Part::Obstacle(obstacle), Part::Link(_)) => Kind::NetTouchesObstacle { obstacle },
                (Part::Obstacle(obstacle), Part::Robot(robot)) => {
                    Kind::RobotTouchesObstacle { robot, obstacle }
                }
                (Part::Robot(_), Part::Robot(_)) => Kind::RobotsTouch,
                (Part::Robot(robot), Part::Object(object))
                    if distance_outside(&seen.net, seen.objects[object].position())
                        > self.radii[object] =>
                {
                    Kind::RobotTouchesObject { robot, object }
                }
                _ => continue,
            };
            self.happened(kind, simulation.time(), contact.place);
        }
    }

    /// True for an object that the run leaves where it lies.
    fn is_left(&self, object: usize) -> bool {
        // The list is in ascending order.
        self.record.left.binary_search(&object).is_ok()
    }

    fn look_at_objects(&mut self, time: f64, seen: &Seen) {
        let escaped = ESCAPE_DISTANCE * self.units.length;
        let held = HELD_TIME * self.units.time;
        for (object, pose) in seen.objects.iter().enumerate() {
            if self.is_left(object) {
                continue;
            }
            let place = pose.position();
            self.held[object] = match self.held[object] {
                Holding::Outside if encloses(&seen.net, place) => Holding::Since(time),
                Holding::Since(since)
                    if distance_outside(&seen.net, place) > self.radii[object] + escaped =>
                {
                    if time - since > held {
                        self.happened(Kind::ObjectEscapes { object }, time, place);
                    }
                    Holding::Outside
                }
                holding => holding,
            };
        }
    }

    /// Notes an event, or that it still goes on.
    fn happened(&mut self, kind: Kind, time: f64, place: Point) {
        let episode = EPISODE * self.units.time;
        let again = self.open.iter_mut().find(|(open, _)| *open == kind);
        match again {
            Some((_, last)) if time - *last < episode => *last = time,
            Some((_, last)) => {
                *last = time;
                self.record
                    .events
                    .push(RehearsalEvent { kind, time, place });
            }
            None => {
                self.open.push((kind, time));
                self.record
                    .events
                    .push(RehearsalEvent { kind, time, place });
            }
        }
    }

    fn record_frame(&mut self, simulation: &Simulation, seen: Seen) {
        let steps = self.frame.steps.max(1.0);
        self.record.frames.push(RehearsalFrame {
            time: simulation.time(),
            robots: simulation.pair(),
            net: seen.net,
            objects: seen.objects,
            tension: self.frame.load.map(|sum| sum.norm() / steps),
            drive_force: self.frame.drive.map(|sum| sum / steps),
        });
        self.frame = Sums::default();
    }
}
