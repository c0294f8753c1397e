//! Control laws under conditions, driven in full physics.

use crate::drives::{UNLIMITED, drive, errors, first_collision, in_the_net, lost_at};
use crate::lab::{Lab, Stopped};
use pairtrawl::execute::{AdaptedParts, ExecutionOptions, LawOptions, NominalInertia, quantile};
use pairtrawl::model::{ControllerKind, Plan, Scene};
use serde::{Deserialize, Serialize};

/// A law with its gains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    /// A short name.
    pub name: &'static str,
    /// Which one.
    pub kind: ControllerKind,
    /// What it adapts.
    pub adapts: AdaptedParts,
    /// Rates over the default.
    pub rates: f64,
    /// J of its model.
    pub inertia: NominalInertia,
}

const fn adaptive(name: &'static str, state: bool, input: bool, bias: bool) -> Law {
    Law {
        name,
        kind: ControllerKind::Mrac,
        adapts: AdaptedParts { state, input, bias },
        rates: 1.0,
        inertia: NominalInertia::PaperTable,
    }
}

/// The whole adaptive law.
pub const FULL: Law = adaptive("adaptive", true, true, true);
/// Velocity feedback alone: what the authors published as `turtle_adaptive_one.py`.
pub const FEEDBACK: Law = adaptive("K alone", false, false, false);
/// The bias alone.
pub const BIAS: Law = adaptive("bias alone", false, false, true);
/// Delta_X and Delta_m alone: the printed adaptive law.
pub const PRINTED: Law = adaptive("Delta_X, Delta_m", true, true, false);
/// The integral law, which knows the true inertia.
pub const INTEGRAL: Law = Law {
    kind: ControllerKind::Integral,
    inertia: NominalInertia::Robot,
    ..adaptive("integral", true, true, true)
};
/// The integral law with the inertia of the paper's table.
pub const INTEGRAL_TABLE: Law = Law {
    kind: ControllerKind::Integral,
    ..adaptive("integral, J 0.146", true, true, true)
};
/// The model-based law as printed.
pub const MODEL_BASED: Law = Law {
    kind: ControllerKind::ModelBased,
    ..adaptive("model-based", true, true, true)
};

/// What differs from the experiment as it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Condition {
    /// Masses of the objects times those drawn from 15 to 50 g.
    pub load: f64,
    /// Friction of the net on the floor, times the scene's.
    pub net_friction: f64,
    /// Friction of the objects on the floor, times the scene's.
    pub object_friction: f64,
    /// Age of poses, s; `None`: drawn up to 60 ms.
    pub pose_delay: Option<f64>,
    /// Age of velocities, s.
    pub velocity_delay: f64,
    /// Standard deviation of positions, m; that of headings grows with it.
    pub noise: f64,
    /// Greatest torque of a wheel, N m.
    pub torque: Option<f64>,
}

impl Condition {
    /// The experiment as it is.
    pub const PLAIN: Self = Self {
        load: 1.0,
        net_friction: 1.0,
        object_friction: 1.0,
        pose_delay: None,
        velocity_delay: 0.002,
        noise: 0.01,
        torque: None,
    };
}

/// What came of several drives under one condition.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// Drives.
    pub drives: usize,
    /// Of these, how many gathered everything.
    pub complete: usize,
    /// Of these, in how many a robot was lost.
    pub lost: usize,
    /// Quantiles 10, 50, 90 % of the drives' rms errors of the worse robot, m.
    pub rms: [f64; 3],
    /// The same of greatest errors, m.
    pub greatest: [f64; 3],
    /// When the first robot was lost in any drive, s.
    pub first_lost: Option<f64>,
    /// The fewest objects in the net when a robot was lost.
    pub held_when_lost: Option<usize>,
    /// Drives with a collision.
    pub collisions: usize,
}

/// Drives a plan several times by a law under a condition. Drives go on when a robot is lost.
///
/// # Errors
/// When it cannot be driven, or the host stops it.
pub fn driven(
    lab: &Lab,
    scene: &Scene,
    plan: &Plan,
    law: &Law,
    condition: &Condition,
    seeds: usize,
) -> Result<Outcome, Stopped> {
    let mut scene = scene.clone();
    scene.physics.net_friction *= condition.net_friction;
    scene.physics.object_friction *= condition.object_friction;
    scene.physics.tension_limit = UNLIMITED;
    let mut options = ExecutionOptions {
        controller: law.kind,
        trials: seeds,
        object_mass: Some([0.015, 0.05].map(|m| m * condition.load)),
        velocity_delay: [condition.velocity_delay; 2],
        nominal_inertia: law.inertia,
        law: LawOptions {
            rates: law.rates,
            adapts: law.adapts,
            torque_limit: condition.torque,
            ..LawOptions::default()
        },
        ..ExecutionOptions::default()
    };
    if let Some(delay) = condition.pose_delay {
        options.pose_delay = [delay; 2];
    }
    options.supervisor.tracking_error = UNLIMITED;
    options.sensing.heading_noise *= condition.noise / options.sensing.position_noise;
    options.sensing.position_noise = condition.noise;
    let trials = drive(lab, &scene, (&plan.trajectory, plan.net_length), &options)?;
    let quantiles = |mut values: Vec<f64>| [0.1, 0.5, 0.9].map(|q| quantile(&mut values, q));
    let lost = || trials.iter().filter_map(|t| Some((t, lost_at(t)?)));
    Ok(Outcome {
        drives: trials.len(),
        complete: trials.iter().filter(|t| t.gathered_everything()).count(),
        lost: lost().count(),
        rms: quantiles(trials.iter().map(|t| errors(t).0).collect()),
        greatest: quantiles(trials.iter().map(|t| errors(t).1).collect()),
        first_lost: lost().map(|l| l.1).reduce(f64::min),
        held_when_lost: lost().map(|(t, time)| in_the_net(t, time)).min(),
        collisions: trials
            .iter()
            .filter(|t| first_collision(t).is_some())
            .count(),
    })
}
