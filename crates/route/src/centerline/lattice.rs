//! The states of the hybrid A* and the motions between them.
//!
//! A state is (x, y, heading) with continuous position and one of [`BINS`] headings counted from the start's, so that
//! turns by a motion primitive are exact. Of all states in a cell with the same heading only the cheapest survives.

use super::corridor::Corridor;
use crate::geodesic::Geodesic;
use pairtrawl_geometry::{Point, Pose};
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::TAU;

/// Headings of the lattice.
pub(crate) const BINS: usize = 24;
/// Finest edge of a cell; its part of the turning radius, so that a motion leaves its cell; most cells.
const CELL: f64 = 0.1;
const CELL_OF_RADIUS: f64 = 1.0 / 6.0;
const MAX_CELLS: f64 = 1e9;
/// Cells along the edge of a tile; only tiles that the search enters take memory.
const TILE: usize = 16;
/// Price of heading change, a length per rad: straight beats wavy at equal length.
pub(crate) const TURNING: f64 = 0.05;
/// Price of turning in the other direction than before.
const WAVERING: f64 = 0.02;
/// The parent of the start.
const NONE: u32 = u32::MAX;

/// States to expand, the least estimate first; ties in the order of their making.
pub(crate) type Open = BinaryHeap<(Reverse<u64>, Reverse<u32>)>;

/// Leg and number of the cheapest node in each (cell, heading).
type Tile = Box<[(u32, u32)]>;

#[derive(Clone, Copy)]
pub(crate) struct Node {
    pub position: Point,
    pub bin: u8,
    /// Direction of the primitive that led here.
    bend: i8,
    parent: u32,
    pub cost: f64,
}

/// One motion: a bend (-1 right, 0 straight, 1 left) and the displacements for each heading.
struct Primitive {
    bend: i8,
    length: f64,
    /// At half way, with the direction there.
    half: [(Point, Point); BINS],
    full: [Point; BINS],
}

fn primitives(radius: f64, first_heading: f64) -> Vec<Primitive> {
    let step = TAU / BINS as f64;
    let bends = [
        (0i8, f64::INFINITY),
        (1, radius),
        (-1, radius),
        (1, 2.0 * radius),
        (-1, 2.0 * radius),
    ];
    bends
        .into_iter()
        .map(|(bend, r)| {
            let length = if bend == 0 { radius * step } else { r * step };
            let curvature = f64::from(bend) / r;
            // Chord of an arc: s sin(kappa s / 2) / (kappa s / 2) along the mean heading.
            let displacement = |heading: f64, s: f64| {
                let half = 0.5 * curvature * s;
                let chord = if half == 0.0 {
                    s
                } else {
                    s * libm::sin(half) / half
                };
                Point::unit(heading + half) * chord
            };
            let heading = |bin: usize| first_heading + step * bin as f64;
            Primitive {
                bend,
                length,
                half: std::array::from_fn(|bin| {
                    let h = heading(bin);
                    (
                        displacement(h, 0.5 * length),
                        Point::unit(h + 0.5 * curvature * length),
                    )
                }),
                full: std::array::from_fn(|bin| displacement(heading(bin), length)),
            }
        })
        .collect()
}

/// The states made so far, leg by leg.
pub(crate) struct Lattice<'c> {
    pub corridor: &'c Corridor<'c>,
    first_heading: f64,
    forward: [Point; BINS],
    primitives: Vec<Primitive>,
    cell: f64,
    columns: usize,
    rows: usize,
    tile_columns: usize,
    /// Per tile: the leg and the number of the cheapest node in each (cell, heading); entries of older legs are stale.
    tiles: Vec<Option<Tile>>,
    nodes: Vec<Node>,
    /// Nodes before this one belong to finished legs.
    base: usize,
    leg: u32,
}

impl<'c> Lattice<'c> {
    /// A lattice with one node, number 0, at the start.
    pub fn new(corridor: &'c Corridor<'c>, start: Pose) -> Self {
        let step = TAU / BINS as f64;
        let size = corridor.terrain.max - corridor.terrain.min;
        let radius = corridor.strictness.radius;
        let cell = CELL
            .max(CELL_OF_RADIUS * radius)
            .max((size.x * size.y / MAX_CELLS).sqrt());
        let columns = (size.x / cell) as usize + 1;
        let rows = (size.y / cell) as usize + 1;
        let tile_columns = columns.div_ceil(TILE);
        Self {
            corridor,
            first_heading: start.heading,
            forward: std::array::from_fn(|bin| Point::unit(start.heading + step * bin as f64)),
            primitives: primitives(radius, start.heading),
            cell,
            columns,
            rows,
            tile_columns,
            tiles: vec![None; tile_columns * rows.div_ceil(TILE)],
            nodes: vec![Node {
                position: start.position(),
                bin: 0,
                bend: 0,
                parent: NONE,
                cost: 0.0,
            }],
            base: 1,
            leg: 0,
        }
    }

    pub fn node(&self, n: u32) -> &Node {
        &self.nodes[n as usize]
    }

    pub fn pose(&self, n: u32) -> Pose {
        let node = self.node(n);
        Pose::at(
            node.position,
            self.first_heading + TAU / BINS as f64 * f64::from(node.bin),
        )
    }

    /// Ends a leg: forgets all its nodes but those on the ways to `arrivals`, and returns the arrivals' new numbers.
    pub fn finish_leg(&mut self, arrivals: &[u32]) -> Vec<u32> {
        let mut number = vec![NONE; self.nodes.len() - self.base];
        for &arrival in arrivals {
            let mut n = arrival;
            while n != NONE && n as usize >= self.base && number[n as usize - self.base] == NONE {
                number[n as usize - self.base] = 0;
                n = self.node(n).parent;
            }
        }
        let base = self.base;
        let renumbered = |n: u32, number: &[u32]| {
            if n != NONE && n as usize >= base {
                number[n as usize - base]
            } else {
                n
            }
        };
        // Parents come before their children, so one pass renumbers all.
        let mut next = base;
        for old in base..self.nodes.len() {
            if number[old - base] == NONE {
                continue;
            }
            let mut node = self.nodes[old];
            node.parent = renumbered(node.parent, &number);
            self.nodes[next] = node;
            number[old - base] = next as u32;
            next += 1;
        }
        self.nodes.truncate(next);
        self.base = next;
        self.leg += 1;
        arrivals.iter().map(|&n| renumbered(n, &number)).collect()
    }

    /// Tile and place in it of a position with a heading; `None` outside of the area.
    fn slot(&self, p: Point, bin: u8) -> Option<(usize, usize)> {
        let c = (p - self.corridor.terrain.min) / self.cell;
        if c.x < 0.0 || c.y < 0.0 {
            return None;
        }
        let (column, row) = (c.x as usize, c.y as usize);
        (column < self.columns && row < self.rows).then(|| {
            let tile = row / TILE * self.tile_columns + column / TILE;
            (
                tile,
                (row % TILE * TILE + column % TILE) * BINS + usize::from(bin),
            )
        })
    }

    /// The cheapest node of this leg in a slot.
    fn owner(&self, (tile, place): (usize, usize)) -> Option<u32> {
        let (leg, n) = self.tiles[tile].as_ref()?[place];
        (leg == self.leg).then_some(n)
    }

    /// The queue of a leg that begins at `seeds`.
    pub fn open(&self, seeds: &[u32], march: &Geodesic) -> Open {
        let estimate = |s: u32| self.node(s).cost + march.at(self.node(s).position);
        let reachable = seeds.iter().filter(|&&s| estimate(s).is_finite());
        reachable
            .map(|&s| (Reverse(estimate(s).to_bits()), Reverse(s)))
            .collect()
    }

    /// True when a cheaper state has taken the node's place since it was queued.
    pub fn is_stale(&self, n: u32) -> bool {
        let node = self.node(n);
        let owner = self
            .slot(node.position, node.bin)
            .and_then(|s| self.owner(s));
        owner.is_some_and(|o| o != n && self.node(o).cost < node.cost)
    }

    /// Queues the states that one motion leads to.
    pub fn expand(&mut self, n: u32, march: &Geodesic, open: &mut Open) {
        let node = *self.node(n);
        let bin = usize::from(node.bin);
        for primitive in &self.primitives {
            let position = node.position + primitive.full[bin];
            let to = (bin as isize + isize::from(primitive.bend)).rem_euclid(BINS as isize) as u8;
            let Some(slot) = self.slot(position, to) else {
                continue;
            };
            let wavering = if primitive.bend == node.bend {
                0.0
            } else {
                WAVERING
            };
            let turning = TURNING * TAU / BINS as f64 * f64::from(primitive.bend.abs());
            let base = node.cost + primitive.length + turning + wavering;
            let owned = self
                .owner(slot)
                .map_or(f64::INFINITY, |o| self.node(o).cost);
            if base >= owned {
                continue;
            }
            let (half, half_forward) = primitive.half[bin];
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
            let estimate = cost + march.at(position);
            if cost >= owned || !estimate.is_finite() {
                continue;
            }
            let id = self.nodes.len() as u32;
            self.nodes.push(Node {
                position,
                bin: to,
                bend: primitive.bend,
                parent: n,
                cost,
            });
            let tile = self.tiles[slot.0]
                .get_or_insert_with(|| vec![(NONE, 0); TILE * TILE * BINS].into());
            tile[slot.1] = (self.leg, id);
            open.push((Reverse(estimate.to_bits()), Reverse(id)));
        }
    }

    /// Poses from the start to a node.
    pub fn trace(&self, last: u32) -> Vec<Pose> {
        let mut poses = Vec::new();
        let mut n = last;
        while n != NONE {
            poses.push(self.pose(n));
            n = self.node(n).parent;
        }
        poses.reverse();
        poses
    }
}
