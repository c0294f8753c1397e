//! A second opinion by dense sampling in time and space. It shares no geometry with the crate: everything here is
//! written from the table of claims, on plain pairs of numbers.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use super::brute_shapes::{Xy, obstacle_distance};
use pairtrawl_model::{Footprint, Object, PairTrajectory, Scene};
use std::f64::consts::{PI, TAU};

/// What sampling can tell of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opinion {
    Holds,
    Fails,
    /// Within the sampling error of its bound.
    Unclear,
}

/// Samples per step in time.
const TIMES: usize = 24;

/// The claims in the order of the file format.
pub fn opinions(
    scene: &Scene,
    net_length: f64,
    trajectory: &PairTrajectory,
) -> Vec<(&'static str, Opinion)> {
    let names = [
        "endpoints",
        "step",
        "turn",
        "forward",
        "no_sideways_slip",
        "speed",
        "abreast",
        "robot_clearance",
        "robots_miss_objects",
        "net_encloses_no_obstacle",
        "every_object_covered",
        "separation",
        "net_reach",
        "inside_area",
    ];
    let Some(run) = Run::new(scene, net_length, trajectory) else {
        return names.iter().map(|n| (*n, Opinion::Fails)).collect();
    };
    let found = [
        run.endpoints(),
        run.step(),
        run.turn(),
        run.along_and_across().0,
        run.along_and_across().1,
        run.speed(),
        run.abreast(),
        run.robot_clearance(),
        run.robots_miss_objects(),
        run.net_encloses_no_obstacle(),
        run.every_object_covered(),
        run.separation(),
        run.net_reach(),
        run.inside_area(),
    ];
    names.into_iter().zip(found).collect()
}

/// Poses as plain numbers: `[robot][waypoint]`.
struct Run<'a> {
    scene: &'a Scene,
    net: f64,
    time: f64,
    poses: [Vec<[f64; 3]>; 2],
}

/// Decides `value <= bound` when the true value may exceed the sampled one by `error`.
fn at_most(value: f64, bound: f64, error: f64) -> Opinion {
    if value.is_nan() || value > bound + 2e-9 {
        Opinion::Fails
    } else if value + error < bound + 0.5e-9 {
        Opinion::Holds
    } else {
        Opinion::Unclear
    }
}

fn all(opinions: impl IntoIterator<Item = Opinion>) -> Opinion {
    let mut worst = Opinion::Holds;
    for o in opinions {
        match o {
            Opinion::Fails => return o,
            Opinion::Unclear => worst = o,
            Opinion::Holds => {}
        }
    }
    worst
}

impl<'a> Run<'a> {
    fn new(scene: &'a Scene, net: f64, trajectory: &PairTrajectory) -> Option<Self> {
        let plain = |poses: &[pairtrawl_geometry::Pose]| -> Vec<[f64; 3]> {
            poses.iter().map(|p| [p.x, p.y, p.heading]).collect()
        };
        let poses = [plain(&trajectory.left), plain(&trajectory.right)];
        // Beyond 1e6 m a double does not resolve the tolerance: refused, as documented.
        let finite = poses.iter().flatten().flatten().all(|v| v.abs() <= 1e6);
        (finite && poses[0].len() == poses[1].len() && poses[0].len() > 1).then_some(Self {
            scene,
            net,
            time: trajectory.step_time,
            poses,
        })
    }

    fn steps(&self) -> usize {
        self.poses[0].len() - 1
    }

    fn at(&self, robot: usize, i: usize, t: f64) -> [f64; 3] {
        let (a, b) = (self.poses[robot][i], self.poses[robot][i + 1]);
        std::array::from_fn(|k| (1.0 - t) * a[k] + t * b[k])
    }

    /// (displacement, turn) of every step of both robots.
    fn moves(&self) -> impl Iterator<Item = (f64, f64, f64, f64)> + '_ {
        self.poses.iter().flat_map(|poses| {
            poses.windows(2).map(|w| {
                let (dx, dy, turn) = (w[1][0] - w[0][0], w[1][1] - w[0][1], w[1][2] - w[0][2]);
                let middle = w[0][2] + turn / 2.0;
                let along = dx * middle.cos() + dy * middle.sin();
                let across = dy * middle.cos() - dx * middle.sin();
                ((dx * dx + dy * dy).sqrt(), turn.abs(), along, across.abs())
            })
        })
    }

    fn endpoints(&self) -> Opinion {
        let (s, e) = (self.scene.start, self.scene.end);
        let last = self.steps();
        let cases = [
            (0, 0, s.left),
            (1, 0, s.right),
            (0, last, e.left),
            (1, last, e.right),
        ];
        all(cases.into_iter().map(|(robot, i, wanted)| {
            let [x, y, heading] = self.poses[robot][i];
            let off = ((x - wanted.x).powi(2) + (y - wanted.y).powi(2)).sqrt();
            let turned = ((heading - wanted.heading + PI).rem_euclid(TAU) - PI).abs();
            all([at_most(off, 1e-6, 1e-9), at_most(turned, 1e-6, 1e-9)])
        }))
    }

    fn step(&self) -> Opinion {
        all(self
            .moves()
            .map(|(s, ..)| at_most(s, self.scene.planner.max_step, 1e-12)))
    }

    fn turn(&self) -> Opinion {
        all(self
            .moves()
            .map(|(_, turn, ..)| at_most(turn, self.scene.planner.max_turn, 1e-12)))
    }

    fn along_and_across(&self) -> (Opinion, Opinion) {
        let forward = all(self
            .moves()
            .map(|(_, _, along, _)| at_most(-along, 1e-6, 1e-9)));
        (
            forward,
            all(self.moves().map(|(.., across)| at_most(across, 1e-4, 1e-9))),
        )
    }

    fn speed(&self) -> Opinion {
        if !(self.time > 0.0 && self.time.is_finite()) {
            return Opinion::Fails;
        }
        let robot = &self.scene.robot;
        all(self.moves().map(|(s, turn, ..)| {
            let wheel = (s + robot.half_track * turn) / self.time;
            all([
                at_most(wheel, robot.v_max, 1e-12),
                at_most(turn / self.time, robot.omega_max, 1e-12),
            ])
        }))
    }

    fn abreast(&self) -> Opinion {
        all((1..self.steps()).flat_map(|i| {
            let [l, r] = [self.poses[0][i], self.poses[1][i]];
            // The normal of the line points where (l - r) turned clockwise points: (dy, -dx).
            let (nx, ny) = (l[1] - r[1], -(l[0] - r[0]));
            let n = (nx * nx + ny * ny).sqrt();
            [l, r].map(|p| {
                let cos = (nx * p[2].cos() + ny * p[2].sin()) / n;
                at_most(
                    cos.clamp(-1.0, 1.0).acos(),
                    self.scene.planner.max_skew,
                    1e-7,
                )
            })
        }))
    }

    fn inside_area(&self) -> Opinion {
        let (min, max) = (self.scene.area.min, self.scene.area.max);
        all(self.poses.iter().flatten().map(|p| {
            let outside = (min.x - p[0])
                .max(p[0] - max.x)
                .max(min.y - p[1])
                .max(p[1] - max.y);
            at_most(outside, 0.0, 1e-12)
        }))
    }

    /// Every path segment keeps `radius` by this distance function; halves what a sample does not settle.
    fn paths_keep(&self, radius: f64, distance: impl Fn(Xy, f64) -> f64) -> Opinion {
        let mut worst = Opinion::Holds;
        for poses in &self.poses {
            let mut pieces: Vec<(Xy, Xy)> = poses
                .windows(2)
                .map(|w| ([w[0][0], w[0][1]], [w[1][0], w[1][1]]))
                .collect();
            while let Some((a, b)) = pieces.pop() {
                let middle = mix(a, b, 0.5);
                let half = 0.5 * (b[0] - a[0]).hypot(b[1] - a[1]);
                match at_most(radius, distance(middle, radius + half + 0.01), half) {
                    Opinion::Fails => return Opinion::Fails,
                    Opinion::Unclear if half > 1e-5 => pieces.extend([(a, middle), (middle, b)]),
                    Opinion::Unclear => worst = Opinion::Unclear,
                    Opinion::Holds => {}
                }
            }
        }
        worst
    }

    fn robot_clearance(&self) -> Opinion {
        self.paths_keep(self.scene.robot.radius, |p, range| {
            obstacle_distance(self.scene, p, range)
        })
    }

    fn robots_miss_objects(&self) -> Opinion {
        let objects = &self.scene.objects;
        self.paths_keep(self.scene.robot.radius, |p, _| {
            let to = |o: &Object| {
                let r = match o.footprint {
                    Footprint::Box(w, d) => (w * w + d * d).sqrt() / 2.0,
                    Footprint::Disc(r) => r,
                };
                (p[0] - o.position.x).hypot(p[1] - o.position.y) - r
            };
            objects.iter().map(to).fold(f64::INFINITY, f64::min)
        })
    }

    /// The hull of four points is the union of the four triangles between them; each is sampled on a grid.
    fn net_encloses_no_obstacle(&self) -> Opinion {
        all((0..self.steps()).map(|i| {
            let xy = |p: [f64; 3]| [p[0], p[1]];
            let four = [0, 1].map(|robot| [xy(self.poses[robot][i]), xy(self.poses[robot][i + 1])]);
            let four = [four[0][0], four[0][1], four[1][1], four[1][0]];
            all((0..4).map(|skip| {
                let corners: Vec<Xy> = (0..4).filter(|&k| k != skip).map(|k| four[k]).collect();
                self.triangle(&corners)
            }))
        }))
    }

    /// Quarters the triangle where a sample at its center does not settle it.
    fn triangle(&self, corners: &[Xy]) -> Opinion {
        let mut worst = Opinion::Holds;
        let mut pieces = vec![[corners[0], corners[1], corners[2]]];
        while let Some(piece @ [a, b, c]) = pieces.pop() {
            let middle: Xy = std::array::from_fn(|k| (a[k] + b[k] + c[k]) / 3.0);
            let size = piece
                .iter()
                .map(|p| (p[0] - middle[0]).hypot(p[1] - middle[1]))
                .fold(0.0, f64::max);
            match at_most(
                0.0,
                obstacle_distance(self.scene, middle, size + 0.01),
                size,
            ) {
                Opinion::Fails => return Opinion::Fails,
                Opinion::Unclear if size > 2e-3 => {
                    let (ab, bc, ca) = (mix(a, b, 0.5), mix(b, c, 0.5), mix(c, a, 0.5));
                    pieces.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
                }
                Opinion::Unclear => worst = Opinion::Unclear,
                Opinion::Holds => {}
            }
        }
        worst
    }

    fn every_object_covered(&self) -> Opinion {
        all(self
            .scene
            .objects
            .iter()
            .map(|o| self.covered([o.position.x, o.position.y])))
    }

    /// The line passes over the point when the point changes sides between two sampled times while it is beside the
    /// inner part of the line.
    fn covered(&self, p: Xy) -> Opinion {
        let mut nearest = f64::INFINITY;
        for i in 0..self.steps() {
            let spot = |robot: usize, t: f64| {
                let [x, y, _] = self.at(robot, i, t);
                [x, y]
            };
            let moved = (0..2)
                .map(|robot| {
                    let (a, b) = (spot(robot, 0.0), spot(robot, 1.0));
                    ((b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)).sqrt()
                })
                .fold(0.0, f64::max);
            let mut before: Option<(f64, f64, f64)> = None;
            for k in 0..=TIMES {
                let t = k as f64 / TIMES as f64;
                let (l, r) = (spot(0, t), spot(1, t));
                let d = [r[0] - l[0], r[1] - l[1]];
                let e = [p[0] - l[0], p[1] - l[1]];
                let length = (d[0] * d[0] + d[1] * d[1]).sqrt();
                let side = (d[0] * e[1] - d[1] * e[0]) / length;
                let from_left = (d[0] * e[0] + d[1] * e[1]) / length;
                let inner = from_left.min(length - from_left);
                let slack = moved / TIMES as f64;
                let off = side.abs().max(-inner);
                nearest = nearest.min(off - slack);
                if let Some((side0, inner0, _)) = before
                    && side0 * side < 0.0
                    && inner0.min(inner) > slack
                {
                    return Opinion::Holds;
                }
                before = Some((side, inner, slack));
            }
        }
        if nearest > 1e-9 {
            Opinion::Fails
        } else {
            Opinion::Unclear
        }
    }

    fn separation(&self) -> Opinion {
        let least = (0.1 * self.net).max(2.0 * self.scene.robot.radius);
        if !(self.net > 0.0 && self.net.is_finite()) {
            return Opinion::Fails;
        }
        all((0..self.steps()).flat_map(|i| {
            (0..=TIMES).map(move |k| {
                let t = k as f64 / TIMES as f64;
                let (l, r) = (self.at(0, i, t), self.at(1, i, t));
                let d = ((l[0] - r[0]).powi(2) + (l[1] - r[1]).powi(2)).sqrt();
                // The distance is convex in time and changes by no more than both robots move.
                let moved = |robot: usize| {
                    let (a, b) = (self.at(robot, i, 0.0), self.at(robot, i, 1.0));
                    ((b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)).sqrt()
                };
                let error = 0.5 * (moved(0) + moved(1)) / TIMES as f64;
                all([at_most(d, self.net, 0.0), at_most(least, d, error)])
            })
        }))
    }

    fn net_reach(&self) -> Opinion {
        if !(self.net > 0.0 && self.net.is_finite()) {
            return Opinion::Fails;
        }
        let h = self.scene.robot.hitch;
        all((0..self.steps()).flat_map(|i| {
            (0..=TIMES).map(move |k| {
                let t = k as f64 / TIMES as f64;
                let tie = |robot: usize| {
                    let [x, y, heading] = self.at(robot, i, t);
                    [x - h * heading.cos(), y - h * heading.sin()]
                };
                let (l, r) = (tie(0), tie(1));
                let d = ((l[0] - r[0]).powi(2) + (l[1] - r[1]).powi(2)).sqrt();
                let turn =
                    |robot: usize| (self.poses[robot][i + 1][2] - self.poses[robot][i][2]).powi(2);
                let error = h * (turn(0) + turn(1)) / (8.0 * (TIMES * TIMES) as f64);
                at_most(d, self.net, error)
            })
        }))
    }
}

fn mix(a: Xy, b: Xy, t: f64) -> Xy {
    [(1.0 - t) * a[0] + t * b[0], (1.0 - t) * a[1] + t * b[1]]
}
