//! The pair's controller on its own, as a program on real robots would call it.

#[path = "../../simulation/tests/scenes/mod.rs"]
mod scenes;

use pairtrawl_control::{Mode, PairStopCause, StopCause, SupervisorLimits, Velocity, WheelTorque};
use pairtrawl_execution::{
    Command, Measurement, NominalInertia, PairController, PairStop, PoseFix, TORQUE_PERIOD,
    controller_parameters,
};
use pairtrawl_model::{ControllerKind, Scene, Side};
use pairtrawl_reference::Reference;
use pairtrawl_simulation::{Options, RobotDrive, RobotState, Simulation};
use scenes::{cube, empty, straight};
use std::sync::Arc;

/// Steps of 2 ms, as long as a tick.
fn options() -> Options {
    Options {
        time_step: 2e-3,
        ..Options::default()
    }
}

fn scene() -> Scene {
    let mut scene = empty();
    scene.objects = vec![cube(-0.05, 0.5), cube(0.08, 0.9)];
    scene
}

struct Drive {
    controller: PairController<Arc<Reference>>,
    simulation: Simulation,
    commands: [Command; 2],
    ticks: u64,
}

impl Drive {
    fn new() -> Self {
        let scene = scene();
        let reference = Reference::of_scene(&scene, &straight(&scene, 2.0)).unwrap();
        let parameters = controller_parameters(&scene, ControllerKind::Mrac, NominalInertia::Robot);
        let limits = SupervisorLimits::default();
        Self {
            controller: PairController::new(Arc::new(reference), &parameters, limits).unwrap(),
            simulation: Simulation::new(&scene, 1.5, &options()).unwrap(),
            commands: Default::default(),
            ticks: 0,
        }
    }

    /// Drives until a time, s; `arrives` takes away what does not arrive from the right robot.
    fn until(&mut self, end: f64, arrives: impl Fn(&mut Measurement)) {
        while self.simulation.time() < end {
            let [left, right] = self.simulation.robots();
            let mut measured = [self.measure(&left), self.measure(&right)];
            arrives(&mut measured[Side::Right.index()]);
            self.commands = self.controller.tick(measured, self.simulation.time());
            let torques = self.commands.map(|command| command.torque);
            self.simulation.step(torques.map(drive)).unwrap();
            self.ticks += 1;
        }
    }

    /// A pose every 10 ms that is 20 ms old, a velocity every 2 ms.
    fn measure(&self, state: &RobotState) -> Measurement {
        let age = 0.02;
        let pose = state.pose;
        let fix = PoseFix {
            pose: pairtrawl_control::Pose {
                x: pose.x - age * state.forward * libm::cos(pose.heading),
                y: pose.y - age * state.forward * libm::sin(pose.heading),
                heading: pose.heading - age * state.turn_rate,
            },
            age,
        };
        Measurement {
            pose: self.ticks.is_multiple_of(5).then_some(fix),
            velocity: Some(Velocity {
                linear: state.forward,
                angular: state.turn_rate,
            }),
            tension: None,
        }
    }

    fn speeds(&self) -> [f64; 2] {
        self.simulation.robots().map(|robot| robot.forward.abs())
    }

    /// The right robot may have braked without feedback: less than a tenth of its speed is left to friction, and the simulated
    /// wheels have none.
    fn rests(&self) -> bool {
        let still = |command: &Command| command.velocity == Velocity::default();
        let [left, right] = self.speeds();
        left < 1e-3 && right < 0.02 && self.commands.iter().all(still)
    }
}

fn drive(torque: WheelTorque<f64>) -> RobotDrive {
    RobotDrive::Torques {
        left: torque.left,
        right: torque.right,
    }
}

fn nothing(measured: &mut Measurement) {
    *measured = Measurement::default();
}

#[test]
fn the_pair_comes_to_its_end() {
    let mut pair = Drive::new();
    pair.until(12.0, |_| ());
    assert_eq!(pair.controller.stopped(), None);
    for (robot, target) in pair
        .simulation
        .robots()
        .iter()
        .zip(pair.controller.targets())
    {
        let off = robot.pose.position().distance(target.pose.position());
        assert!(off < 0.02, "{off} m from its end");
    }
    assert_eq!(pair.simulation.gathered(), [true, true]);
    assert!(pair.commands.iter().all(|c| c.mode == Mode::Running));
}

#[test]
fn silence_of_one_robot_stops_both_for_good() {
    let mut pair = Drive::new();
    pair.until(4.0, |_| ());
    assert!(
        pair.speeds().iter().all(|v| *v > 0.15),
        "{:?}",
        pair.speeds()
    );
    let before = pair.simulation.robots();
    pair.until(4.09, nothing);
    assert_eq!(pair.controller.stopped(), None, "90 ms are no silence");
    pair.until(4.15, nothing);
    let stop = PairStop {
        cause: PairStopCause::Silence,
        robot: Side::Right,
    };
    assert_eq!(pair.controller.stopped(), Some(stop));
    // The silent robot brakes without feedback.
    let silent = &pair.commands[Side::Right.index()];
    assert_eq!(silent.mode, Mode::Stopping(StopCause::InvalidVelocity));
    pair.until(6.5, nothing);
    assert!(pair.rests(), "{:?} {:?}", pair.speeds(), pair.commands);
    for (now, then) in pair.simulation.robots().iter().zip(&before) {
        let way = now.pose.position().distance(then.pose.position());
        assert!(way < 0.25, "{way} m after the last word");
    }
    pair.until(8.0, |_| ());
    assert_eq!(pair.controller.stopped(), Some(stop), "latched");
    assert!(pair.rests(), "{:?} {:?}", pair.speeds(), pair.commands);
}

#[test]
fn each_missing_sensor_stops_the_pair_with_its_cause() {
    type Loss = fn(&mut Measurement);
    let cases: [(Loss, StopCause); 2] = [
        (|m| m.pose = None, StopCause::StalePose),
        (|m| m.velocity = None, StopCause::InvalidVelocity),
    ];
    for (loss, cause) in cases {
        let mut pair = Drive::new();
        pair.until(3.0, |_| ());
        pair.until(5.0, loss);
        let stop = PairStop {
            cause: PairStopCause::RobotStopped(cause),
            robot: Side::Right,
        };
        assert_eq!(pair.controller.stopped(), Some(stop));
        let left = pair.commands[Side::Left.index()].mode;
        assert_eq!(left, Mode::Stopped(StopCause::Supervisor));
        assert!(pair.rests(), "{cause:?}: {:?}", pair.speeds());
    }
}

#[test]
fn a_rearmed_pair_goes_on() {
    let mut pair = Drive::new();
    pair.until(4.0, |_| ());
    pair.controller.stop();
    pair.until(4.3, |_| ());
    assert!(pair.controller.stopped().is_some());
    pair.controller.rearm();
    pair.until(12.0, |_| ());
    assert_eq!(pair.controller.stopped(), None);
    assert!(pair.commands.iter().all(|c| c.mode == Mode::Running));
}

#[test]
fn without_a_clock_the_pair_stops() {
    let mut pair = Drive::new();
    pair.until(1.0, |_| ());
    for _ in 0..400 {
        let commands = pair.controller.tick(Default::default(), f64::NAN);
        assert!(commands.iter().all(|c| c.torque.is_finite()));
    }
    assert!(pair.controller.stopped().is_some());
}

#[test]
fn ticks_are_as_long_as_steps() {
    assert_eq!(options().time_step, TORQUE_PERIOD);
}
