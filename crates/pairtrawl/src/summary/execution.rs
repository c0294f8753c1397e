use super::frames;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    ControlSample, Event, Execution, ExecutionSummary, Limit, Line, PairPose, Panel, Ribbon, Role,
    Sampling, Scene, Trial, TrialSummary,
};

/// Computes what reports show of an execution: each trial's figures, the bands of the driven paths over all trials,
/// and one trial in motion with its curves: the first that left something behind, or else the first.
///
/// The result goes into [`pairtrawl_model::Summary::execution`].
pub fn summarize_execution(scene: &Scene, execution: &Execution) -> ExecutionSummary {
    let trials = &execution.trials;
    let failed = trials.iter().position(|t| !t.gathered_everything());
    let shown = failed.unwrap_or(0);
    let trial = trials.get(shown);
    ExecutionSummary {
        controller: execution.controller.name().to_owned(),
        trials: trials.iter().map(trial_summary).collect(),
        trials_wanted: execution.trials_wanted,
        shown,
        frames: trial.and_then(|t| frames::of(&t.frames, events(t), scene)),
        panels: trial.map_or(Vec::new(), |t| panels(scene, &t.samples)),
        left_ribbon: ribbon(trials, |pair| pair.left),
        right_ribbon: ribbon(trials, |pair| pair.right),
    }
}

fn events(trial: &Trial) -> Vec<Event> {
    let event = |e: &pairtrawl_model::ExecutionEvent| Event {
        time: e.time,
        place: e.place,
        text: e.kind.describe(),
    };
    trial.events.iter().map(event).collect()
}

fn trial_summary(trial: &Trial) -> TrialSummary {
    TrialSummary {
        seed: trial.seed,
        gathered: trial.gathered_count(),
        complete: trial.gathered_everything(),
        tracking: trial.tracking,
        cost: trial.cost,
        event: events(trial).into_iter().next(),
    }
}

/// Tracking error, drag, torques and what the law has learned, over time.
fn panels(scene: &Scene, samples: &[ControlSample]) -> Vec<Panel> {
    if samples.is_empty() {
        return Vec::new();
    }
    let times: Vec<f64> = samples.iter().map(|s| s.time).collect();
    let line = |label: &str, role, value: &dyn Fn(&ControlSample) -> f64| Line {
        label: label.to_owned(),
        role,
        values: samples.iter().map(value).collect(),
    };
    let panel = |key: &str, title: &str, unit: &str, lines, limits: &[f64]| Panel {
        key: key.to_owned(),
        title: title.to_owned(),
        unit: unit.to_owned(),
        times: times.clone(),
        sampling: Sampling::Instant,
        lines,
        limits: limits
            .iter()
            .map(|v| Limit {
                label: "limit".to_owned(),
                value: *v,
            })
            .collect(),
    };
    let both = |of: &dyn Fn(&ControlSample, usize) -> f64| {
        vec![
            line("left", Role::Left, &|s| of(s, 0)),
            line("right", Role::Right, &|s| of(s, 1)),
        ]
    };
    let wheels = |robot: usize| {
        vec![
            line("left wheel", Role::Left, &|s| s.torque[robot][0]),
            line("right wheel", Role::Right, &|s| s.torque[robot][1]),
        ]
    };
    let gains = |of: &dyn Fn(&ControlSample) -> [f64; 4], labels: [&str; 4]| {
        let entry = |k: usize| line(labels[k], Role::Other, &|s| of(s)[k]);
        (0..4).map(entry).collect::<Vec<_>>()
    };
    let torque_limit = [scene.physics.max_torque, -scene.physics.max_torque];
    let mut panels = vec![
        panel(
            "tracking_error",
            "Tracking error",
            "m",
            both(&|s, k| s.error[k]),
            &[],
        ),
        panel(
            "drag",
            "Drag of net and contacts",
            "N",
            both(&|s, k| s.drag[k]),
            &[],
        ),
        panel(
            "torque_left",
            "Torque, left robot",
            "N m",
            wheels(0),
            &torque_limit,
        ),
        panel(
            "torque_right",
            "Torque, right robot",
            "N m",
            wheels(1),
            &torque_limit,
        ),
    ];
    let state = ["force by v", "force by w", "torque by v", "torque by w"];
    let learned = [
        panel(
            "force_bias",
            "Learned force",
            "N",
            both(&|s, k| s.bias[k][0]),
            &[],
        ),
        panel(
            "torque_bias",
            "Learned torque",
            "N m",
            both(&|s, k| s.bias[k][1]),
            &[],
        ),
        panel(
            "state_gain_left",
            "Learned Delta_X, left robot",
            "",
            gains(&|s| s.state_gain[0], state),
            &[],
        ),
        panel(
            "state_gain_right",
            "Learned Delta_X, right robot",
            "",
            gains(&|s| s.state_gain[1], state),
            &[],
        ),
        panel(
            "input_gain_left",
            "Learned Delta_m, left robot",
            "",
            gains(&|s| s.input_gain[0], INPUT),
            &[],
        ),
        panel(
            "input_gain_right",
            "Learned Delta_m, right robot",
            "",
            gains(&|s| s.input_gain[1], INPUT),
            &[],
        ),
    ];
    // A law that learns nothing has nothing to show here.
    let moves = |p: &Panel| p.lines.iter().flat_map(|l| &l.values).any(|v| *v != 0.0);
    panels.extend(learned.into_iter().filter(moves));
    panels
}

const INPUT: [&str; 4] = ["row 1, v", "row 1, w", "row 2, v", "row 2, w"];

/// Mean path of a robot over the trials and the band across it that holds all of them, at the instants that all trials
/// have in common; `None` when there are fewer than two of these.
fn ribbon(trials: &[Trial], robot: impl Fn(PairPose) -> Pose) -> Option<Ribbon> {
    let first = &trials.first()?.frames;
    let time = |trial: &Trial, i: usize| trial.frames.get(i).map(|f| f.time);
    let shared = |i: &usize| {
        let t = first[*i].time;
        trials
            .iter()
            .all(|trial| time(trial, *i).is_some_and(|u| (u - t).abs() < 1e-9))
    };
    let count = (0..first.len()).take_while(shared).count();
    if count < 2 {
        return None;
    }
    let places = |i: usize| trials.iter().map(move |t| t.frames[i].robots);
    let mean: Vec<Point> = (0..count)
        .map(|i| {
            places(i).fold(Point::ZERO, |sum, p| sum + robot(p).position()) / trials.len() as f64
        })
        .collect();
    let mut ribbon = Ribbon::default();
    for (i, center) in mean.iter().enumerate() {
        let ahead = mean[(i + 1).min(count - 1)] - mean[i.saturating_sub(1)];
        // Where the robots stand still the normal is that of their heading.
        let ahead = match ahead.norm() > 1e-6 {
            true => ahead / ahead.norm(),
            false => robot(first[i].robots).forward(),
        };
        let across = ahead.perp();
        let offsets = places(i).map(|p| (robot(p).position() - *center).dot(across));
        let (low, high) = offsets.fold((0.0, 0.0), |(l, h): (f64, f64), v| (l.min(v), h.max(v)));
        ribbon.left_border.push(*center + across * high);
        ribbon.right_border.push(*center + across * low);
    }
    ribbon.mean = mean;
    Some(ribbon)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::summary::tests::scene;
    use pairtrawl_model::{ControllerKind, Cost, RehearsalFrame};

    /// Both robots drive along +x; the trial lies `offset` to the left.
    fn trial(offset: f64, gathered: bool, frames: usize) -> Trial {
        let pair = |i: usize| PairPose {
            left: Pose::new(0.1 * i as f64, 2.0 + offset, 0.0),
            right: Pose::new(0.1 * i as f64, 1.0 + offset, 0.0),
        };
        Trial {
            index: 0,
            seed: 7,
            conditions: Default::default(),
            gathered: vec![gathered],
            left: Vec::new(),
            events: Vec::new(),
            tracking: Default::default(),
            cost: Cost::default(),
            drag: Default::default(),
            max_torque: [0.0; 2],
            frames: (0..frames)
                .map(|i| RehearsalFrame {
                    time: 0.5 * i as f64,
                    robots: pair(i),
                    net: vec![Point::ZERO; 3],
                    objects: vec![Pose::default()],
                    tension: [0.0; 2],
                    drive_force: [0.0; 2],
                })
                .collect(),
            samples: (0..4)
                .map(|i| ControlSample {
                    time: i as f64,
                    reference: pair(i),
                    robots: pair(i),
                    forward: [0.2; 2],
                    turn_rate: [0.0; 2],
                    error: [0.01, 0.02],
                    drag: [0.3; 2],
                    torque: [[0.1, 0.2]; 2],
                    bias: [[0.4, 0.0]; 2],
                    state_gain: [[0.0; 4]; 2],
                    input_gain: [[0.0; 4]; 2],
                })
                .collect(),
            duration: 4.0,
            seconds: 0.1,
        }
    }

    fn execution(trials: Vec<Trial>) -> Execution {
        Execution {
            controller: ControllerKind::Mrac,
            net_length: 1.5,
            reference_duration: 4.0,
            reference_certificate: Default::default(),
            trials_wanted: trials.len(),
            trials,
            interrupted: false,
            warnings: Vec::new(),
        }
    }

    #[test]
    fn the_ribbon_holds_every_trial_at_the_instants_they_share() {
        let trials = vec![
            trial(0.0, true, 8),
            trial(0.06, true, 6),
            trial(-0.03, true, 8),
        ];
        let summary = summarize_execution(&scene(), &execution(trials));
        let ribbon = summary.left_ribbon.unwrap();
        assert_eq!(ribbon.mean.len(), 6);
        for i in 0..6 {
            assert!((ribbon.mean[i].y - 2.01).abs() < 1e-12);
            assert!((ribbon.left_border[i].y - 2.06).abs() < 1e-12);
            assert!((ribbon.right_border[i].y - 1.97).abs() < 1e-12);
        }
    }

    #[test]
    fn the_first_failed_trial_is_shown() {
        let trials = vec![
            trial(0.0, true, 3),
            trial(0.0, false, 3),
            trial(0.0, false, 3),
        ];
        assert_eq!(summarize_execution(&scene(), &execution(trials)).shown, 1);
        let none = summarize_execution(&scene(), &execution(Vec::new()));
        assert!(none.frames.is_none() && none.panels.is_empty() && none.left_ribbon.is_none());
    }

    #[test]
    fn only_what_was_learned_is_shown() {
        let summary = summarize_execution(&scene(), &execution(vec![trial(0.0, true, 3)]));
        let keys: Vec<&str> = summary.panels.iter().map(|p| p.key.as_str()).collect();
        assert_eq!(
            keys,
            [
                "tracking_error",
                "drag",
                "torque_left",
                "torque_right",
                "force_bias"
            ]
        );
        assert_eq!(summary.panels[0].lines[1].values, [0.02; 4]);
    }
}
