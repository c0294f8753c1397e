//! Small summaries, made by hand.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::*;

/// A pair that drives `steps` steps of 5 cm along +x, the left robot at y = 2, the right one at y = 1, past a box, a
/// triangle and a disc, over two objects.
pub fn summary(steps: usize) -> Summary {
    let poses = |y: f64| -> Vec<Pose> {
        (0..=steps)
            .map(|i| Pose::new(1.0 + 0.05 * i as f64, y, 0.0))
            .collect()
    };
    let trajectory = PairTrajectory {
        left: poses(2.0),
        right: poses(1.0),
        step_time: 0.25,
    };
    let pair = |x: f64| PairPose {
        left: Pose::new(x, 2.0, 0.0),
        right: Pose::new(x, 1.0, 0.0),
    };
    let end = 1.0 + 0.05 * steps as f64;
    Summary {
        title: "a small hall".to_owned(),
        net_length: 1.5,
        net_length_chosen: true,
        outline: SceneOutline {
            area: Area {
                min: Point::ZERO,
                max: Point::new(end + 1.0, 3.0),
                resolution: 0.05,
            },
            obstacles: vec![
                Obstacle::Box {
                    min: Point::new(0.0, 2.6),
                    max: Point::new(0.5, 3.0),
                },
                Obstacle::Polygon(vec![
                    Point::new(1.0, 3.0),
                    Point::new(1.4, 3.0),
                    Point::new(1.2, 2.7),
                ]),
                Obstacle::Circle {
                    center: Point::new(1.0, 0.3),
                    radius: 0.2,
                },
            ],
            free_rings: None,
            objects: vec![
                Object {
                    position: Point::new(1.2, 1.5),
                    footprint: Footprint::Disc(0.04),
                    mass: 0.02,
                    leave: false,
                },
                Object {
                    position: Point::new(1.4, 1.4),
                    footprint: Footprint::Box(0.06, 0.04),
                    mass: 0.02,
                    leave: false,
                },
            ],
            robot: Robot::default(),
            start: pair(1.0),
            end: pair(end),
        },
        circles: vec![Circle {
            center: Point::new(1.3, 1.45),
            radius: 0.3,
            objects: vec![0, 1],
        }],
        order: vec![0],
        left_out: Vec::new(),
        marks: Vec::new(),
        centerline: vec![Pose::new(1.0, 1.5, 0.0), Pose::new(end, 1.5, 0.0)],
        baseline: PairTrajectory {
            left: vec![Pose::new(1.0, 1.8, 0.0), Pose::new(end, 1.8, 0.0)],
            right: vec![Pose::new(1.0, 1.2, 0.0), Pose::new(end, 1.2, 0.0)],
            step_time: 1.0,
        },
        left_length: 0.05 * steps as f64,
        right_length: 0.05 * steps as f64,
        duration: trajectory.duration(),
        swept_at: vec![Some(1.0), None],
        panels: panels(steps),
        times: trajectory.times(),
        trajectory,
        cost: Cost {
            smoothness: 1.0,
            distance: 60.0,
            obstacle: 0.0,
            expansion: 39.0,
        },
        claims: claims(),
        rehearsal: Rehearsal::Skipped,
        solver: SolverReport {
            status: SolverStatus::Converged,
            iterations: 31,
            kkt_error: 1e-7,
            seconds: 0.012,
        },
        stages: vec![StageTime {
            name: "world".to_owned(),
            seconds: 0.002,
        }],
        warnings: Vec::new(),
        frames: None,
        execution: None,
    }
}

fn panels(steps: usize) -> Vec<Panel> {
    let times: Vec<f64> = (0..=steps).map(|i| 0.25 * i as f64).collect();
    let line = |label: &str, role, values| Line {
        label: label.to_owned(),
        role,
        values,
    };
    vec![
        Panel {
            key: "separation".to_owned(),
            title: "Separation".to_owned(),
            unit: "m".to_owned(),
            times: times.clone(),
            sampling: Sampling::Instant,
            lines: vec![line("robots", Role::Other, vec![1.0; steps + 1])],
            limits: vec![Limit {
                label: "d_max".to_owned(),
                value: 1.5,
            }],
        },
        Panel {
            key: "step_length".to_owned(),
            title: "Step length".to_owned(),
            unit: "m".to_owned(),
            times,
            sampling: Sampling::Step,
            lines: vec![
                line(
                    "left",
                    Role::Left,
                    (0..steps).map(|i| 0.01 * i as f64).collect(),
                ),
                line("right", Role::Right, vec![f64::NAN; steps]),
            ],
            limits: Vec::new(),
        },
    ]
}

fn claims() -> Vec<ClaimSummary> {
    vec![
        ClaimSummary {
            claim: Claim {
                id: ClaimId::RobotClearance,
                holds: true,
                margin: 0.0312,
                step: Some(2),
                place: Some(Point::new(1.1, 2.0)),
                detail: "left robot".to_owned(),
            },
            meaning: "no robot touches an obstacle",
            unit: "m",
            time: Some(0.5),
        },
        ClaimSummary {
            claim: Claim {
                id: ClaimId::NetReach,
                holds: false,
                margin: -0.5,
                step: None,
                place: None,
                detail: String::new(),
            },
            meaning: "the net reaches from hitch to hitch",
            unit: "m",
            time: None,
        },
    ]
}

/// The summary of the same plan for a machine `factor` times as large.
#[allow(dead_code, reason = "not every test needs scales")]
pub fn scaled(mut summary: Summary, factor: f64) -> Summary {
    let pose = |p: Pose| Pose::at(p.position() * factor, p.heading);
    let pair = |p: PairPose| PairPose {
        left: pose(p.left),
        right: pose(p.right),
    };
    let outline = &mut summary.outline;
    (outline.start, outline.end) = (pair(outline.start), pair(outline.end));
    (outline.area.min, outline.area.max) = (outline.area.min * factor, outline.area.max * factor);
    outline.robot.radius *= factor;
    outline.robot.hitch *= factor;
    outline.obstacles.clear();
    for object in &mut outline.objects {
        object.position = object.position * factor;
        object.footprint = Footprint::Disc(0.04 * factor);
    }
    for circle in &mut summary.circles {
        circle.center = circle.center * factor;
        circle.radius *= factor;
    }
    summary.centerline = summary.centerline.into_iter().map(pose).collect();
    summary.baseline = summary.baseline.map(pose);
    summary.trajectory = summary.trajectory.map(pose);
    summary.net_length *= factor;
    summary.left_length *= factor;
    summary
}

/// Adds a rehearsal of `count` frames with a net of `nodes` points, and an execution of two trials that shows the same.
#[allow(dead_code, reason = "not every test needs motion")]
pub fn with_motion(mut summary: Summary, count: usize, nodes: usize) -> Summary {
    let at = |i: usize| i as f64 / (count - 1) as f64;
    let frames = Frames {
        times: (0..count).map(|i| summary.duration * at(i)).collect(),
        left: (0..count)
            .map(|i| Pose::new(1.0 + at(i), 2.0, 0.1))
            .collect(),
        right: (0..count)
            .map(|i| Pose::new(1.0 + at(i), 1.0, -0.1))
            .collect(),
        net: (0..count)
            .map(|i| {
                (0..nodes)
                    .map(|k| {
                        let u = k as f64 / (nodes - 1) as f64;
                        let wave = (17.0 * at(i) + 3.0 * u).sin();
                        Point::new(0.8 + at(i) - u * (1.0 - u) + 0.01 * wave, 2.0 - u)
                    })
                    .collect()
            })
            .collect(),
        objects: (0..count)
            .map(|i| vec![Pose::new(1.2, 1.5, at(i)); 2])
            .collect(),
        left_tension: vec![0.3; count],
        right_tension: vec![0.4; count],
        tension_limit: 10.0,
        events: vec![Event {
            time: 1.0,
            place: Point::new(1.0, 2.0),
            text: "a snag".to_owned(),
        }],
    };
    let border = |y: f64| vec![Point::new(1.0, y), Point::new(1.5, y), Point::new(2.0, y)];
    let trial = |seed, gathered| TrialSummary {
        seed,
        gathered,
        complete: gathered == 2,
        tracking: [
            TrackingStatistics {
                rms: 0.004,
                max: 0.01,
                settled_rms: 0.003,
                settled_max: 0.009,
            },
            TrackingStatistics {
                rms: 0.005,
                max: 0.02,
                settled_rms: 0.004,
                settled_max: 0.008,
            },
        ],
        cost: summary.cost,
        event: None,
    };
    summary.execution = Some(ExecutionSummary {
        controller: "mrac".to_owned(),
        trials: vec![trial(1, 2), trial(2, 1)],
        trials_wanted: 2,
        shown: 0,
        frames: Some(frames.clone()),
        panels: vec![Panel {
            key: "drag".to_owned(),
            title: "Drag".to_owned(),
            unit: "N".to_owned(),
            times: frames.times.clone(),
            sampling: Sampling::Instant,
            lines: vec![Line {
                label: "left".to_owned(),
                role: Role::Left,
                values: vec![0.3; count],
            }],
            limits: Vec::new(),
        }],
        left_ribbon: Some(Ribbon {
            mean: border(2.0),
            left_border: border(2.02),
            right_border: border(1.99),
        }),
        right_ribbon: None,
    });
    summary.frames = Some(frames);
    summary.rehearsal = Rehearsal::Passed;
    summary
}
