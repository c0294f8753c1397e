//! The finished summary of an execution, for reports.

use pairtrawl_geometry::Point;
use pairtrawl_model::{
    ControlSample, Event, Execution, ExecutionEvent, ExecutionSummary, Frames, Limit, Line, Panel,
    Ribbon, Role, Sampling, Scene, Trial, TrialSummary,
};

/// Points of a ribbon.
const RIBBON_POINTS: usize = 200;

/// Computes what is shown of an execution; the trial in motion is the first that went wrong, or the first.
pub fn summarize_execution(scene: &Scene, execution: &Execution) -> ExecutionSummary {
    let went_wrong = |t: &Trial| !t.events.is_empty() || !t.gathered_everything();
    let shown = execution.trials.iter().position(went_wrong).unwrap_or(0);
    let trial = execution.trials.get(shown);
    ExecutionSummary {
        controller: execution.controller.name().to_owned(),
        trials: execution.trials.iter().map(trial_summary).collect(),
        shown,
        frames: trial.map(|t| frames(scene, t)),
        panels: trial.map_or_else(Vec::new, |t| panels(scene, &t.samples)),
        left_ribbon: ribbon(execution, |s| s.robots.left.position()),
        right_ribbon: ribbon(execution, |s| s.robots.right.position()),
    }
}

fn trial_summary(trial: &Trial) -> TrialSummary {
    let [left, right] = trial.tracking;
    TrialSummary {
        seed: trial.seed,
        gathered: trial.gathered_count(),
        left_rms: left.rms,
        left_max: left.max,
        right_rms: right.rms,
        right_max: right.max,
        cost: trial.cost,
        event: trial.events.first().map(event),
    }
}

fn event(e: &ExecutionEvent) -> Event {
    Event {
        time: e.time,
        place: e.place,
        text: e.kind.describe(),
    }
}

fn frames(scene: &Scene, trial: &Trial) -> Frames {
    let all = &trial.frames;
    Frames {
        times: all.iter().map(|f| f.time).collect(),
        left: all.iter().map(|f| f.robots.left).collect(),
        right: all.iter().map(|f| f.robots.right).collect(),
        net: all.iter().map(|f| f.net.clone()).collect(),
        objects: all.iter().map(|f| f.objects.clone()).collect(),
        left_tension: all.iter().map(|f| f.tension[0]).collect(),
        right_tension: all.iter().map(|f| f.tension[1]).collect(),
        tension_limit: scene.physics.tension_limit,
        events: trial.events.iter().map(event).collect(),
    }
}

fn panels(scene: &Scene, samples: &[ControlSample]) -> Vec<Panel> {
    type Value = fn(&ControlSample) -> f64;
    let times: Vec<f64> = samples.iter().map(|s| s.time).collect();
    let panel =
        |key: &str, title: &str, unit: &str, lines: &[(&str, Role, Value)], limits: Vec<Limit>| {
            Panel {
                key: key.to_owned(),
                title: title.to_owned(),
                unit: unit.to_owned(),
                times: times.clone(),
                sampling: Sampling::Instant,
                lines: lines
                    .iter()
                    .map(|(label, role, value)| Line {
                        label: (*label).to_owned(),
                        role: *role,
                        values: samples.iter().map(value).collect(),
                    })
                    .collect(),
                limits,
            }
        };
    let limit = |label: &str, value: f64| Limit {
        label: label.to_owned(),
        value,
    };
    let (left, right) = (Role::Left, Role::Right);
    let torque = scene.physics.max_torque;
    let reached = samples
        .iter()
        .flat_map(|s| s.torque)
        .flatten()
        .any(|t| t.abs() > 0.5 * torque);
    let torque_limits = if reached {
        vec![limit("greatest", torque), limit("least", -torque)]
    } else {
        Vec::new()
    };
    vec![
        panel(
            "tracking_error",
            "Tracking error",
            "m",
            &[
                ("left", left, |s| s.error[0]),
                ("right", right, |s| s.error[1]),
            ],
            Vec::new(),
        ),
        panel(
            "drag",
            "Drag on the robots",
            "N",
            &[
                ("left", left, |s| s.drag[0]),
                ("right", right, |s| s.drag[1]),
            ],
            Vec::new(),
        ),
        panel(
            "torque",
            "Wheel torques",
            "N m",
            &[
                ("left robot, left wheel", left, |s| s.torque[0][0]),
                ("left robot, right wheel", left, |s| s.torque[0][1]),
                ("right robot, left wheel", right, |s| s.torque[1][0]),
                ("right robot, right wheel", right, |s| s.torque[1][1]),
            ],
            torque_limits,
        ),
        panel(
            "learned_force",
            "Learned constant force",
            "N",
            &[
                ("left", left, |s| s.bias[0][0]),
                ("right", right, |s| s.bias[1][0]),
            ],
            Vec::new(),
        ),
        panel(
            "learned_torque",
            "Learned constant torque",
            "N m",
            &[
                ("left", left, |s| s.bias[0][1]),
                ("right", right, |s| s.bias[1][1]),
            ],
            Vec::new(),
        ),
        panel(
            "state_gain",
            "Adapted gain of the speed (Delta X)",
            "N s/m",
            &[
                ("left", left, |s| s.state_gain[0][0]),
                ("right", right, |s| s.state_gain[1][0]),
            ],
            Vec::new(),
        ),
        panel(
            "input_gain",
            "Adapted gain of the input (Delta m)",
            "",
            &[
                ("left", left, |s| s.input_gain[0][0]),
                ("right", right, |s| s.input_gain[1][0]),
            ],
            Vec::new(),
        ),
    ]
}

/// Mean and band of a driven path over all trials that came to the end of the shortest; `None` below two trials.
fn ribbon(execution: &Execution, place: fn(&ControlSample) -> Point) -> Option<Ribbon> {
    let trials: Vec<&Trial> = execution
        .trials
        .iter()
        .filter(|t| t.samples.len() > 1)
        .collect();
    if trials.len() < 2 {
        return None;
    }
    let count = trials.iter().map(|t| t.samples.len()).min()?;
    let stride = count.div_ceil(RIBBON_POINTS);
    let instants: Vec<usize> = (0..count).step_by(stride).collect();
    let mean: Vec<Point> = instants
        .iter()
        .map(|&i| {
            let sum = trials
                .iter()
                .fold(Point::ZERO, |sum, t| sum + place(&t.samples[i]));
            sum / trials.len() as f64
        })
        .collect();
    let mut ribbon = Ribbon::default();
    for (k, &i) in instants.iter().enumerate() {
        let way = mean[(k + 1).min(mean.len() - 1)] - mean[k.saturating_sub(1)];
        let across = if way.norm() > 1e-9 {
            way.perp() / way.norm()
        } else {
            Point::ZERO
        };
        let offsets = trials
            .iter()
            .map(|t| (place(&t.samples[i]) - mean[k]).dot(across));
        let (low, high) = offsets.fold((0.0_f64, 0.0_f64), |(low, high), o| {
            (low.min(o), high.max(o))
        });
        ribbon.left_border.push(mean[k] + across * high);
        ribbon.right_border.push(mean[k] + across * low);
    }
    ribbon.mean = mean;
    Some(ribbon)
}
