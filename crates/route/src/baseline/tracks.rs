//! The two tracks as elastic bands: smoothed, pushed off obstacles and objects, kept abreast and within reach.
//!
//! Each iteration refreshes springs and solves one banded system per robot, as in the centerline's smoothing.

use super::band::{Band, Visit};
use crate::banded::Pentadiagonal;
use crate::polyline::{arc_lengths, tangents};
use crate::terrain::Terrain;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Scene, Side};

/// Spacing of the tracks before they are put on the clock.
pub(super) const SPACING: f64 = 0.05;
const ITERATIONS: usize = 40;
/// Bending stiffness, and tension relative to it.
const BENDING: f64 = 0.02;
const TENSION: f64 = 0.1;
/// Share of the elastic energy that is the displacement's.
const KEEP_SHAPE: f64 = 0.5;
/// Inertia: pulls towards the last position.
const INERTIA: f64 = 1.0;
/// Stiffness of the springs against obstacles, objects and bad separations.
const KEEP: f64 = 60.0;
/// Stiffness of the spring that keeps the robots abreast.
const ABREAST: f64 = 3.0;
/// Least progress along the centerline as a share of the midpoint's, and the stiffness of its spring.
const LEAST_PROGRESS: f64 = 0.2;
const PROGRESS: f64 = 200.0;
/// Kept beyond the margins, so that springs at rest hold them.
const SPARE: f64 = 0.02;

/// Vertices on either side of a visit in which the robots stay on their own sides of the object.
pub(super) const WINDOW: usize = 30;

/// Both tracks, index by index abreast.
pub(crate) struct Tracks {
    pub left: Vec<Point>,
    pub right: Vec<Point>,
}

struct Spring {
    stiffness: f64,
    pull: Point,
}

impl Spring {
    fn add(&mut self, stiffness: f64, shift: Point) {
        self.stiffness += stiffness;
        self.pull += shift * stiffness;
    }
}

impl Tracks {
    /// The track of one robot.
    pub fn of(&self, side: Side) -> &[Point] {
        match side {
            Side::Left => &self.left,
            Side::Right => &self.right,
        }
    }

    /// Relaxes the tracks; both ends and the directions there stay.
    pub fn relax(&mut self, terrain: &Terrain, scene: &Scene, centerline: &[Pose], band: &Band) {
        let n = self.left.len();
        if n < 7 {
            return;
        }
        let ends = [
            (&mut self.left, scene.start.left, scene.end.left),
            (&mut self.right, scene.start.right, scene.end.right),
        ];
        for (track, start, end) in ends {
            let reach = terrain.pair.turning;
            turn_into(track, start.position(), start.forward(), reach);
            track.reverse();
            turn_into(track, end.position(), -end.forward(), reach);
            track.reverse();
        }
        let reference = [self.left.clone(), self.right.clone()];
        for _ in 0..ITERATIONS {
            let [left, right] = self.springs(terrain, centerline, band);
            solve(&mut self.left, &reference[0], &left);
            solve(&mut self.right, &reference[1], &right);
        }
    }

    fn springs(&self, terrain: &Terrain, centerline: &[Pose], band: &Band) -> [Vec<Spring>; 2] {
        let n = self.left.len();
        let pair = &terrain.pair;
        let mut springs = [(); 2].map(|()| {
            (0..n)
                .map(|_| Spring {
                    stiffness: 0.0,
                    pull: Point::ZERO,
                })
                .collect::<Vec<_>>()
        });
        let directions = [tangents(&self.left), tangents(&self.right)];
        for i in 0..n {
            let (l, r) = (self.left[i], self.right[i]);
            let rung = l - r;
            let separation = rung.norm().max(1e-9);
            let least = 2.0 * pair.min_half + SPARE;
            let most = 2.0 * pair.max_half;
            let stretch = (least - separation).max(0.0) - (separation - most).max(0.0);
            if stretch != 0.0 {
                let shift = rung * (0.5 * stretch / separation);
                springs[0][i].add(KEEP, shift);
                springs[1][i].add(KEEP, -shift);
            }
            let mean = directions[0][i] + directions[1][i];
            if mean.norm() > 0.1 {
                let forward = mean / mean.norm();
                let slip = forward * (0.5 * (band.lead[i] - rung.dot(forward)));
                springs[0][i].add(ABREAST, slip);
                springs[1][i].add(ABREAST, -slip);
            }
            for (side, p) in [(Side::Left, l), (Side::Right, r)] {
                let spring = &mut springs[side.index()][i];
                let (d, gradient) = terrain.distance_and_gradient(p);
                let short = pair.radius + pair.clearance + SPARE - d;
                if short > 0.0 {
                    spring.add(KEEP, gradient * short.min(0.2));
                }
                for object in terrain.objects_near(p) {
                    let away = p - object.center;
                    let keep = object.radius + pair.radius + pair.clearance + SPARE;
                    let distance = away.norm();
                    if distance >= keep || distance < 1e-9 {
                        continue;
                    }
                    let is_visit = |v: &Visit| {
                        v.object.center == object.center && i.abs_diff(v.index) <= WINDOW
                    };
                    if !band.visits.iter().any(is_visit) {
                        spring.add(KEEP, away * (keep / distance - 1.0));
                    }
                }
            }
        }
        for i in 0..n - 1 {
            // Nobody drives backwards.
            let forward = centerline[i].forward();
            for (springs, track) in springs.iter_mut().zip([&self.left, &self.right]) {
                let lag = LEAST_PROGRESS * SPACING - (track[i + 1] - track[i]).dot(forward);
                if lag > 0.0 {
                    springs[i].add(PROGRESS, forward * (-0.5 * lag));
                    springs[i + 1].add(PROGRESS, forward * (0.5 * lag));
                }
            }
        }
        for visit in &band.visits {
            let normal = centerline[visit.index].forward().perp();
            let keep = visit.object.radius + pair.radius + pair.clearance + SPARE;
            let window = visit.index.saturating_sub(WINDOW)..(visit.index + WINDOW + 1).min(n);
            for i in window {
                for (side, track) in Side::BOTH.into_iter().zip([&self.left, &self.right]) {
                    let (p, outwards) = (track[i], normal * side.sign());
                    let r = p - visit.object.center;
                    let along = r.dot(normal.perp());
                    let offset = r.dot(outwards);
                    if along.abs() < keep {
                        // Beyond the object's disc on the robot's own side.
                        let short = (keep * keep - along * along).sqrt() - offset;
                        if short > 0.0 && offset > -2.0 * keep {
                            springs[side.index()][i].add(KEEP, outwards * short.min(0.3));
                        }
                    }
                }
            }
        }
        springs
    }
}

/// Bends the beginning of a track, at most over the length `reach`, so that it leaves `at` along `forward`: p += s (1 - s / S)^2 (forward - direction).
fn turn_into(track: &mut [Point], at: Point, forward: Point, reach: f64) {
    track[0] = at;
    let s = arc_lengths(track);
    let ahead = s.partition_point(|&s| s < 0.15).min(track.len() - 1);
    let chord = track[ahead] - track[0];
    if chord.norm() < 1e-9 {
        return;
    }
    let correction = forward - chord / chord.norm();
    let reach = reach.min(0.5 * s[track.len() - 1]);
    for (p, &s) in track.iter_mut().zip(&s).take_while(|(_, s)| **s < reach) {
        let rest = 1.0 - s / reach;
        *p += correction * (s * rest * rest);
    }
}

/// One step towards the rest of all springs. The elastic energy is partly that of the track's shape, which smooths it,
/// and partly that of its displacement from the reference, which keeps bends open.
fn solve(track: &mut [Point], reference: &[Point], springs: &[Spring]) {
    let n = track.len();
    let h = SPACING;
    let mut matrix = Pentadiagonal::zeros(n);
    let mut load = vec![Point::ZERO; n];
    let mut elastic = |i: usize, c: [f64; 3], weight: f64| {
        matrix.add(i, c, weight);
        let mut strain = reference[i] * c[0] + reference[i + 1] * c[1];
        if c[2] != 0.0 {
            strain += reference[i + 2] * c[2];
        }
        for (k, &c) in c.iter().enumerate().filter(|(_, c)| **c != 0.0) {
            load[i + k] += strain * (KEEP_SHAPE * weight * c);
        }
    };
    for i in 0..n - 1 {
        elastic(i, [-1.0, 1.0, 0.0], TENSION / h);
    }
    for i in 0..n - 2 {
        elastic(i, [1.0, -2.0, 1.0], BENDING / (h * h * h));
    }
    let mut x = Vec::with_capacity(n);
    let mut y = Vec::with_capacity(n);
    for (i, spring) in springs.iter().enumerate() {
        let fixed = if i < 2 || i + 2 >= n { 1e9 } else { 0.0 };
        let weight = h * (INERTIA + spring.stiffness) + fixed;
        matrix.diagonal[i] += weight;
        let target = track[i] * weight + spring.pull * h + load[i];
        x.push(target.x);
        y.push(target.y);
    }
    let factor = matrix.factorize();
    factor.solve(&mut x);
    factor.solve(&mut y);
    for i in 2..n - 2 {
        track[i] = Point::new(x[i], y[i]);
    }
}
