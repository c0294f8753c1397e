//! A run of the Monte-Carlo table in full physics: robots, net and objects.

use crate::monte_carlo_options::MonteCarloOptions;
use crate::observer::ExecutionObserver;
use crate::outcome::Outcome;
use crate::statistics::mixed_seed;
use crate::{ExecutionError, ExecutionOptions, Host, Normal, Sensing, Task, trial};
use pairtrawl_model::{ControllerKind, Cost, ExecutionEventKind, PairTrajectory, Scene};
use pairtrawl_reference::Reference;

/// What the run is drawn from and driven with.
pub(crate) struct FullRun<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) trajectory: &'a PairTrajectory,
    pub(crate) reference: &'a Reference,
    pub(crate) net_length: f64,
    pub(crate) physics: pairtrawl_simulation::Options,
    pub(crate) options: &'a MonteCarloOptions,
}

/// Frames and samples are not kept; so seldom, s, they do not cost anything.
const SELDOM: f64 = 10.0;

impl FullRun<'_> {
    /// Drives the run with this number. Both robots have the same mass and inertia; the objects together weigh what takes the
    /// drawn drag of both robots to slide.
    ///
    /// # Errors
    /// When scene or options cannot be used.
    pub(crate) fn drive(
        &self,
        kind: ControllerKind,
        run: u64,
        observer: &dyn ExecutionObserver,
    ) -> Result<Option<Outcome>, ExecutionError> {
        let from = self.options;
        let physics = &self.scene.physics;
        let mut draw = Normal::new(mixed_seed(from.seed, run));
        let drag = draw.between(from.drag) + draw.between(from.drag);
        let delay = draw.between(from.delay);
        let weight = physics.object_friction * physics.gravity;
        let velocity_delay = match from.delayed_velocity {
            true => [delay; 2],
            false => [Sensing::default().velocity_delay; 2],
        };
        let options = ExecutionOptions {
            controller: kind,
            trials: 1,
            seed: mixed_seed(from.seed, run),
            robot_mass: from.mass_factor,
            robot_inertia: from.inertia_factor,
            payload: (weight > 0.0 && drag > 0.0).then(|| drag / weight),
            pose_delay: [delay; 2],
            velocity_delay,
            odometry_scale: [1.0; 2],
            sensing: Sensing {
                position_noise: from.position_noise,
                heading_noise: from.heading_noise,
                ..Sensing::default()
            },
            nominal_inertia: from.nominal_inertia,
            physics: pairtrawl_simulation::Options {
                frame_interval: SELDOM,
                ..self.physics
            },
            sample_interval: SELDOM,
            ..ExecutionOptions::default()
        };
        options.validate()?;
        let task = Task {
            scene: self.scene,
            net_length: self.net_length,
            trajectory: self.trajectory,
            reference: self.reference,
            options: &options,
        };
        // The run's progress is not that of one among a few trials.
        let quiet = Quiet(observer);
        let host = Host {
            clock: &|| 0.0,
            cost: &|_| Cost::default(),
            observer: &quiet,
        };
        let Some(trial) = trial::run(&task, &host, 0)? else {
            return Ok(None);
        };
        let traction = physics.wheel_friction
            * physics.robot_mass
            * trial.conditions.robot_mass_factor
            * physics.gravity;
        let stops =
            |kind: &ExecutionEventKind| matches!(kind, ExecutionEventKind::PairStopped { .. });
        let gathered = trial.gathered.iter().enumerate();
        let gathered = gathered.filter(|(object, home)| **home && !trial.left.contains(object));
        Ok(Some(Outcome {
            tracking: trial.tracking,
            stopped: trial.events.iter().any(|event| stops(&event.kind)),
            max_torque: trial.max_torque[0].max(trial.max_torque[1]),
            beyond_traction: trial.drag.iter().any(|drag| drag.max > traction),
            gathered: gathered.count(),
        }))
    }
}

/// Asks whether to go on, and tells nothing.
struct Quiet<'a>(&'a dyn ExecutionObserver);

impl ExecutionObserver for Quiet<'_> {
    fn interrupted(&self) -> bool {
        self.0.interrupted()
    }
}
