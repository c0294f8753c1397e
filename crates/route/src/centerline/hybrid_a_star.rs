//! Hybrid A* (Dolgov et al. 2010) for the pair's midpoint, all circles in one layered search.
//!
//! A state is (x, y, heading) with continuous position and one of 24 headings counted from the start's, so turns by
//! a motion primitive are exact. Leg k is searched from every heading in which leg k - 1 arrived at its circle, so the
//! heading in which a circle is passed is chosen by what it costs before and after. The last leg ends with Dubins
//! shots at the exact end pose. The heuristic is the fast-marching distance to the leg's goal.

use super::corridor::{Corridor, LADDER};
use super::dubins::Dubins;
use super::{Itinerary, smooth};
use crate::RouteError;
use crate::geodesic::{CostGrid, Geodesic};
use crate::terrain::Terrain;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::Scene;
use pairtrawl_world::World;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::TAU;

/// Headings of the lattice.
const BINS: usize = 24;
/// Edge of a cell in which only the cheapest state of a heading survives, m.
const CELL: f64 = 0.1;
/// Arrivals this much dearer than the cheapest are still worth keeping for the next leg, m.
const SLACK: f64 = 1.6;
/// Dubins shots at the end are tried from states nearer than this, m.
const SHOT_RANGE: f64 = 4.0;
/// Spacing at which shots are checked, m.
const SHOT_SPACING: f64 = 0.1;
/// Expansions per leg, at most.
const MAX_EXPANSIONS: usize = 400_000;
/// Price of heading change, m/rad: straight beats wavy at equal length.
const TURNING: f64 = 0.05;
/// Price of turning in the other direction than before, m.
const WAVERING: f64 = 0.02;

/// The centerline: poses about 0.05 m apart from the start midpoint through the circles to the end midpoint.
///
/// It passes every circle's center within about 0.1 m in the given order (further only where an obstacle leaves no
/// other way), turns with a radius of 0.6 m or, where that finds no way, down to 0.3 m, and begins and ends in the
/// direction of a pair that stands abreast. Headings are continuous.
///
/// # Errors
/// [`RouteError::BadOrder`] when `order` is not a permutation of the circles, [`RouteError::NoPath`] when there is no
/// way even for the smallest radius and margin.
pub fn centerline(world: &World, scene: &Scene, order: &[usize]) -> Result<Vec<Pose>, RouteError> {
    let itinerary = Itinerary::new(&world.circles, scene, order)?;
    on_terrain(&Terrain::new(world, scene), &itinerary)
}

pub(crate) fn on_terrain(
    terrain: &Terrain,
    itinerary: &Itinerary,
) -> Result<Vec<Pose>, RouteError> {
    let grid = CostGrid::new(terrain);
    let mut failure = RouteError::NoPath {
        from: itinerary.start.position(),
        to: itinerary.end.position(),
    };
    for strictness in LADDER {
        match search(
            &Corridor {
                terrain,
                strictness,
            },
            &grid,
            itinerary,
        ) {
            Ok(raw) => return Ok(smooth::smooth(terrain, itinerary, &raw)),
            Err(e) => failure = e,
        }
    }
    Err(failure)
}

#[derive(Clone, Copy)]
struct Node {
    position: Point,
    bin: u8,
    /// Primitive that led here; neighbors of it waver less.
    bend: i8,
    parent: u32,
    cost: f64,
}

/// One motion: a bend (-1 right, 0 straight, 1 left) and the displacement for each heading at half way and at the end.
struct Primitive {
    bend: i8,
    turn: isize,
    length: f64,
    half: [(Point, Point); BINS],
    full: [Point; BINS],
}

fn primitives(radius: f64, first_heading: f64) -> Vec<Primitive> {
    let step = TAU / BINS as f64;
    let mut all = Vec::new();
    for (bend, r) in [
        (0i8, f64::INFINITY),
        (1, radius),
        (-1, radius),
        (1, 2.0 * radius),
        (-1, 2.0 * radius),
    ] {
        let length = if bend == 0 { radius * step } else { r * step };
        let curvature = f64::from(bend) / r;
        let displacement = |heading: f64, s: f64| {
            // Chord of an arc: s sinc(kappa s / 2) along the mean heading.
            let half = 0.5 * curvature * s;
            let chord = if half == 0.0 {
                s
            } else {
                s * half.sin() / half
            };
            Point::unit(heading + half) * chord
        };
        let heading = |bin: usize| first_heading + step * bin as f64;
        all.push(Primitive {
            bend,
            turn: isize::from(bend),
            length,
            half: std::array::from_fn(|bin| {
                let h = heading(bin);
                (
                    displacement(h, 0.5 * length),
                    Point::unit(h + 0.5 * curvature * length),
                )
            }),
            full: std::array::from_fn(|bin| displacement(heading(bin), length)),
        });
    }
    all
}

struct Lattice<'c> {
    corridor: &'c Corridor<'c>,
    first_heading: f64,
    forward: [Point; BINS],
    primitives: Vec<Primitive>,
    columns: usize,
    rows: usize,
    /// Cheapest node of the current leg in each (cell, heading), with the leg's number to tell stale entries.
    best: Vec<(u32, u32)>,
    nodes: Vec<Node>,
}

fn search(
    corridor: &Corridor,
    grid: &CostGrid,
    itinerary: &Itinerary,
) -> Result<Vec<Pose>, RouteError> {
    let first_heading = itinerary.start.heading;
    let step = TAU / BINS as f64;
    let size = corridor.terrain.max - corridor.terrain.min;
    let columns = (size.x / CELL) as usize + 1;
    let rows = (size.y / CELL) as usize + 1;
    let mut lattice = Lattice {
        corridor,
        first_heading,
        forward: std::array::from_fn(|bin| Point::unit(first_heading + step * bin as f64)),
        primitives: primitives(corridor.strictness.radius, first_heading),
        columns,
        rows,
        best: vec![(u32::MAX, 0); columns * rows * BINS],
        nodes: Vec::new(),
    };
    let none = u32::MAX;
    lattice.nodes.push(Node {
        position: itinerary.start.position(),
        bin: 0,
        bend: 0,
        parent: none,
        cost: 0.0,
    });
    let mut seeds = vec![0u32];
    let stops = itinerary.stops();
    let mut leg = 0;
    for &goal in &itinerary.goals {
        seeds = lattice
            .leg(grid, &seeds, goal, leg)
            .ok_or(RouteError::NoPath {
                from: stops[leg as usize],
                to: goal,
            })?;
        leg += 1;
    }
    let no_path = RouteError::NoPath {
        from: stops[leg as usize],
        to: itinerary.end.position(),
    };
    let (last, shot) = lattice
        .last_leg(grid, &seeds, itinerary.end, leg)
        .ok_or(no_path)?;
    Ok(lattice.trace(last, &shot))
}

impl Lattice<'_> {
    fn cell(&self, p: Point, bin: u8) -> Option<usize> {
        let c = (p - self.corridor.terrain.min) / CELL;
        let inside =
            c.x >= 0.0 && c.y >= 0.0 && (c.x as usize) < self.columns && (c.y as usize) < self.rows;
        inside.then(|| ((c.y as usize) * self.columns + c.x as usize) * BINS + usize::from(bin))
    }

    /// Searches one leg; returns the cheapest arrival of every heading, cheapest first.
    fn leg(&mut self, grid: &CostGrid, seeds: &[u32], goal: Point, leg: u32) -> Option<Vec<u32>> {
        let heuristic = self.heuristic(grid, seeds, goal);
        let reach = self.corridor.strictness.reach;
        let mut arrivals: [Option<(f64, u32)>; BINS] = [None; BINS];
        let mut bound = f64::INFINITY;
        let mut heap = self.open(seeds, &heuristic);
        let mut expansions = 0;
        while let Some((Reverse(bits), Reverse(n))) = heap.pop() {
            let f = f64::from_bits(bits);
            if f > bound || expansions > MAX_EXPANSIONS {
                break;
            }
            let node = self.nodes[n as usize];
            if self.is_stale(n, leg) {
                continue;
            }
            let miss = node.position.distance(goal);
            if miss < reach {
                let cost = node.cost + miss;
                let slot = &mut arrivals[usize::from(node.bin)];
                if slot.is_none_or(|s| cost < s.0) {
                    *slot = Some((cost, n));
                    bound = bound.min(cost + SLACK);
                }
                // Nothing is gained by going on from here: the next leg does.
                continue;
            }
            expansions += 1;
            self.expand(n, leg, &heuristic, &mut heap);
        }
        let mut found: Vec<(f64, u32)> = arrivals.into_iter().flatten().collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        (!found.is_empty()).then(|| found.into_iter().map(|f| f.1).collect())
    }

    /// Searches the last leg; returns the node from which the final shot leaves, and the shot.
    fn last_leg(
        &mut self,
        grid: &CostGrid,
        seeds: &[u32],
        end: Pose,
        leg: u32,
    ) -> Option<(u32, Vec<Pose>)> {
        let heuristic = self.heuristic(grid, seeds, end.position());
        let mut best: Option<(f64, u32, Vec<Pose>)> = None;
        let mut heap = self.open(seeds, &heuristic);
        let mut expansions = 0;
        while let Some((Reverse(bits), Reverse(n))) = heap.pop() {
            let f = f64::from_bits(bits);
            if best.as_ref().is_some_and(|b| f >= b.0) || expansions > MAX_EXPANSIONS {
                break;
            }
            if self.is_stale(n, leg) {
                continue;
            }
            let node = self.nodes[n as usize];
            if node.position.distance(end.position()) < SHOT_RANGE {
                let from = Pose::at(node.position, self.heading(node.bin));
                let shot = Dubins::new(from, end, self.corridor.strictness.radius);
                if best
                    .as_ref()
                    .is_none_or(|b| node.cost + shot.length() < b.0)
                {
                    let poses = shot.sample(SHOT_SPACING);
                    if let Some(cost) = self.shot_cost(&poses, shot.length()) {
                        let total = node.cost + cost;
                        if best.as_ref().is_none_or(|b| total < b.0) {
                            best = Some((total, n, poses));
                        }
                    }
                }
            }
            expansions += 1;
            self.expand(n, leg, &heuristic, &mut heap);
        }
        best.map(|b| (b.1, b.2))
    }

    fn shot_cost(&self, poses: &[Pose], length: f64) -> Option<f64> {
        let spacing = length / (poses.len() - 1).max(1) as f64;
        let mut cost = 0.0;
        // The end pose is the scene's: what it costs is not ours to judge.
        for w in poses.windows(2) {
            cost += spacing * (1.0 + self.corridor.penalty(w[0])?)
                + TURNING * (w[1].heading - w[0].heading).abs();
        }
        Some(cost)
    }

    fn heading(&self, bin: u8) -> f64 {
        self.first_heading + TAU / BINS as f64 * f64::from(bin)
    }

    fn heuristic<'g>(&self, grid: &'g CostGrid, seeds: &[u32], goal: Point) -> Geodesic<'g> {
        // The front runs until it has passed all seeds by a margin, so that detours find values too.
        let mut ahead: Vec<Point> = seeds
            .iter()
            .map(|&s| self.nodes[s as usize].position)
            .collect();
        let mut limit = f64::INFINITY;
        Geodesic::march(grid, goal, move |p, t| {
            ahead.retain(|s| s.distance(p) > 0.3);
            if ahead.is_empty() && limit.is_infinite() {
                limit = t + 4.0;
            }
            t > limit
        })
    }

    fn open(
        &self,
        seeds: &[u32],
        heuristic: &Geodesic,
    ) -> BinaryHeap<(Reverse<u64>, Reverse<u32>)> {
        let f = |s: u32| {
            let node = &self.nodes[s as usize];
            node.cost + heuristic.at(node.position)
        };
        seeds
            .iter()
            .filter(|&&s| f(s).is_finite())
            .map(|&s| (Reverse(f(s).to_bits()), Reverse(s)))
            .collect()
    }

    /// True when a cheaper state has taken the node's place in its cell since it was opened.
    fn is_stale(&self, n: u32, leg: u32) -> bool {
        let node = &self.nodes[n as usize];
        self.cell(node.position, node.bin).is_some_and(|c| {
            let (owner_leg, owner) = self.best[c];
            owner_leg == leg && owner != n && self.nodes[owner as usize].cost < node.cost
        })
    }

    fn expand(
        &mut self,
        n: u32,
        leg: u32,
        heuristic: &Geodesic,
        heap: &mut BinaryHeap<(Reverse<u64>, Reverse<u32>)>,
    ) {
        let node = self.nodes[n as usize];
        let bin = usize::from(node.bin);
        for k in 0..self.primitives.len() {
            let primitive = &self.primitives[k];
            let position = node.position + primitive.full[bin];
            let to = (bin as isize + primitive.turn).rem_euclid(BINS as isize) as u8;
            let Some(cell) = self.cell(position, to) else {
                continue;
            };
            let (half, half_forward) = primitive.half[bin];
            let wavering = if primitive.bend == node.bend {
                0.0
            } else {
                WAVERING
            };
            let base = node.cost
                + primitive.length
                + TURNING * TAU / BINS as f64 * f64::from(primitive.bend.abs())
                + wavering;
            let (owner_leg, owner) = self.best[cell];
            let owned = if owner_leg == leg {
                self.nodes[owner as usize].cost
            } else {
                f64::INFINITY
            };
            if base >= owned {
                continue;
            }
            let Some(midway) = self.corridor.penalty_at(node.position + half, half_forward) else {
                continue;
            };
            let Some(there) = self
                .corridor
                .penalty_at(position, self.forward[usize::from(to)])
            else {
                continue;
            };
            let cost = base + 0.5 * primitive.length * (midway + there);
            if cost >= owned {
                continue;
            }
            let f = cost + heuristic.at(position);
            if !f.is_finite() {
                continue;
            }
            let bend = primitive.bend;
            let id = self.nodes.len() as u32;
            self.nodes.push(Node {
                position,
                bin: to,
                bend,
                parent: n,
                cost,
            });
            self.best[cell] = (leg, id);
            heap.push((Reverse(f.to_bits()), Reverse(id)));
        }
    }

    /// Poses from the start to the node, then the shot.
    fn trace(&self, last: u32, shot: &[Pose]) -> Vec<Pose> {
        let mut poses = Vec::new();
        let mut n = last;
        while n != u32::MAX {
            let node = &self.nodes[n as usize];
            poses.push(Pose::at(node.position, self.heading(node.bin)));
            n = node.parent;
        }
        poses.reverse();
        poses.extend_from_slice(shot.get(1..).unwrap_or_default());
        poses
    }
}
