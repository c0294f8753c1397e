use super::FORMAT;
use super::file::{
    ExecutionFigures, File, FileConditions, FileDrag, FileEnd, FileEvent, FileOptions,
    FileReference, FileTracking, FileTrial, Quantiles, Sides,
};
use crate::files::parts::{FileClaim, FileCost, Reference, finite};
use pairtrawl_execution::{ExecutionOptions, quantile};
use pairtrawl_geometry::Pose;
use pairtrawl_model::{
    DragStatistics, Execution, ExecutionEvent, SceneReference, TrackingStatistics, Trial,
    TrialConditions,
};

/// The execution with the options that it was made with, as JSON with a line end. Numbers are the shortest that read back
/// as the same bits; a quantile of nothing is null. Samples and frames are not part of it.
pub fn execution_json(
    execution: &Execution,
    options: &ExecutionOptions,
    scene: &SceneReference,
) -> String {
    // Only maps with keys other than strings cannot be JSON, and there are no maps here.
    let mut text =
        serde_json::to_string_pretty(&file(execution, options, scene)).unwrap_or_default();
    text.push('\n');
    text
}

fn file(execution: &Execution, options: &ExecutionOptions, scene: &SceneReference) -> File {
    let certificate = &execution.reference_certificate;
    File {
        format: FORMAT,
        scene: Reference::from(scene),
        controller: execution.controller.name(),
        net_length: execution.net_length,
        reference: FileReference {
            duration: execution.reference_duration,
            valid: certificate.is_valid(),
            claims: certificate.claims.iter().map(FileClaim::from).collect(),
        },
        options: FileOptions::from(options),
        left: (execution.trials.first()).map_or_else(Vec::new, |trial| trial.left.clone()),
        trials_wanted: execution.trials_wanted,
        interrupted: execution.interrupted,
        summary: ExecutionFigures::from(execution),
        trials: (execution.trials.iter())
            .map(|drive| trial(execution, drive))
            .collect(),
        warnings: execution.warnings.iter().map(ToString::to_string).collect(),
    }
}

impl From<&ExecutionOptions> for FileOptions {
    fn from(options: &ExecutionOptions) -> Self {
        Self {
            seed: options.seed,
            robot_mass: options.robot_mass,
            robot_inertia: options.robot_inertia,
            object_mass: options.object_mass,
            payload: options.payload,
            friction: options.friction,
            pose_delay: options.pose_delay,
            velocity_delay: options.velocity_delay,
            odometry_scale: options.odometry_scale,
            position_noise: options.sensing.position_noise,
            heading_noise: options.sensing.heading_noise,
            time_step: options.physics.time_step,
            feedback: options.law.feedback,
            rates: options.law.rates,
            adapts: {
                let adapts = options.law.adapts;
                [adapts.state, adapts.input, adapts.bias]
            },
            torque_limit: options.law.torque_limit,
            nominal_inertia: options.nominal_inertia.name(),
            stop_error: options.supervisor.tracking_error,
        }
    }
}

impl From<&Execution> for ExecutionFigures {
    fn from(execution: &Execution) -> Self {
        let trials = &execution.trials;
        let all = trials.iter().filter(|t| t.gathered_everything()).count();
        let of = |value: &dyn Fn(&Trial) -> f64| {
            let mut values: Vec<f64> = trials.iter().map(value).collect();
            let [median, p90, greatest] = [0.5, 0.9, 1.0].map(|q| finite(quantile(&mut values, q)));
            Quantiles {
                median,
                p90,
                greatest,
            }
        };
        let worse = |error: fn(&TrackingStatistics) -> f64| {
            of(&|t: &Trial| error(&t.tracking[0]).max(error(&t.tracking[1])))
        };
        Self {
            trials: trials.len(),
            gathered_everything: all,
            gathered_rate: finite(all as f64 / trials.len() as f64),
            without_events: trials.iter().filter(|t| t.events.is_empty()).count(),
            rms: worse(|t| t.rms),
            max: worse(|t| t.max),
            settled_rms: worse(|t| t.settled_rms),
            settled_max: worse(|t| t.settled_max),
            cost: of(&|t| t.cost.total()),
        }
    }
}

fn sides<T, U>([left, right]: [T; 2], file: impl Fn(T) -> U) -> Sides<U> {
    Sides {
        left: file(left),
        right: file(right),
    }
}

fn trial(execution: &Execution, trial: &Trial) -> FileTrial {
    FileTrial {
        index: trial.index,
        seed: trial.seed,
        controller: execution.controller.name(),
        conditions: conditions(&trial.conditions),
        gathered: trial.gathered.clone(),
        events: trial.events.iter().map(event).collect(),
        tracking: sides(trial.tracking, tracking),
        cost: FileCost::from(trial.cost),
        drag: sides(trial.drag, |DragStatistics { mean, max }| FileDrag {
            mean,
            max,
        }),
        max_torque: sides(trial.max_torque, |t| t),
        end: end(trial),
        duration: trial.duration,
        seconds: trial.seconds,
    }
}

fn conditions(c: &TrialConditions) -> FileConditions {
    FileConditions {
        robot_mass_factor: c.robot_mass_factor,
        robot_inertia_factor: c.robot_inertia_factor,
        object_masses: c.object_masses.clone(),
        friction_factor: c.friction_factor,
        pose_delay: c.pose_delay,
        velocity_delay: c.velocity_delay,
        odometry_scale: c.odometry_scale,
    }
}

fn event(e: &ExecutionEvent) -> FileEvent {
    FileEvent {
        time: e.time,
        place: e.place.into(),
        event: e.kind.describe(),
    }
}

fn tracking(t: TrackingStatistics) -> FileTracking {
    FileTracking {
        rms: t.rms,
        max: t.max,
        settled_rms: t.settled_rms,
        settled_max: t.settled_max,
    }
}

fn end(trial: &Trial) -> FileEnd {
    let last = trial.frames.last();
    let pose = |p: Pose| <[f64; 3]>::from(p);
    FileEnd {
        left: last.map(|f| pose(f.robots.left)),
        right: last.map(|f| pose(f.robots.right)),
        net: last.map_or_else(Vec::new, |f| f.net.iter().map(|&p| p.into()).collect()),
        objects: last.map_or_else(Vec::new, |f| f.objects.iter().map(|&p| pose(p)).collect()),
    }
}
