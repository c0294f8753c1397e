//! The pair's brain: from measurements of both robots to a command for each, along a reference. It knows neither a simulation
//! nor a clock, so that a program on real robots calls it as the simulation does.

use crate::sample::control_sample;
use pairtrawl_control::{
    AdaptedParameters, ControllerParameters, Mode, PairRobot, PairState, PairStopCause,
    PairSupervisor, ParameterError, Pose, RobotController, RobotReport, StopCause,
    SupervisorLimits, Velocity, WheelTorque,
};
use pairtrawl_model::Side;
use pairtrawl_reference::{Reference, Sample};
use std::borrow::Borrow;

/// A pose and how old it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseFix {
    /// Pose of the axle center, map frame.
    pub pose: Pose<f64>,
    /// Time since it was true, s.
    pub age: f64,
}

/// What has arrived from a robot since the tick before. All `None`, the default: nothing has, and the robot is silent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measurement {
    /// A new pose.
    pub pose: Option<PoseFix>,
    /// A new velocity; until the next one this one counts.
    pub velocity: Option<Velocity<f64>>,
    /// A new tension at the hitch, N. A robot without a sensor never has one.
    pub tension: Option<f64>,
}

impl Measurement {
    /// True when something has arrived.
    pub fn is_something(&self) -> bool {
        self.pose.is_some() || self.velocity.is_some() || self.tension.is_some()
    }
}

/// What a robot is to do until the next tick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Command {
    /// Torques of the wheels, N m. A robot that is silent brakes without feedback, then its wheels roll freely.
    pub torque: WheelTorque<f64>,
    /// The same for robots that take a velocity: speed (m/s) and turning rate (rad/s) to hold. It falls to zero in a stop.
    pub velocity: Velocity<f64>,
    /// What the robot's controller is doing, and why it stops or stands.
    pub mode: Mode,
}

/// Why the pair stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PairStop {
    /// What was wrong.
    pub cause: PairStopCause,
    /// With which robot.
    pub robot: Side,
}

/// Two controllers and their supervisor along a reference. Arrays over robots are by [`Side::index`].
///
/// When one robot is silent, stops by itself, strays from its reference or pulls too hard, both stop smoothly and stand until
/// [`Self::rearm`]. `R` is a [`Reference`], a borrowed or a shared one (`&Reference`, `Arc<Reference>`).
#[derive(Clone, Debug)]
pub struct PairController<R> {
    reference: R,
    robots: [RobotLink; 2],
    supervisor: PairSupervisor<f64>,
    time: Option<f64>,
    targets: [Sample; 2],
}

/// A controller and what is known of its robot.
#[derive(Clone, Debug)]
struct RobotLink {
    controller: RobotController<f64>,
    /// When something last arrived, s; the first tick at the latest.
    heard: Option<f64>,
    /// When the last velocity arrived, s; likewise.
    felt: Option<f64>,
    /// The last velocity. Before the first one the robot stands.
    velocity: Velocity<f64>,
    tension: f64,
}

impl<R: Borrow<Reference>> PairController<R> {
    /// Armed controllers: each starts with its first pose.
    ///
    /// # Errors
    /// When a parameter is out of range.
    pub fn new(
        reference: R,
        parameters: &ControllerParameters<f64>,
        supervisor: SupervisorLimits<f64>,
    ) -> Result<Self, ParameterError> {
        let robot = RobotLink {
            controller: RobotController::new(parameters)?,
            heard: None,
            felt: None,
            velocity: Velocity::default(),
            tension: 0.0,
        };
        Ok(Self {
            targets: reference.borrow().at(0.0),
            reference,
            robots: [robot.clone(), robot],
            supervisor: PairSupervisor::new(supervisor)?,
            time: None,
        })
    }

    /// One tick, best 500 times a second: takes what has arrived since the last one and returns what each robot is to do until the
    /// next. `time` counts from the start of the run, s, on the clock of the reference.
    pub fn tick(&mut self, measured: [Measurement; 2], time: f64) -> [Command; 2] {
        let last = self.time.unwrap_or(time);
        let time = if time.is_finite() {
            time
        } else {
            // Without a clock there is no reference.
            self.stop();
            self.time.unwrap_or(0.0)
        };
        let dt = time - last;
        self.time = Some(time);
        self.targets = self.reference.borrow().at(time);
        let limit = self.supervisor.limits().silence;
        let mut commands = [Command::default(); 2];
        for side in Side::BOTH {
            let i = side.index();
            let torque = self.robots[i].tick(&measured[i], &self.targets[i], time, dt, limit);
            commands[i].torque = torque;
        }
        self.supervise(time);
        for (command, robot) in commands.iter_mut().zip(&self.robots) {
            command.velocity = robot.controller.commanded();
            command.mode = robot.controller.mode();
        }
        commands
    }

    /// Where both robots should be at the last tick.
    pub fn targets(&self) -> &[Sample; 2] {
        &self.targets
    }

    /// Why the pair stands, once it has been stopped; latched.
    pub fn stopped(&self) -> Option<PairStop> {
        match self.supervisor.state() {
            PairState::Running => None,
            PairState::Stopped { cause, robot } => Some(PairStop {
                cause,
                robot: match robot {
                    PairRobot::Left => Side::Left,
                    PairRobot::Right => Side::Right,
                },
            }),
        }
    }

    /// What each controller has learned.
    pub fn adapted(&self) -> [AdaptedParameters<f64>; 2] {
        self.robots.each_ref().map(|r| r.controller.adapted())
    }

    /// Stops both, for a reason of the caller's; latched.
    pub fn stop(&mut self) {
        for robot in &mut self.robots {
            robot.controller.stop(StopCause::Supervisor);
        }
    }

    /// Ends a latched stop: each robot starts again with its next pose, with nothing adapted. The run goes on where the
    /// reference is at the time of the next tick.
    pub fn rearm(&mut self) {
        self.supervisor.rearm();
        for robot in &mut self.robots {
            robot.controller.rearm();
            (robot.heard, robot.felt) = (None, None);
        }
    }

    fn supervise(&mut self, time: f64) {
        let [left, right] = self.robots.each_ref().map(|robot| robot.report(time));
        if self.supervisor.update(&left, &right) != PairState::Running {
            self.stop();
        }
    }
}

impl RobotLink {
    fn tick(
        &mut self,
        measured: &Measurement,
        target: &Sample,
        time: f64,
        dt: f64,
        silence: f64,
    ) -> WheelTorque<f64> {
        let heard = self.heard.get_or_insert(time);
        if measured.is_something() {
            *heard = time;
        }
        let felt = self.felt.get_or_insert(time);
        if let Some(velocity) = measured.velocity {
            (*felt, self.velocity) = (time, velocity);
        }
        let is_blind = time - *felt > silence;
        self.tension = measured.tension.unwrap_or(self.tension);
        if let Some(fix) = measured.pose {
            self.controller
                .track(&fix.pose, fix.age, &control_sample(target));
        }
        if is_blind {
            self.controller.blind(dt)
        } else {
            self.controller.torque(self.velocity, dt)
        }
    }

    fn report(&self, time: f64) -> RobotReport<f64> {
        let error = self.controller.error();
        RobotReport {
            tracking_error: libm::hypot(error.along, error.across),
            silence: time - self.heard.unwrap_or(time),
            tension: self.tension,
            stopped: match self.controller.mode() {
                Mode::Stopping(cause) | Mode::Stopped(cause) => Some(cause),
                Mode::Armed | Mode::Running => None,
            },
        }
    }
}
