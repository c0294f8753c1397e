//! Informed RRT* (Gammell, Srinivasa and Barfoot 2014) for the pair's midpoint, leg by leg.
//!
//! Each leg grows a tree of straight edges whose cost is length plus what narrowness and objects cost, rewires it within
//! a radius that shrinks like sqrt(log n / n), and, once a way is known, samples only the ellipse that can hold a better
//! one: asymptotically optimal for a leg without turning limit. The headings at all corners are then chosen together by
//! dynamic programming over Dubins paths, which put the pair's turning limit in, and the whole is smoothed like the
//! result of the hybrid A*.

use super::corridor::{Corridor, ladder};
use super::dubins::Dubins;
use super::hybrid_a_star::shot_price;
use super::itinerary::Itinerary;
use super::smooth;
use crate::error::RouteError;
use crate::random::SplitMix;
use crate::terrain::Terrain;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::Scene;
use pairtrawl_world::World;
use std::f64::consts::{PI, TAU};

/// Longest edge of a tree.
const STEER: f64 = 1.0;
/// Share of samples that are the goal while no way is known.
const GOAL_BIAS: f64 = 0.05;
/// Spacing at which edges and Dubins paths are checked.
const SPACING: f64 = 0.1;
/// Headings tried at every corner.
const HEADINGS: usize = 24;
/// Corners nearer to each other than this are merged where the way allows.
const CORNER_SPACING: f64 = 0.8;
/// Half of the samples lie within this of the rectangle around the ends of a leg: in a wide area the rest is too sparse.
const AROUND: f64 = 20.0;

/// The centerline by informed RRT*: as [`super::hybrid_a_star::centerline`] returns it, from `seed` with `iterations`
/// samples for each leg. More samples make shorter ways; a few hundred find one in the open, thousands in a maze.
///
/// # Errors
/// [`RouteError::BadOrder`] when `order` is not a permutation of the circles, [`RouteError::SearchLimit`] when a leg found
/// no way within `iterations` samples even for the smallest radius and margin.
pub fn centerline(
    world: &World,
    scene: &Scene,
    order: &[usize],
    seed: u64,
    iterations: usize,
) -> Result<Vec<Pose>, RouteError> {
    let itinerary = Itinerary::new(&world.circles, scene, order)?;
    on_terrain(&Terrain::new(world, scene), &itinerary, seed, iterations)
}

pub(crate) fn on_terrain(
    terrain: &Terrain,
    itinerary: &Itinerary,
    seed: u64,
    iterations: usize,
) -> Result<Vec<Pose>, RouteError> {
    let mut failure = RouteError::SearchLimit {
        from: itinerary.start.position(),
        to: itinerary.end.position(),
        states: iterations,
    };
    for strictness in ladder(&terrain.pair) {
        let corridor = Corridor {
            terrain,
            strictness,
        };
        match corners(&corridor, itinerary, seed, iterations)
            .and_then(|c| with_turns(&corridor, itinerary, &c, iterations))
        {
            Ok(raw) => return Ok(smooth::smooth(terrain, itinerary, &raw)),
            Err(e) => failure = e,
        }
    }
    Err(failure)
}

/// Start, corners and circles in order, end.
fn corners(
    corridor: &Corridor,
    itinerary: &Itinerary,
    seed: u64,
    iterations: usize,
) -> Result<Vec<Point>, RouteError> {
    let mut corners = vec![itinerary.start.position()];
    let mut from = itinerary.start.position();
    for (leg, &to) in itinerary
        .goals
        .iter()
        .chain(&[itinerary.end.position()])
        .enumerate()
    {
        let mut random = SplitMix::new(seed.wrapping_add((leg as u64) << 32));
        let way = Tree::new(corridor, from).grow(to, iterations, &mut random);
        let way = way.ok_or(RouteError::SearchLimit {
            from,
            to,
            states: iterations,
        })?;
        corners.extend_from_slice(&straighten(corridor, &way)[1..]);
        from = to;
    }
    Ok(corners)
}

/// Cost of a straight edge, or `None` when the pair does not fit along it. Its ends may be stops that were not chosen, so
/// they are not judged.
fn edge(corridor: &Corridor, a: Point, b: Point) -> Option<f64> {
    let length = a.distance(b);
    if length < 1e-9 {
        return Some(0.0);
    }
    let forward = (b - a) / length;
    let n = (length / SPACING).ceil().max(2.0) as usize;
    let mut penalty = 0.0;
    for i in 1..n {
        penalty += corridor.penalty_at(a.lerp(b, i as f64 / n as f64), forward)?;
    }
    Some(length * (1.0 + penalty / (n - 1) as f64))
}

/// Leaves out corners as long as that costs nothing, or little and they are close together.
fn straighten(corridor: &Corridor, way: &[Point]) -> Vec<Point> {
    let mut kept = vec![way[0]];
    let mut i = 0;
    while i + 1 < way.len() {
        let mut next = i + 1;
        let mut along = edge(corridor, way[i], way[next]).unwrap_or(0.0);
        for k in i + 2..way.len() {
            along += edge(corridor, way[k - 1], way[k]).unwrap_or(0.0);
            let slack = if way[k - 1].distance(way[i]) < CORNER_SPACING {
                1.1
            } else {
                1.001
            };
            match edge(corridor, way[i], way[k]) {
                Some(direct) if direct <= slack * along => next = k,
                _ => break,
            }
        }
        kept.push(way[next]);
        i = next;
    }
    kept
}

/// The tree of a leg.
struct Tree<'c> {
    corridor: &'c Corridor<'c>,
    points: Vec<Point>,
    parents: Vec<usize>,
    children: Vec<Vec<usize>>,
    costs: Vec<f64>,
}

impl<'c> Tree<'c> {
    fn new(corridor: &'c Corridor<'c>, root: Point) -> Self {
        Self {
            corridor,
            points: vec![root],
            parents: vec![0],
            children: vec![Vec::new()],
            costs: vec![0.0],
        }
    }

    /// Grows towards `goal`; returns the best way found.
    fn grow(mut self, goal: Point, iterations: usize, random: &mut SplitMix) -> Option<Vec<Point>> {
        let root = self.points[0];
        let (min, max) = (self.corridor.terrain.min, self.corridor.terrain.max);
        let whole = (min, max - min);
        let low = Point::new(root.x.min(goal.x), root.y.min(goal.y));
        let high = Point::new(root.x.max(goal.x), root.y.max(goal.y));
        let around = Point::new(AROUND, AROUND);
        let (low, high) = (low - around, high + around);
        let low = Point::new(low.x.max(min.x), low.y.max(min.y));
        let high = Point::new(high.x.min(max.x), high.y.min(max.y));
        let near_by = (low, high - low);
        let mut found = None;
        if edge(self.corridor, root, goal).is_some() {
            found = self.add(goal, 2.0 * root.distance(goal) + 1e-9);
        }
        for i in 0..iterations {
            let (corner, size) = if i % 2 == 0 { whole } else { near_by };
            let (sample, area) = match found {
                Some(goal) => {
                    let (half_long, half_short) = self.ellipse(goal);
                    if half_short < 0.01 * half_long {
                        // The way is as good as straight: nothing is left to gain.
                        break;
                    }
                    (
                        self.inside_ellipse(goal, random),
                        PI * half_long * half_short,
                    )
                }
                None if random.unit() < GOAL_BIAS => (goal, size.x * size.y),
                None => {
                    let p = Point::new(size.x * random.unit(), size.y * random.unit());
                    (corner + p, size.x * size.y)
                }
            };
            let near = self.nearest(sample);
            let from = self.points[near];
            let reach = from.distance(sample);
            if reach < 1e-6 {
                continue;
            }
            let new = from.lerp(sample, (STEER / reach).min(1.0));
            let n = self.points.len() as f64 + 1.0;
            // Karaman and Frazzoli (2011): above this constant RRT* is asymptotically optimal in the plane.
            let gamma = 2.0 * (1.5 * area / PI).sqrt();
            let radius = (gamma * (libm::log(n) / n).sqrt()).min(STEER);
            let Some(added) = self.add(new, radius.max(from.distance(new) + 1e-9)) else {
                continue;
            };
            if found.is_none() && new.distance(goal) < STEER && new.distance(goal) > 1e-9 {
                found = self.add(goal, STEER);
            } else if new == goal {
                found = found.or(Some(added));
            }
        }
        let mut way = Vec::new();
        let mut node = found?;
        while node != 0 {
            way.push(self.points[node]);
            node = self.parents[node];
        }
        way.push(root);
        way.reverse();
        Some(way)
    }

    fn nearest(&self, p: Point) -> usize {
        let distance = |i: usize| (self.points[i] - p).norm_squared();
        (0..self.points.len())
            .min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(0)
    }

    /// Half axes of the ellipse of all ways that could be cheaper than the goal's: costs are no less than lengths.
    fn ellipse(&self, goal: usize) -> (f64, f64) {
        let direct = self.points[0].distance(self.points[goal]);
        let cost = self.costs[goal];
        (
            0.5 * cost,
            0.5 * (cost * cost - direct * direct).max(0.0).sqrt(),
        )
    }

    /// A point of that ellipse, all alike.
    fn inside_ellipse(&self, goal: usize, random: &mut SplitMix) -> Point {
        let (a, b) = (self.points[0], self.points[goal]);
        let (long, short) = self.ellipse(goal);
        let (radius, angle) = (random.unit().sqrt(), TAU * random.unit());
        let direct = a.distance(b);
        let axis = if direct > 1e-9 {
            (b - a) / direct
        } else {
            Point::new(1.0, 0.0)
        };
        a.lerp(b, 0.5)
            + axis * (long * radius * libm::cos(angle))
            + axis.perp() * (short * radius * libm::sin(angle))
    }

    /// Adds a point below its cheapest neighbor within `radius` and leads dearer neighbors through it.
    fn add(&mut self, p: Point, radius: f64) -> Option<usize> {
        // A straight line bounds an edge's cost from below, so few edges need to be looked at.
        let mut near: Vec<(f64, usize)> = (0..self.points.len())
            .filter(|&i| (self.points[i] - p).norm_squared() <= radius * radius)
            .map(|i| (self.costs[i] + self.points[i].distance(p), i))
            .collect();
        near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut best: Option<(f64, usize)> = None;
        for &(bound, i) in &near {
            if best.is_some_and(|b| bound >= b.0) {
                break;
            }
            if let Some(cost) = edge(self.corridor, self.points[i], p)
                && best.is_none_or(|b| self.costs[i] + cost < b.0)
            {
                best = Some((self.costs[i] + cost, i));
            }
        }
        let (cost, parent) = best?;
        let new = self.points.len();
        self.points.push(p);
        self.parents.push(parent);
        self.children.push(Vec::new());
        self.children[parent].push(new);
        self.costs.push(cost);
        for (_, i) in near {
            if cost + self.points[i].distance(p) >= self.costs[i] {
                continue;
            }
            let Some(onward) = edge(self.corridor, p, self.points[i]) else {
                continue;
            };
            let gain = self.costs[i] - (cost + onward);
            if gain > 1e-12 {
                let old = self.parents[i];
                self.children[old].retain(|&c| c != i);
                self.parents[i] = new;
                self.children[new].push(i);
                self.lower(i, gain);
            }
        }
        Some(new)
    }

    /// Lowers the cost of a node and of all below it.
    fn lower(&mut self, node: usize, by: f64) {
        let mut stack = vec![node];
        while let Some(i) = stack.pop() {
            self.costs[i] -= by;
            stack.extend_from_slice(&self.children[i]);
        }
    }
}

/// Headings at all corners, by dynamic programming: the cheapest chain of Dubins paths.
fn with_turns(
    corridor: &Corridor,
    itinerary: &Itinerary,
    corners: &[Point],
    iterations: usize,
) -> Result<Vec<Pose>, RouteError> {
    let last = corners.len() - 1;
    let headings = |i: usize| -> Vec<f64> {
        match i {
            0 => vec![itinerary.start.heading],
            i if i == last => vec![itinerary.end.heading],
            _ => (0..HEADINGS)
                .map(|k| TAU * k as f64 / HEADINGS as f64)
                .collect(),
        }
    };
    // Per corner and heading: cost from the start, heading at the corner before, and the path from there.
    type Best = Option<(f64, usize, Vec<Pose>)>;
    let mut stages: Vec<Vec<Best>> = vec![vec![Some((0.0, 0, Vec::new()))]];
    for i in 1..=last {
        let mut stage: Vec<Best> = Vec::new();
        for to in headings(i) {
            let goal = Pose::at(corners[i], to);
            let mut best: Best = None;
            for (k, from) in headings(i - 1).into_iter().enumerate() {
                let Some((cost, ..)) = stages[i - 1][k] else {
                    continue;
                };
                let path = Dubins::new(
                    Pose::at(corners[i - 1], from),
                    goal,
                    corridor.strictness.radius,
                );
                let bound = best.as_ref().map_or(f64::INFINITY, |b| b.0);
                if cost + path.length() >= bound {
                    continue;
                }
                let poses = path.sample(SPACING);
                if let Some(price) = shot_price(corridor, &poses, path.length())
                    && cost + price < bound
                {
                    best = Some((cost + price, k, poses));
                }
            }
            stage.push(best);
        }
        if stage.iter().all(Option::is_none) {
            return Err(RouteError::SearchLimit {
                from: corners[i - 1],
                to: corners[i],
                states: iterations,
            });
        }
        stages.push(stage);
    }
    let mut pieces: Vec<&[Pose]> = Vec::with_capacity(last);
    let mut heading = 0;
    for stage in stages[1..].iter().rev() {
        // Every heading on the cheapest chain is reachable, and the end has one heading only.
        let cheapest = |h: usize| stage.get(h).and_then(Option::as_ref);
        let Some((_, before, poses)) = cheapest(heading) else {
            continue;
        };
        pieces.push(poses);
        heading = *before;
    }
    let mut poses = vec![itinerary.start];
    for piece in pieces.into_iter().rev() {
        poses.extend_from_slice(&piece[1..]);
    }
    Ok(poses)
}

/// Cost of the best way of one leg, for tests of the search itself.
#[cfg(test)]
pub(crate) fn leg_cost(
    terrain: &Terrain,
    from: Point,
    to: Point,
    iterations: usize,
) -> Option<f64> {
    let corridor = Corridor {
        terrain,
        strictness: ladder(&terrain.pair)[0],
    };
    let way = Tree::new(&corridor, from).grow(to, iterations, &mut SplitMix::new(5))?;
    way.windows(2).map(|w| edge(&corridor, w[0], w[1])).sum()
}
