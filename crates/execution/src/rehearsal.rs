//! The rehearsal: the pair drives its reference closely, with the tracking law of the controllers at stiff gains and perfect
//! sensors, so that what goes wrong is the plan's doing.

use crate::sample::{control_pose, control_sample, pair_pose};
use pairtrawl_control::{TrackingError, TrackingGains, Velocity, desired_velocity};
use pairtrawl_model::{RehearsalRecord, Robot, Scene, Units};
use pairtrawl_reference::{Reference, Sample};
use pairtrawl_simulation::{Options, RobotDrive, RobotState, Simulation, SimulationError, Watch};

/// How much faster than v_max a wheel may turn to catch up.
const HEADROOM: f64 = 1.2;

/// Drives a reference in physics and reports what happened. Options are those for a machine of the paper's size: see
/// [`Options::for_scene`].
///
/// # Errors
/// When scene, net length or options cannot be simulated. A plan that goes wrong is a record, not an error.
pub fn rehearse(
    scene: &Scene,
    net_length: f64,
    reference: &Reference,
    options: &Options,
) -> Result<RehearsalRecord, SimulationError> {
    rehearse_while(scene, net_length, reference, options, &|| true)
}

/// As [`rehearse()`], and asks before every step whether it may go on. When it may not, the record is of the drive until then.
///
/// # Errors
/// As [`rehearse()`].
pub fn rehearse_while(
    scene: &Scene,
    net_length: f64,
    reference: &Reference,
    options: &Options,
    may_go_on: &dyn Fn() -> bool,
) -> Result<RehearsalRecord, SimulationError> {
    let start = pair_pose(&reference.at(0.0));
    let mut simulation =
        Simulation::starting_at(scene, net_length, start, &options.for_scene(scene))?;
    drive(&mut simulation, scene, reference, options, may_go_on)
}

/// The same in a simulation of the scene that was set up with these options and stands at the reference's start.
///
/// # Errors
/// When the physics diverges.
pub fn rehearse_in(
    simulation: &mut Simulation,
    scene: &Scene,
    reference: &Reference,
    options: &Options,
) -> Result<RehearsalRecord, SimulationError> {
    drive(simulation, scene, reference, options, &|| true)
}

fn drive(
    simulation: &mut Simulation,
    scene: &Scene,
    reference: &Reference,
    options: &Options,
    may_go_on: &dyn Fn() -> bool,
) -> Result<RehearsalRecord, SimulationError> {
    let options = &options.for_scene(scene);
    let mut watch = Watch::new(scene, options, simulation);
    let gains = stiff_gains(&simulation.units());
    let time_step = options.time_step;
    let steps = ((reference.duration() + options.settle_time) / time_step).ceil() as u64;
    for _ in 0..steps {
        if !may_go_on() {
            break;
        }
        let targets = reference.at(simulation.time() + time_step);
        let [left, right] = simulation.robots();
        simulation.step([
            follow(&gains, &scene.robot, &left, &targets[0]),
            follow(&gains, &scene.robot, &right, &targets[1]),
        ])?;
        watch.observe(simulation, || {
            Some(pair_pose(&reference.at(simulation.time())))
        });
    }
    Ok(watch.finish(simulation))
}

/// k1 = k3 = 10 and k2 = 400 in units of the machine.
fn stiff_gains(&Units { length, time, .. }: &Units) -> TrackingGains<f64> {
    TrackingGains {
        along: 10.0 / time,
        across: 400.0 / (length * length),
        heading: 10.0 / time,
        ..TrackingGains::default()
    }
}

/// The velocity of the tracking law. Where a wheel would have to turn faster than the robot or its reference can, speed and
/// turning are scaled down alike.
fn follow(
    gains: &TrackingGains<f64>,
    robot: &Robot,
    state: &RobotState,
    target: &Sample,
) -> RobotDrive {
    let reference = control_sample(target);
    let error = TrackingError::between(&control_pose(state.pose), &reference.pose, 0.0);
    let measured = Velocity {
        linear: state.forward,
        angular: state.turn_rate,
    };
    let wanted = desired_velocity(gains, &error, &reference, measured).velocity;
    let wheel = |v: f64, w: f64| v.abs() + robot.half_track * w.abs();
    let limit = HEADROOM * robot.v_max.max(wheel(target.v, target.omega));
    let scale = (limit / wheel(wanted.linear, wanted.angular)).min(1.0);
    RobotDrive::Velocity {
        forward: wanted.linear * scale,
        turn_rate: wanted.angular * scale,
    }
}
