//! Smoothing of a searched centerline as an elastic band.
//!
//! minimize  1/2 int (alpha |p'|^2 + beta |p''|^2) ds + stiff springs to the circles' centers and away from obstacles,
//! with both end poses fixed. Springs are refreshed and one linear system is solved per iteration.

use super::Itinerary;
use crate::banded::Pentadiagonal;
use crate::polyline::{refine, resample, tangents, with_headings};
use crate::terrain::Terrain;
use pairtrawl_geometry::{Point, Pose};

/// Spacing of the band's vertices, m.
const SPACING: f64 = 0.1;
/// Spacing of the result, m.
const RESULT_SPACING: f64 = 0.05;
/// Tension alpha, 1.
const TENSION: f64 = 0.5;
/// Bending stiffness beta, m^2: sqrt(beta / alpha) is the radius in which a taut band rounds a corner.
const BENDING: f64 = 0.25;
/// Inertia: pulls every vertex towards its last position, 1/m^2.
const INERTIA: f64 = 3.0;
/// Stiffness of the spring at a circle's center, 1/m.
const GOAL: f64 = 60.0;
/// Stiffness of the spring that makes room for the robots, 1/m^2.
const ROOM: f64 = 40.0;
/// Stiffness of the spring that keeps objects well inside or outside of the band, 1/m^2.
const OBJECT: f64 = 6.0;
/// How near to a circle's center its spring is at rest, m: exact passage is not worth a sharp bend.
const GOAL_REST: f64 = 0.07;
/// Tightest curvature that the band tolerates before it stiffens there, 1/m.
const CURVATURE: f64 = 1.0 / 0.55;
/// Factor by which it stiffens in an iteration, and stiffness at most.
const STIFFEN: f64 = 1.2;
const STIFFEST: f64 = 200.0;
/// Vertices on either side that stiffen along: a bend must not just move to the next vertex.
const SPREAD: usize = 3;
/// Curvature at which the spring of a circle nearby yields, 1/m, and how soft it may become: in a sharp corner a circle
/// is better taken off the middle of the band than by a pair that turns on the spot.
const YIELD: f64 = 1.0 / 0.4;
const SOFTEST: f64 = 0.02;
const ITERATIONS: usize = 80;
/// Iterations after which the vertices are spread evenly again.
const REFRESH: usize = 10;

/// A smooth centerline along `raw`, resampled evenly.
pub(crate) fn smooth(terrain: &Terrain, itinerary: &Itinerary, raw: &[Pose]) -> Vec<Pose> {
    let mut band = Band::new(terrain, itinerary, raw);
    for round in 0..ITERATIONS {
        if round % REFRESH == 0 {
            band.spread();
        }
        band.relax();
    }
    band.spread();
    let fine = refine(&band.points, 4);
    let points = resample(&fine, RESULT_SPACING);
    with_headings(&points, itinerary.start.heading, itinerary.end.heading)
}

struct Band<'a> {
    terrain: &'a Terrain,
    itinerary: &'a Itinerary,
    points: Vec<Point>,
    /// Bending stiffness at each vertex relative to [`BENDING`].
    stiffness: Vec<f64>,
    /// Stiffness of the spring at each goal relative to [`GOAL`].
    goals: Vec<f64>,
}

impl<'a> Band<'a> {
    fn new(terrain: &'a Terrain, itinerary: &'a Itinerary, raw: &[Pose]) -> Self {
        let points: Vec<Point> = raw.iter().map(|p| p.position()).collect();
        Self {
            terrain,
            itinerary,
            points,
            stiffness: Vec::new(),
            goals: vec![1.0; itinerary.goals.len()],
        }
    }

    /// Spreads the vertices evenly and puts the second and the last but one where the end headings want them.
    fn spread(&mut self) {
        let before = self.points.len();
        self.points = resample(&self.points, SPACING);
        // Two fixed vertices at both ends and something to move in between.
        while self.points.len() < 6 {
            let n = self.points.len();
            self.points = resample(
                &self.points,
                0.5 * self.points[0].distance(self.points[n - 1]).max(1e-3) / n as f64,
            );
            if self.points.len() <= n {
                break;
            }
        }
        let n = self.points.len();
        if n >= 4 {
            let h = self.points[0].distance(self.points[1]);
            self.points[1] = self.itinerary.start.position() + self.itinerary.start.forward() * h;
            self.points[n - 2] = self.itinerary.end.position() - self.itinerary.end.forward() * h;
        }
        // What was stiff stays stiff: the vertices hardly move along the band.
        let old = std::mem::take(&mut self.stiffness);
        self.stiffness = (0..n)
            .map(|i| {
                if old.len() == before && before > 0 {
                    old[(i * before / n).min(before - 1)]
                } else {
                    1.0
                }
            })
            .collect();
    }

    /// The vertex nearest to each goal, in order along the band.
    fn attachments(&self) -> Vec<usize> {
        attach(&self.points, &self.itinerary.goals)
    }

    fn relax(&mut self) {
        let n = self.points.len();
        if n < 6 {
            return;
        }
        let h = self
            .points
            .windows(2)
            .map(|w| w[0].distance(w[1]))
            .sum::<f64>()
            / (n - 1) as f64;
        let attachments = self.attachments();
        let mut matrix = Pentadiagonal::zeros(n);
        for i in 0..n - 1 {
            matrix.add(i, [-1.0, 1.0, 0.0], TENSION / h);
        }
        for i in 0..n - 2 {
            let [a, b, c] = [self.points[i], self.points[i + 1], self.points[i + 2]];
            let curvature = (a - b * 2.0 + c).norm() / (h * h);
            if curvature > CURVATURE {
                for k in i.saturating_sub(SPREAD)..(i + 3 + SPREAD).min(n) {
                    self.stiffness[k] = (self.stiffness[k] * STIFFEN).min(STIFFEST);
                }
            }
            if curvature > YIELD {
                for (spring, &at) in self.goals.iter_mut().zip(&attachments) {
                    if at.abs_diff(i + 1) <= 2 * SPREAD {
                        *spring = (*spring * 0.85).max(SOFTEST);
                    }
                }
            }
            matrix.add(
                i,
                [1.0, -2.0, 1.0],
                BENDING * self.stiffness[i + 1] / h.powi(3),
            );
        }
        let mut x: Vec<f64> = Vec::with_capacity(n);
        let mut y: Vec<f64> = Vec::with_capacity(n);
        let directions = tangents(&self.points);
        for i in 0..n {
            let (stiffness, shift) = self.room(self.points[i], directions[i]);
            let weight = h * (INERTIA + stiffness);
            matrix.diagonal[i] += weight;
            let target = self.points[i] * weight + shift * (h * stiffness);
            x.push(target.x);
            y.push(target.y);
        }
        for (k, i) in attachments.into_iter().enumerate() {
            let center = self.itinerary.goals[k];
            let miss = self.points[i] - center;
            let goal = center
                + miss
                    * (GOAL_REST / miss.norm().max(GOAL_REST))
                        .min(miss.norm() / miss.norm().max(1e-12));
            let spring = GOAL * self.goals[k];
            matrix.diagonal[i] += spring;
            x[i] += spring * goal.x;
            y[i] += spring * goal.y;
        }
        // Fixed vertices by a penalty far above everything else.
        for i in [0, 1, n - 2, n - 1] {
            const FIXED: f64 = 1e9;
            matrix.diagonal[i] += FIXED;
            x[i] += FIXED * self.points[i].x;
            y[i] += FIXED * self.points[i].y;
        }
        let factor = matrix.factorize();
        factor.solve(&mut x);
        factor.solve(&mut y);
        for i in 2..n - 2 {
            self.points[i] = Point::new(x[i], y[i]);
        }
    }

    /// Stiffness of the springs at a vertex and how far they want it to move.
    fn room(&self, p: Point, forward: Point) -> (f64, Point) {
        let pair = &self.terrain.pair;
        let left = forward.perp();
        let mut stiffness = 0.0;
        let mut pull = Point::ZERO;
        let wanted = pair.radius + pair.clearance;
        if self.terrain.distance(p) < pair.half_separation + wanted {
            for offset in [0.0, pair.half_separation, -pair.half_separation] {
                let (d, gradient) = self.terrain.distance_and_gradient(p + left * offset);
                let short = wanted - d;
                if short > 0.0 {
                    stiffness += ROOM;
                    pull += gradient * (short.min(0.3) * ROOM);
                }
            }
        }
        for object in self.terrain.objects_near(p) {
            let r = object.center - p;
            let along = r.dot(forward);
            if along.abs() < 0.3 {
                let offset = r.dot(left);
                let keep = object.radius + pair.radius + pair.clearance;
                let widen = offset.abs() + keep - pair.half_separation;
                let shift = pair.half_separation + keep - offset.abs();
                if widen > 0.0 && shift > 0.0 {
                    let weight = OBJECT * (1.0 - along.abs() / 0.3);
                    let step = if widen < shift { widen } else { -shift } * offset.signum();
                    stiffness += weight;
                    pull += left * (step.clamp(-0.2, 0.2) * weight);
                }
            }
        }
        if stiffness > 0.0 {
            (stiffness, pull / stiffness)
        } else {
            (0.0, Point::ZERO)
        }
    }
}

/// The vertex nearest to each goal with non-decreasing indices: dynamic programming over the squared distances.
pub(crate) fn attach(points: &[Point], goals: &[Point]) -> Vec<usize> {
    let n = points.len();
    if n == 0 {
        return Vec::new();
    }
    // cost[i]: best sum for the goals so far with the last one attached at or before i.
    let mut cost = vec![0.0; n];
    let mut choice: Vec<Vec<u32>> = Vec::with_capacity(goals.len());
    for goal in goals {
        let mut best = f64::INFINITY;
        let mut at = 0u32;
        let mut row = Vec::with_capacity(n);
        for i in 0..n {
            let here = cost[i] + (points[i] - *goal).norm_squared();
            if here < best {
                best = here;
                at = i as u32;
            }
            cost[i] = best;
            row.push(at);
        }
        choice.push(row);
    }
    let mut indices = vec![0; goals.len()];
    let mut limit = n - 1;
    for k in (0..goals.len()).rev() {
        limit = choice[k][limit] as usize;
        indices[k] = limit;
    }
    indices
}
