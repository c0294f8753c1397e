use super::projection::Projection;
use crate::svg::Writer;
use pairtrawl_geometry::{Hull, Point, Pose};
use pairtrawl_model::{Footprint, Object, Obstacle, PairTrajectory, Ribbon, Robot, Summary};

/// Radius of the ring around a mark, in robot radii.
pub(crate) const MARK: f64 = 0.9;

/// What is drawn on the map, from the bottom to the top.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Layer {
    Obstacles,
    Sweep,
    Circles,
    Centerline,
    Baseline,
    Ribbons,
    Paths,
    Ends,
    Objects,
    Marks,
}

impl Layer {
    pub const ALL: [Self; 10] = [
        Self::Obstacles,
        Self::Sweep,
        Self::Circles,
        Self::Centerline,
        Self::Baseline,
        Self::Ribbons,
        Self::Paths,
        Self::Ends,
        Self::Objects,
        Self::Marks,
    ];

    /// A name for identifiers.
    pub fn key(self) -> &'static str {
        match self {
            Self::Obstacles => "obstacles",
            Self::Sweep => "sweep",
            Self::Circles => "circles",
            Self::Centerline => "centerline",
            Self::Baseline => "baseline",
            Self::Ribbons => "ribbons",
            Self::Paths => "paths",
            Self::Ends => "ends",
            Self::Objects => "objects",
            Self::Marks => "marks",
        }
    }

    /// True when the summary has something to draw here.
    pub fn is_present(self, summary: &Summary) -> bool {
        match self {
            Self::Obstacles => {
                !summary.outline.obstacles.is_empty() || summary.outline.free_rings.is_some()
            }
            Self::Sweep | Self::Paths => !summary.trajectory.is_empty(),
            Self::Circles => !summary.circles.is_empty(),
            Self::Centerline => !summary.centerline.is_empty(),
            Self::Baseline => !summary.baseline.is_empty(),
            Self::Ribbons => summary
                .execution
                .as_ref()
                .is_some_and(|e| e.left_ribbon.is_some() || e.right_ribbon.is_some()),
            Self::Ends => true,
            Self::Objects => !summary.outline.objects.is_empty(),
            Self::Marks => !summary.marks.is_empty(),
        }
    }

    /// Draws the layer's elements.
    pub fn draw(self, w: &mut Writer, summary: &Summary, to: &Projection) {
        match self {
            Self::Obstacles => obstacles(w, summary, to),
            Self::Sweep => path(w, "sweep", sweep(&summary.trajectory, to)),
            Self::Circles => {
                for c in &summary.circles {
                    circle(w, "circle", c.center, c.radius, to);
                }
            }
            Self::Centerline => path(w, "centerline", poses(&summary.centerline, to)),
            Self::Baseline => {
                path(w, "left baseline", poses(&summary.baseline.left, to));
                path(w, "right baseline", poses(&summary.baseline.right, to));
            }
            Self::Ribbons => {
                if let Some(e) = &summary.execution {
                    ribbon(w, "left", e.left_ribbon.as_ref(), to);
                    ribbon(w, "right", e.right_ribbon.as_ref(), to);
                }
            }
            Self::Paths => {
                path(w, "left path", poses(&summary.trajectory.left, to));
                path(w, "right path", poses(&summary.trajectory.right, to));
            }
            Self::Ends => {
                let robot = &summary.outline.robot;
                for (pair, when) in [
                    (summary.outline.start, "start"),
                    (summary.outline.end, "end"),
                ] {
                    robot_at(w, &format!("left {when}"), pair.left, robot, to);
                    robot_at(w, &format!("right {when}"), pair.right, robot, to);
                }
            }
            Self::Objects => {
                for object in &summary.outline.objects {
                    footprint(w, object, to);
                }
            }
            Self::Marks => {
                let radius = MARK * summary.outline.robot.radius;
                for mark in &summary.marks {
                    if let Some(toward) = mark.toward {
                        path(w, "move", to.path([mark.place, toward]));
                        circle(w, "move", toward, 0.25 * radius, to);
                    }
                    circle(w, "mark", mark.place, radius, to);
                }
            }
        }
    }
}

fn path(w: &mut Writer, class: &str, d: String) {
    if !d.is_empty() {
        w.empty("path", &[("class", &class), ("d", &d)]);
    }
}

fn poses(poses: &[Pose], to: &Projection) -> String {
    to.path(poses.iter().map(|p| p.position()))
}

fn circle(w: &mut Writer, class: &str, center: Point, radius: f64, to: &Projection) {
    let (x, y, r) = (to.x(center.x), to.y(center.y), to.length(radius));
    w.empty(
        "circle",
        &[("class", &class), ("cx", &x), ("cy", &y), ("r", &r)],
    );
}

fn rectangle(min: Point, max: Point) -> [Point; 4] {
    [min, Point::new(max.x, min.y), max, Point::new(min.x, max.y)]
}

/// Everything that is in the way, and the border of the area.
fn obstacles(w: &mut Writer, summary: &Summary, to: &Projection) {
    let outline = &summary.outline;
    let border = to.ring(rectangle(outline.area.min, outline.area.max));
    if let Some(rings) = &outline.free_rings {
        // The area without the free rings is what is blocked.
        let mut d = border.clone();
        for ring in rings {
            d.push_str(&to.ring(ring.iter().copied()));
        }
        w.empty(
            "path",
            &[("class", &"obstacle"), ("fill-rule", &"evenodd"), ("d", &d)],
        );
    }
    for obstacle in &outline.obstacles {
        match obstacle {
            Obstacle::Box { min, max } => path(w, "obstacle", to.ring(rectangle(*min, *max))),
            Obstacle::Polygon(points) => path(w, "obstacle", to.ring(points.iter().copied())),
            Obstacle::Circle { center, radius } => circle(w, "obstacle", *center, *radius, to),
        }
    }
    w.empty("path", &[("class", &"border"), ("d", &border)]);
}

/// Path data of what the line between the robots sweeps: the convex hull of each step, all counter-clockwise, so that
/// overlaps add up under the non-zero rule instead of cancelling.
pub(crate) fn sweep(trajectory: &PairTrajectory, to: &Projection) -> String {
    let mut d = String::new();
    for i in 1..trajectory.len() {
        let (a, b) = (trajectory.pair(i - 1), trajectory.pair(i));
        let corners = [a.left, a.right, b.right, b.left].map(|p| p.position());
        d.push_str(&to.ring(Hull::of(&corners).vertices().iter().copied()));
    }
    d
}

fn ribbon(w: &mut Writer, side: &str, ribbon: Option<&Ribbon>, to: &Projection) {
    let Some(ribbon) = ribbon else { return };
    // Cell by cell, for the same reason as the sweep.
    let mut d = String::new();
    let borders = ribbon
        .left_border
        .windows(2)
        .zip(ribbon.right_border.windows(2));
    for (l, r) in borders {
        let cell = Hull::of(&[l[0], l[1], r[0], r[1]]);
        d.push_str(&to.ring(cell.vertices().iter().copied()));
    }
    path(w, &format!("{side} ribbon"), d);
    path(
        w,
        &format!("{side} mean"),
        to.path(ribbon.mean.iter().copied()),
    );
}

/// A robot seen from above: its circles, where it faces, and where the net is tied.
fn robot_at(w: &mut Writer, class: &str, pose: Pose, robot: &Robot, to: &Projection) {
    w.open("g", &[("class", &format_args!("robot {class}"))]);
    for c in robot.circles().circles() {
        circle(w, "body", c.center_at(pose), c.radius, to);
    }
    // The middle is kept free for the robot's letter.
    let front = robot.circles().front();
    let nose = [0.55, 1.0].map(|share| pose.position() + pose.forward() * (share * front));
    path(w, "nose", to.path(nose));
    circle(
        w,
        "hitch",
        pose.hitch_point(robot.hitch),
        0.12 * robot.radius,
        to,
    );
    w.close();
}

fn footprint(w: &mut Writer, object: &Object, to: &Projection) {
    let class = match object.leave {
        true => "object leave",
        false => "object",
    };
    match object.footprint {
        Footprint::Box(width, depth) => {
            let half = Point::new(0.5 * width, 0.5 * depth);
            let corners = rectangle(object.position - half, object.position + half);
            path(w, class, to.ring(corners));
        }
        Footprint::Disc(radius) => circle(w, class, object.position, radius, to),
    }
}
