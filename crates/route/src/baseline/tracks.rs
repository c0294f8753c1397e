//! The two tracks as elastic bands: smoothed, pushed off obstacles and objects, kept abreast and within reach.
//!
//! Each iteration refreshes springs and solves one banded system per robot, as in the centerline's smoothing.

use super::band::Visit;
use crate::banded::Pentadiagonal;
use crate::polyline::{arc_lengths, tangents};
use crate::terrain::Terrain;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::Scene;

const ITERATIONS: usize = 40;
/// Bending stiffness, m^2, and tension relative to it.
const BENDING: f64 = 0.02;
const TENSION: f64 = 0.1;
/// Inertia, 1/m^2: pulls towards the last position.
const INERTIA: f64 = 1.0;
/// Stiffness of the springs against obstacles, objects and bad separations, 1/m^2.
const KEEP: f64 = 60.0;
/// Stiffness of the spring that keeps the robots abreast, 1/m^2.
const ABREAST: f64 = 3.0;
/// Kept beyond the margins, so that springs at rest hold them, m.
const SPARE: f64 = 0.02;

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
    /// Relaxes the tracks; both ends and the directions there stay.
    pub fn relax(
        &mut self,
        terrain: &Terrain,
        scene: &Scene,
        centerline: &[Pose],
        visits: &[Visit],
    ) {
        let n = self.left.len();
        if n < 7 {
            return;
        }
        for (track, start, end) in [
            (&mut self.left, scene.start.left, scene.end.left),
            (&mut self.right, scene.start.right, scene.end.right),
        ] {
            for (at, next, pose, sign) in [(0, 1, start, 1.0), (n - 1, n - 2, end, -1.0)] {
                let h = track[at].distance(track[next]).max(1e-3);
                track[next] = pose.position() + pose.forward() * (sign * h);
            }
        }
        for _ in 0..ITERATIONS {
            let springs = self.springs(terrain, centerline, visits);
            let [left, right] = springs;
            solve(&mut self.left, &left);
            solve(&mut self.right, &right);
        }
    }

    fn springs(
        &self,
        terrain: &Terrain,
        centerline: &[Pose],
        visits: &[Visit],
    ) -> [Vec<Spring>; 2] {
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
                let slip = forward * (-0.5 * rung.dot(forward));
                springs[0][i].add(ABREAST, slip);
                springs[1][i].add(ABREAST, -slip);
            }
            for (side, p) in [(0, l), (1, r)] {
                let (d, gradient) = terrain.distance_and_gradient(p);
                let short = pair.radius + pair.clearance + SPARE - d;
                if short > 0.0 {
                    springs[side][i].add(KEEP, gradient * short.min(0.2));
                }
                for object in terrain.objects_near(p) {
                    let away = p - object.center;
                    let keep = object.radius + pair.radius + pair.clearance + SPARE;
                    let visited = visits
                        .iter()
                        .any(|v| v.object.center == object.center && i.abs_diff(v.index) < 30);
                    if !visited && away.norm() < keep && away.norm() > 1e-9 {
                        springs[side][i].add(KEEP, away * (keep / away.norm() - 1.0));
                    }
                }
            }
        }
        for visit in visits {
            let normal = centerline[visit.index].forward().perp();
            let keep = visit.object.radius + pair.radius + pair.clearance + SPARE;
            for i in visit.index.saturating_sub(30)..(visit.index + 31).min(n) {
                for (side, p, outwards) in [(0, self.left[i], normal), (1, self.right[i], -normal)]
                {
                    let r = p - visit.object.center;
                    let along = r.dot(normal.perp());
                    let offset = r.dot(outwards);
                    if along.abs() < keep {
                        // Beyond the object's disc on the robot's own side.
                        let short = (keep * keep - along * along).sqrt() - offset;
                        if short > 0.0 && offset > -2.0 * keep {
                            springs[side][i].add(KEEP, outwards * short.min(0.3));
                        }
                    }
                }
            }
        }
        springs
    }
}

fn solve(track: &mut [Point], springs: &[Spring]) {
    let n = track.len();
    let h = (arc_lengths(track)[n - 1] / (n - 1) as f64).max(1e-3);
    let mut matrix = Pentadiagonal::zeros(n);
    for i in 0..n - 1 {
        matrix.add(i, [-1.0, 1.0, 0.0], TENSION / h);
    }
    for i in 0..n - 2 {
        matrix.add(i, [1.0, -2.0, 1.0], BENDING / h.powi(3));
    }
    let mut x = Vec::with_capacity(n);
    let mut y = Vec::with_capacity(n);
    for (i, (p, spring)) in track.iter().zip(springs).enumerate() {
        let fixed = if i < 2 || i + 2 >= n { 1e9 } else { 0.0 };
        let weight = h * (INERTIA + spring.stiffness) + fixed;
        matrix.diagonal[i] += weight;
        let target = *p * weight + spring.pull * h;
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
