//! `execution.json`, format `pairtrawl-execution/1`.

use super::statistics::quantile;
use crate::files::{FileError, write_atomically};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Cost, DragStatistics, Execution, ExecutionEvent, SceneReference, TrackingStatistics, Trial,
    TrialConditions,
};
use serde::Serialize;
use std::path::Path;

/// Writes `execution.json` atomically.
///
/// # Errors
/// When the system refuses (exit code 8).
pub fn write_execution(
    path: &Path,
    execution: &Execution,
    scene: &SceneReference,
) -> Result<(), FileError> {
    write_atomically(path, execution_json(execution, scene).as_bytes())
}

/// The execution as JSON with a line end. Numbers are the shortest that read back as the same bits; a quantile of nothing is
/// null. Samples and frames are not part of it.
pub fn execution_json(execution: &Execution, scene: &SceneReference) -> String {
    let file = File {
        format: "pairtrawl-execution/1",
        scene: FileScene {
            name: &scene.name,
            sha256: &scene.sha256,
        },
        controller: execution.controller.name(),
        net_length: execution.net_length,
        reference: FileReference {
            duration: execution.reference_duration,
            valid: execution.reference_certificate.is_valid(),
            claims: execution
                .reference_certificate
                .claims
                .iter()
                .map(|c| FileClaim {
                    name: c.id.name(),
                    holds: c.holds,
                    margin: c.margin,
                })
                .collect(),
        },
        trials_wanted: execution.trials_wanted,
        interrupted: execution.interrupted,
        summary: summary(execution),
        trials: execution
            .trials
            .iter()
            .map(|t| trial(execution, t))
            .collect(),
        warnings: &execution.warnings,
    };
    // Maps with keys that are no strings are the one thing that JSON refuses; there are none here.
    let mut text = serde_json::to_string_pretty(&file).unwrap_or_default();
    text.push('\n');
    text
}

#[derive(Serialize)]
struct File<'a> {
    format: &'static str,
    scene: FileScene<'a>,
    controller: &'static str,
    net_length: f64,
    reference: FileReference,
    trials_wanted: usize,
    interrupted: bool,
    summary: FileSummary,
    trials: Vec<FileTrial<'a>>,
    warnings: &'a [String],
}

#[derive(Serialize)]
struct FileScene<'a> {
    name: &'a str,
    sha256: &'a str,
}

#[derive(Serialize)]
struct FileReference {
    duration: f64,
    valid: bool,
    claims: Vec<FileClaim>,
}

#[derive(Serialize)]
struct FileClaim {
    name: &'static str,
    holds: bool,
    margin: f64,
}

#[derive(Serialize)]
struct FileSummary {
    trials: usize,
    gathered_everything: usize,
    gathered_rate: f64,
    without_events: usize,
    rms: Quantiles,
    max: Quantiles,
    cost: Quantiles,
}

#[derive(Serialize)]
struct Quantiles {
    median: f64,
    p90: f64,
    greatest: f64,
}

#[derive(Serialize)]
struct FileTrial<'a> {
    index: usize,
    seed: u64,
    controller: &'static str,
    conditions: FileConditions<'a>,
    gathered: &'a [bool],
    events: Vec<FileEvent>,
    tracking: Sides<FileTracking>,
    cost: FileCost,
    drag: Sides<FileDrag>,
    max_torque: Sides<f64>,
    #[serde(rename = "final")]
    end: FileEnd,
    duration: f64,
    seconds: f64,
}

#[derive(Serialize)]
struct Sides<T> {
    left: T,
    right: T,
}

#[derive(Serialize)]
struct FileConditions<'a> {
    robot_mass_factor: f64,
    robot_inertia_factor: f64,
    object_masses: &'a [f64],
    friction_factor: f64,
    pose_delay: f64,
    velocity_delay: f64,
    odometry_scale: [f64; 2],
}

#[derive(Serialize)]
struct FileEvent {
    time: f64,
    #[serde(rename = "where")]
    place: [f64; 2],
    event: String,
}

#[derive(Serialize)]
struct FileTracking {
    rms: f64,
    max: f64,
    settled_rms: f64,
    settled_max: f64,
}

#[derive(Serialize)]
struct FileCost {
    total: f64,
    smoothness: f64,
    distance: f64,
    obstacle: f64,
    expansion: f64,
}

#[derive(Serialize)]
struct FileDrag {
    mean: f64,
    max: f64,
}

#[derive(Serialize)]
struct FileEnd {
    left: [f64; 3],
    right: [f64; 3],
    net: Vec<[f64; 2]>,
    objects: Vec<[f64; 3]>,
}

fn sides<T, U>([left, right]: [T; 2], file: impl Fn(T) -> U) -> Sides<U> {
    Sides {
        left: file(left),
        right: file(right),
    }
}

fn summary(execution: &Execution) -> FileSummary {
    let trials = &execution.trials;
    let all = trials.iter().filter(|t| t.gathered_everything()).count();
    let of = |value: &dyn Fn(&Trial) -> f64| {
        let mut values: Vec<f64> = trials.iter().map(value).collect();
        let [median, p90, greatest] = [0.5, 0.9, 1.0].map(|q| quantile(&mut values, q));
        Quantiles {
            median,
            p90,
            greatest,
        }
    };
    FileSummary {
        trials: trials.len(),
        gathered_everything: all,
        gathered_rate: all as f64 / trials.len() as f64,
        without_events: trials.iter().filter(|t| t.events.is_empty()).count(),
        rms: of(&|t| t.tracking[0].rms.max(t.tracking[1].rms)),
        max: of(&|t| t.tracking[0].max.max(t.tracking[1].max)),
        cost: of(&|t| t.cost.total()),
    }
}

fn trial<'a>(execution: &Execution, trial: &'a Trial) -> FileTrial<'a> {
    FileTrial {
        index: trial.index,
        seed: trial.seed,
        controller: execution.controller.name(),
        conditions: conditions(&trial.conditions),
        gathered: &trial.gathered,
        events: trial.events.iter().map(event).collect(),
        tracking: sides(trial.tracking, tracking),
        cost: cost(trial.cost),
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

fn conditions(c: &TrialConditions) -> FileConditions<'_> {
    FileConditions {
        robot_mass_factor: c.robot_mass_factor,
        robot_inertia_factor: c.robot_inertia_factor,
        object_masses: &c.object_masses,
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

fn cost(c: Cost) -> FileCost {
    FileCost {
        total: c.total(),
        smoothness: c.smoothness,
        distance: c.distance,
        obstacle: c.obstacle,
        expansion: c.expansion,
    }
}

fn end(trial: &Trial) -> FileEnd {
    let last = trial.frames.last();
    let pose = |p: Pose| <[f64; 3]>::from(p);
    FileEnd {
        left: last.map_or([f64::NAN; 3], |f| pose(f.robots.left)),
        right: last.map_or([f64::NAN; 3], |f| pose(f.robots.right)),
        net: last.map_or_else(Vec::new, |f| {
            f.net.iter().map(|&p: &Point| p.into()).collect()
        }),
        objects: last.map_or_else(Vec::new, |f| f.objects.iter().map(|&p| pose(p)).collect()),
    }
}
