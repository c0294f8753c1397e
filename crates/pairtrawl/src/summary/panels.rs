//! Curves over time.

use pairtrawl_certificate::Clearance;
use pairtrawl_geometry::{Hull, Point, Pose, Segment, wrap_angle};
use pairtrawl_model::{
    Body, BodyCircle, Limit, Line, Object, PairTrajectory, Panel, Plan, RehearsalFrame,
    RehearsalRecord, Role, Sampling, Scene,
};

/// The curves that a plan decides.
pub(super) fn of_plan(scene: &Scene, plan: &Plan, times: &[f64]) -> Vec<Panel> {
    let t = &plan.trajectory;
    let panel =
        |key: &str, title: &str, unit: &str, sampling, lines, limits: &[(&str, f64)]| Panel {
            key: key.to_owned(),
            title: title.to_owned(),
            unit: unit.to_owned(),
            times: times.to_vec(),
            sampling,
            lines,
            limits: limits
                .iter()
                .map(|(label, value)| Limit {
                    label: (*label).to_owned(),
                    value: *value,
                })
                .collect(),
        };
    let (planner, body) = (&scene.planner, scene.robot.circles());
    let d_max = plan.net_length;
    let mut separations = vec![
        ("d_max", d_max),
        ("d_rest", planner.rest_ratio * d_max),
        ("2 radii", scene.robot.least_separation()),
        ("d_min", planner.min_ratio * d_max),
    ];
    // Robots with a body keep their circles apart, not their axle centers.
    separations.retain(|(_, value)| *value > 0.0);
    let mut panels = vec![
        panel(
            "separation",
            "Separation",
            "m",
            Sampling::Instant,
            vec![
                line("robots", Role::Other, instants(t, |p| p.separation())),
                line(
                    "hitches",
                    Role::Net,
                    instants(t, |p| {
                        let hitch = |pose: Pose| pose.hitch_point(scene.robot.hitch);
                        hitch(p.left).distance(hitch(p.right))
                    }),
                ),
            ],
            &separations,
        ),
        panel(
            "step_length",
            "Step length",
            "m",
            Sampling::Step,
            per_robot(t, |a, b| a.position().distance(b.position())),
            &[("limit", planner.max_step)],
        ),
        panel(
            "turn",
            "Turn in a step",
            "rad",
            Sampling::Step,
            per_robot(t, |a, b| b.heading - a.heading),
            &[("limit", planner.max_turn), ("limit", -planner.max_turn)],
        ),
        panel(
            "skew",
            "Skew from abreast",
            "rad",
            Sampling::Instant,
            vec![
                line(
                    "left",
                    Role::Left,
                    instants(t, |p| wrap_angle(p.left.heading - p.normal_heading())),
                ),
                line(
                    "right",
                    Role::Right,
                    instants(t, |p| wrap_angle(p.right.heading - p.normal_heading())),
                ),
            ],
            &[("limit", planner.max_skew), ("limit", -planner.max_skew)],
        ),
    ];
    if scene.robot.body.is_some() {
        let gap = instants(t, |p| body.gap(p.left, p.right));
        panels.push(panel(
            "robots_apart",
            "Gap between the robots",
            "m",
            Sampling::Instant,
            vec![line("robots", Role::Other, gap)],
            &[("contact", 0.0)],
        ));
    }
    let margin: &[(&str, f64)] = &[("margin", planner.clearance), ("contact", 0.0)];
    if let Some(lines) = obstacle_clearance(scene, t) {
        let title = "Clearance from obstacles";
        panels.push(panel(
            "clearance",
            title,
            "m",
            Sampling::Step,
            lines,
            margin,
        ));
    }
    if !scene.objects.is_empty() {
        let lines = per_robot(t, |a, b| {
            of_circles(&body, |c| {
                let path = Segment::new(c.center_at(a), c.center_at(b));
                let gap = |o: &Object| path.gap_to_disc(o.position, o.footprint_radius());
                let gaps = scene.objects.iter().map(|o| gap(o).distance - c.radius);
                gaps.fold(f64::INFINITY, f64::min)
            })
        });
        let title = "Clearance from objects";
        panels.push(panel(
            "object_clearance",
            title,
            "m",
            Sampling::Step,
            lines,
            margin,
        ));
    }
    panels
}

/// Tension and drive force of a rehearsal; none when it recorded no frame.
pub(super) fn of_rehearsal(scene: &Scene, record: &RehearsalRecord) -> Vec<Panel> {
    let frames = &record.frames;
    if frames.is_empty() {
        return Vec::new();
    }
    let times: Vec<f64> = frames.iter().map(|f| f.time).collect();
    let lines = |of: fn(&RehearsalFrame) -> [f64; 2]| {
        vec![
            line(
                "left",
                Role::Left,
                frames.iter().map(|f| of(f)[0]).collect(),
            ),
            line(
                "right",
                Role::Right,
                frames.iter().map(|f| of(f)[1]).collect(),
            ),
        ]
    };
    let panel = |key: &str, title: &str, lines, limits| Panel {
        key: key.to_owned(),
        title: title.to_owned(),
        unit: "N".to_owned(),
        times: times.clone(),
        sampling: Sampling::Instant,
        lines,
        limits,
    };
    let limit = Limit {
        label: "limit".to_owned(),
        value: scene.physics.tension_limit,
    };
    vec![
        panel(
            "tension",
            "Tension at the hitches",
            lines(|f| f.tension),
            vec![limit],
        ),
        panel(
            "drive_force",
            "Drive force",
            lines(|f| f.drive_force),
            Vec::new(),
        ),
    ]
}

/// Distances to the nearest obstacle over each step: of both robots' circles and of the floor that the net sweeps;
/// none where there is no obstacle.
fn obstacle_clearance(scene: &Scene, t: &PairTrajectory) -> Option<Vec<Line>> {
    let obstacles = Clearance::new(scene)?;
    obstacles.distance(&Hull::of(&[scene.start.left.position()]))?;
    let distance = |points: &[Point], less: f64| {
        obstacles
            .distance(&Hull::of(points))
            .map_or(f64::NAN, |d| d - less)
    };
    let body = scene.robot.circles();
    let mut lines = per_robot(t, |a, b| {
        of_circles(&body, |c| {
            distance(&[c.center_at(a), c.center_at(b)], c.radius)
        })
    });
    let steps = t.left.windows(2).zip(t.right.windows(2));
    let net = steps.map(|(l, r)| {
        let corners = [l[0], l[1], r[1], r[0]].map(Pose::position);
        distance(&corners, 0.0)
    });
    lines.push(line("net", Role::Net, net.collect()));
    Some(lines)
}

fn line(label: &str, role: Role, values: Vec<f64>) -> Line {
    Line {
        label: label.to_owned(),
        role,
        values,
    }
}

fn instants(t: &PairTrajectory, value: impl Fn(pairtrawl_model::PairPose) -> f64) -> Vec<f64> {
    (0..t.len()).map(|i| value(t.pair(i))).collect()
}

/// The least of what is found for each circle of a body.
fn of_circles(body: &Body, gap: impl Fn(&BodyCircle) -> f64) -> f64 {
    body.circles().iter().map(gap).fold(f64::INFINITY, f64::min)
}

fn per_robot(t: &PairTrajectory, value: impl Fn(Pose, Pose) -> f64) -> Vec<Line> {
    let steps = |poses: &[Pose]| poses.windows(2).map(|w| value(w[0], w[1])).collect();
    vec![
        line("left", Role::Left, steps(&t.left)),
        line("right", Role::Right, steps(&t.right)),
    ]
}
