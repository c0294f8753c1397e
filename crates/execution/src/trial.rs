//! One drive of a plan by controllers in full physics.

use crate::collector::Collector;
use crate::control_loop::{PairLoop, Truth};
use crate::options::controller_parameters;
use crate::pair_controller::PairStop;
use crate::sample::{control_pose, pair_pose};
use crate::sensing::{Normal, Sensing, TORQUE_PERIOD, TRACKER_TICKS};
use crate::statistics::{mixed_seed, trial_seed};
use crate::wheel_speed::Rims;
use crate::{ExecutionError, Host, Task};
use pairtrawl_control::{SupervisorLimits, Velocity, WheelTorque};
use pairtrawl_geometry::Pose;
use pairtrawl_model::{
    ExecutionEvent, ExecutionEventKind, PairTrajectory, Scene, Trial, TrialConditions,
};
use pairtrawl_simulation::{RobotDrive, RobotState, Simulation, Watch};

/// Runs trial `index`. `Ok(None)`: the observer interrupted it.
pub(crate) fn run(task: &Task, host: &Host, index: usize) -> Result<Option<Trial>, ExecutionError> {
    let begin = (host.clock)();
    let options = task.options;
    let seed = trial_seed(options.seed, index);
    let conditions = draw(task, seed);
    let scene = changed(task.scene, &conditions);
    let physics = options.physics.for_control(&scene, TORQUE_PERIOD);
    let time_step = physics.time_step;
    let mut simulation = Simulation::starting_at(
        &scene,
        task.net_length,
        pair_pose(&task.reference.at(0.0)),
        &physics,
    )?;
    let mut watch = Watch::new(&scene, &physics, &simulation);
    let mut collector = Collector::new(time_step, options.sample_interval);
    let sensing = conditions.odometry_scale.map(|odometry_scale| Sensing {
        pose_delay: conditions.pose_delay,
        velocity_delay: conditions.velocity_delay,
        odometry_scale,
        ..options.sensing
    });
    let supervisor = SupervisorLimits {
        tension: scene.physics.tension_limit,
        ..options.supervisor
    };
    let mut control = PairLoop::new(
        task.reference,
        &options.law.applied(controller_parameters(
            task.scene,
            options.controller,
            options.nominal_inertia,
        )),
        supervisor,
        sensing,
        [mixed_seed(seed, 1), mixed_seed(seed, 2)],
    )?;
    let mut stop: Option<ExecutionEvent> = None;
    let mut end = task.reference.duration() + physics.settle_time;
    let substeps = (TORQUE_PERIOD / time_step).round().max(1.0) as u64;
    let mut ticks = 0_u64;
    let mut rims = [Rims::new(&scene); 2];
    while simulation.time() < end {
        let drag = collector.drag();
        let states = simulation.robots();
        let loads = simulation.loads();
        let seen = [0, 1].map(|i| {
            let mut truth = truth(&states[i], drag[i]);
            truth.velocity = rims[i].tick(loads[i].torques, truth.velocity, TORQUE_PERIOD);
            truth
        });
        let torques = control.tick(seen);
        for _ in 0..substeps {
            simulation.step(torques.map(|t| drive(&t)))?;
            // Deviations are what the collector measures.
            watch.observe(&simulation, || None);
            collector.step(&simulation);
        }
        ticks += 1;
        if ticks.is_multiple_of(TRACKER_TICKS) {
            collector.compare(&simulation, &task.reference.at(simulation.time()), &control);
        }
        if stop.is_none()
            && let Some(PairStop { cause, robot }) = control.stopped()
        {
            // A stopped pair is watched for a second more: it must come to rest.
            end = end.min(simulation.time() + 1.0);
            stop = Some(ExecutionEvent {
                kind: ExecutionEventKind::PairStopped {
                    cause: cause.to_string(),
                    robot,
                },
                time: simulation.time(),
                place: simulation.robots()[robot.index()].pose.position(),
            });
        }
        if ticks.is_multiple_of(250) {
            if host.observer.interrupted() {
                return Ok(None);
            }
            host.observer
                .progressed(index, (simulation.time() / end).min(1.0));
        }
    }
    let cost = (host.cost)(&driven(task, &collector));
    let record = watch.finish(&simulation);
    let physical = |e: &pairtrawl_model::RehearsalEvent| ExecutionEvent {
        kind: ExecutionEventKind::Physical(e.kind),
        time: e.time,
        place: e.place,
    };
    let mut events: Vec<ExecutionEvent> = record.events.iter().map(physical).chain(stop).collect();
    events.sort_by(|a, b| a.time.total_cmp(&b.time));
    Ok(Some(Trial {
        index,
        seed,
        conditions,
        gathered: record.gathered,
        left: record.left,
        events,
        tracking: collector.tracking(),
        cost,
        drag: collector.drag_statistics(),
        max_torque: collector.max_torque(),
        frames: record.frames,
        samples: collector.into_samples(),
        duration: simulation.time(),
        seconds: (host.clock)() - begin,
    }))
}

fn draw(task: &Task, seed: u64) -> TrialConditions {
    let options = task.options;
    let mut draw = Normal::new(seed);
    let mut object_masses: Vec<f64> = task
        .scene
        .objects
        .iter()
        .map(|o| {
            options
                .object_mass
                .map_or(o.mass, |range| draw.between(range))
        })
        .collect();
    if let Some(payload) = options.payload {
        let total: f64 = object_masses.iter().sum();
        object_masses.iter_mut().for_each(|m| *m *= payload / total);
    }
    TrialConditions {
        robot_mass_factor: draw.between(options.robot_mass),
        robot_inertia_factor: draw.between(options.robot_inertia),
        object_masses,
        friction_factor: draw.between(options.friction),
        pose_delay: draw.between(options.pose_delay),
        velocity_delay: draw.between(options.velocity_delay),
        odometry_scale: [
            draw.between(options.odometry_scale),
            draw.between(options.odometry_scale),
        ],
    }
}

/// The scene as the trial finds it; the controllers keep to the scene as it is written.
fn changed(scene: &Scene, conditions: &TrialConditions) -> Scene {
    let mut scene = scene.clone();
    scene.physics.robot_mass *= conditions.robot_mass_factor;
    scene.physics.robot_inertia *= conditions.robot_inertia_factor;
    scene.physics.net_friction *= conditions.friction_factor;
    scene.physics.object_friction *= conditions.friction_factor;
    for (object, mass) in scene.objects.iter_mut().zip(&conditions.object_masses) {
        object.mass = *mass;
    }
    scene
}

fn truth(state: &RobotState, tension: f64) -> Truth {
    Truth {
        pose: control_pose(state.pose),
        velocity: Velocity {
            linear: state.forward,
            angular: state.turn_rate,
        },
        tension,
    }
}

fn drive(torque: &WheelTorque<f64>) -> RobotDrive {
    RobotDrive::Torques {
        left: torque.left,
        right: torque.right,
    }
}

/// The poses at the instants at which the reference passes the plan's waypoints, for as far as the pair came.
fn driven(task: &Task, collector: &Collector) -> PairTrajectory {
    let samples = collector.samples();
    let mut driven = PairTrajectory {
        step_time: task.trajectory.step_time,
        ..PairTrajectory::default()
    };
    for i in 0..task.reference.waypoints() {
        let time = task.reference.waypoint_time(i);
        let after = samples.partition_point(|s| s.time < time);
        let Some(b) = samples.get(after) else { break };
        let a = &samples[after.saturating_sub(1)];
        let part = if b.time > a.time {
            (time - a.time) / (b.time - a.time)
        } else {
            0.0
        };
        let between = |a: Pose, b: Pose| a.lerp(b, part.clamp(0.0, 1.0));
        driven.left.push(between(a.robots.left, b.robots.left));
        driven.right.push(between(a.robots.right, b.robots.right));
    }
    driven
}
