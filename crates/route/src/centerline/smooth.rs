//! Smoothing of a searched centerline as an elastic band.
//!
//! minimize  1/2 int (alpha |p'|^2 + beta |p''|^2) ds + stiff springs to the circles' centers and away from obstacles,
//! with both end poses fixed. Springs are refreshed and one linear system is solved per iteration.

use super::attachment::{Attachment, attach};
use super::itinerary::Itinerary;
use crate::banded::Pentadiagonal;
use crate::polyline::{arc_lengths, refine, resample, tangents, with_headings};
use crate::terrain::Terrain;
use pairtrawl_geometry::{Point, Pose};

/// Spacing of the band's vertices.
const SPACING: f64 = 0.1;
/// Spacing of the result.
const RESULT_SPACING: f64 = 0.05;
/// Tension alpha.
const TENSION: f64 = 0.5;
/// Bending stiffness beta: sqrt(beta / alpha) is the radius in which a taut band rounds a corner.
const BENDING: f64 = 0.25;
/// Inertia: pulls every vertex towards its last position.
const INERTIA: f64 = 3.0;
/// Stiffness of the spring at a circle's center.
const GOAL: f64 = 60.0;
/// Stiffness of the spring that makes room for the robots.
const ROOM: f64 = 150.0;
/// Stiffness of the spring that keeps objects well inside or outside of the band.
const OBJECT: f64 = 6.0;
/// How near to a circle's center its spring is at rest: exact passage is not worth a sharp bend.
const GOAL_REST: f64 = 0.07;
/// Radius of the tightest curvature that the band tolerates before it stiffens there, where 0.6 is comfortable.
const TIGHTEST: f64 = 0.55;
/// Factor by which it stiffens in an iteration, and stiffness at most.
const STIFFEN: f64 = 1.5;
const STIFFEST: f64 = 200.0;
/// Vertices on either side that stiffen along: a bend must not just move to the next vertex.
const SPREAD: usize = 1;
/// Radius of the curvature at which the spring of a circle nearby yields, where 0.6 is comfortable, by which factor per
/// iteration, and up to which distance from the circle's center: in a sharp corner a circle is better taken off the middle of the band than by a pair that
/// turns on the spot.
const YIELDING: f64 = 0.4;
const COMFORTABLE: f64 = 0.6;
const SOFTEN: f64 = 0.85;
const FARTHEST: f64 = 0.25;
const ITERATIONS: usize = 80;
/// Turn within 0.8 that makes a long bend, rad, and the stiffness that it begins with.
const LONG_BEND: f64 = 0.8;
const BEND_STIFFNESS: f64 = 15.0;

/// How far beside a stop a smooth line may pass it, in comfortable turning radii. Where it would pass farther off, it stays as it was searched ...
const LOST: f64 = 1.0;
/// ... over this length to both sides of the stop, in comfortable turning radii.
const KEPT: f64 = 3.0;
/// Stretches beside kept ones that have fewer vertices than this are kept too.
const LEAST_STRETCH: usize = 12;
/// Times that more is kept, at most.
const ROUNDS: usize = 4;

/// A smooth centerline along `raw`, resampled evenly. It loses no stop that `raw` passes: a band pulls tight, and a loop
/// with a stop on it would vanish.
pub(crate) fn smooth(terrain: &Terrain, itinerary: &Itinerary, raw: &[Pose]) -> Vec<Pose> {
    let searched: Vec<Point> = raw.iter().map(|p| p.position()).collect();
    let held = attach(&searched, &itinerary.goals);
    let lost_beyond = LOST * terrain.pair.turning;
    let (s, reach) = (arc_lengths(&searched), KEPT * terrain.pair.turning);
    let mut kept = vec![false; searched.len()];
    let mut points = Vec::new();
    for _ in 0..ROUNDS {
        points = relaxed(terrain, itinerary, &searched, &held, &kept);
        let passed = attach(&points, &itinerary.goals);
        let mut lost = false;
        for ((goal, &at), &now) in itinerary.goals.iter().zip(&held).zip(&passed) {
            let off = points[now].distance(*goal);
            if off > lost_beyond && off > searched[at].distance(*goal) + GOAL_REST && !kept[at] {
                lost = true;
                let near = s.iter().map(|along| (along - s[at]).abs() <= reach);
                (kept.iter_mut().zip(near)).for_each(|(kept, near)| *kept |= near);
            }
        }
        if !lost {
            break;
        }
    }
    let fine = refine(&points, 4);
    let points = resample(&fine, RESULT_SPACING);
    with_headings(&points, itinerary.start.heading, itinerary.end.heading)
}

/// The searched line with everything smoothed but the kept vertices; `held` is the vertex that passes each goal.
fn relaxed(
    terrain: &Terrain,
    itinerary: &Itinerary,
    searched: &[Point],
    held: &[usize],
    kept: &[bool],
) -> Vec<Point> {
    let last = searched.len() - 1;
    let directions = tangents(searched);
    let pose = |i: usize| match i {
        0 => itinerary.start,
        i if i == last => itinerary.end,
        i => Pose::at(searched[i], directions[i].angle()),
    };
    let mut points = vec![searched[0]];
    let mut from = 0;
    while from < last {
        let to = (from + 1..last).find(|&i| kept[i] != kept[from + 1]);
        let to = to.unwrap_or(last);
        let is_all = (from, to) == (0, last);
        if kept[from + 1] || (to - from < LEAST_STRETCH && !is_all) {
            points.extend_from_slice(&searched[from + 1..=to]);
        } else {
            let here = held.iter().zip(&itinerary.goals);
            let part = Itinerary {
                start: pose(from),
                goals: here
                    .filter(|(at, _)| (from..=to).contains(*at))
                    .map(|(_, &goal)| goal)
                    .collect(),
                end: pose(to),
            };
            let mut band = Band::new(terrain, &part, &searched[from..=to]);
            for _ in 0..ITERATIONS {
                // Evenly spread in every round: vertices that crowd in a bend would hide its curvature.
                band.spread();
                band.relax();
            }
            band.spread();
            points.extend_from_slice(&band.points[1..]);
        }
        from = to;
    }
    points
}

struct Band<'a> {
    terrain: &'a Terrain,
    itinerary: &'a Itinerary,
    points: Vec<Point>,
    /// Bending stiffness at each vertex relative to [`BENDING`].
    stiffness: Vec<f64>,
    /// Which vertex holds each goal.
    hold: Attachment<'a>,
    /// Stiffness of the spring at each goal relative to [`GOAL`].
    goals: Vec<f64>,
}

impl<'a> Band<'a> {
    fn new(terrain: &'a Terrain, itinerary: &'a Itinerary, searched: &[Point]) -> Self {
        Self {
            terrain,
            itinerary,
            points: searched.to_vec(),
            stiffness: Vec::new(),
            hold: Attachment::new(&itinerary.goals),
            goals: vec![1.0; itinerary.goals.len()],
        }
    }

    /// Spreads the vertices evenly and puts the second and the last but one where the end headings want them.
    fn spread(&mut self) {
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
        let old = std::mem::take(&mut self.stiffness);
        self.stiffness = if old.is_empty() {
            self.searched_bends()
        } else {
            // What was stiff stays stiff: the vertices hardly move along the band.
            (0..n)
                .map(|i| old[(i * old.len() / n).min(old.len() - 1)])
                .collect()
        };
    }

    /// Stiffness at first: long bends of the search are there for a reason and must not collapse before they stiffen.
    fn searched_bends(&self) -> Vec<f64> {
        let n = self.points.len();
        let directions = tangents(&self.points);
        let turn = |i: usize| {
            let (a, b) = (
                directions[i.saturating_sub(4)],
                directions[(i + 4).min(n - 1)],
            );
            libm::atan2(a.cross(b), a.dot(b)).abs()
        };
        (0..n)
            .map(|i| {
                if turn(i) > LONG_BEND {
                    BEND_STIFFNESS
                } else {
                    1.0
                }
            })
            .collect()
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
        let attachments = self.hold.follow(&self.points);
        let wide = self.terrain.pair.turning / COMFORTABLE;
        let (tightest, yielding) = (1.0 / (TIGHTEST * wide), 1.0 / (YIELDING * wide));
        let mut matrix = Pentadiagonal::zeros(n);
        for i in 0..n - 1 {
            matrix.add(i, [-1.0, 1.0, 0.0], TENSION / h);
        }
        let mut x = vec![0.0; n];
        let mut y = vec![0.0; n];
        for i in 0..n - 2 {
            let [a, b, c] = [self.points[i], self.points[i + 1], self.points[i + 2]];
            let bend = a - b * 2.0 + c;
            let curvature = bend.norm() / (h * h);
            if curvature > tightest {
                for k in i.saturating_sub(SPREAD)..(i + 3 + SPREAD).min(n) {
                    self.stiffness[k] = (self.stiffness[k] * STIFFEN).min(STIFFEST);
                }
            }
            if curvature > yielding {
                for (k, &at) in attachments.iter().enumerate() {
                    let miss = self.points[at].distance(self.itinerary.goals[k]);
                    if at.abs_diff(i + 1) <= 6 && miss < FARTHEST {
                        self.goals[k] *= SOFTEN;
                    }
                }
            }
            const DIFFERENCE: [f64; 3] = [1.0, -2.0, 1.0];
            matrix.add(i, DIFFERENCE, BENDING / (h * h * h));
            // What is stiffer wants the bend that it has, or the tightest one that is allowed.
            let weight = BENDING * (self.stiffness[i + 1] - 1.0) / (h * h * h);
            matrix.add(i, DIFFERENCE, weight);
            let allowed = bend * (tightest / curvature.max(tightest));
            for (k, difference) in DIFFERENCE.into_iter().enumerate() {
                x[i + k] += weight * difference * allowed.x;
                y[i + k] += weight * difference * allowed.y;
            }
        }
        let directions = tangents(&self.points);
        for i in 0..n {
            let (stiffness, shift) = self.room(self.points[i], directions[i]);
            let weight = h * (INERTIA + stiffness);
            matrix.diagonal[i] += weight;
            let target = self.points[i] * weight + shift * (h * stiffness);
            x[i] += target.x;
            y[i] += target.y;
        }
        for (k, i) in attachments.into_iter().enumerate() {
            let center = self.itinerary.goals[k];
            let miss = self.points[i] - center;
            let goal = center
                + miss
                    * (GOAL_REST / miss.norm().max(GOAL_REST))
                        .min(miss.norm() / miss.norm().max(1e-12));
            if miss.norm() > FARTHEST {
                self.goals[k] = (self.goals[k] / SOFTEN).min(1.0);
            }
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
