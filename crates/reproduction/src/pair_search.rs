//! A sampling-based planner for a tethered pair without dynamics, in the spirit of Teshnizi and Shell: a search over the
//! positions of both robots, straight motions, a bound on their distance, and nothing else.
//!
//! Samples are pairs of points: gates, where the line between the robots passes over a circle's center, and free ones.
//! A shortest path through gates of all circles in order is found on the graph of motions that keep robots off obstacles
//! and objects and the line between them off obstacles.

use pairtrawl::certificate::Clearance;
use pairtrawl::execute::Normal;
use pairtrawl::geometry::{Hull, Point, Pose, Segment, wrap_angle};
use pairtrawl::model::{PairTrajectory, Scene, default_step_time};
use pairtrawl::world::World;
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

/// Kept beyond what is needed, m, since gates lie on the bounds.
const SPARE: f64 = 0.01;
/// Headings of the line at a gate.
const ANGLES: usize = 16;
/// Free samples between two gates.
const FREE: usize = 160;
/// Motions are at most this long, m.
const REACH: f64 = 3.5;

/// Positions of (left, right).
type Pair = [Point; 2];

struct Search<'a> {
    scene: &'a Scene,
    clearance: Option<Clearance<'a>>,
    net_length: f64,
}

/// The shortest way of the pair through all circles in an order, or why there is none; `net_length` in m.
///
/// # Errors
/// Names the circle that cannot be reached.
pub fn search(
    scene: &Scene,
    world: &World,
    order: &[usize],
    net_length: f64,
    seed: u64,
) -> Result<Vec<Pair>, String> {
    let search = Search {
        scene,
        clearance: Clearance::new(scene),
        net_length,
    };
    let mut draw = Normal::new(seed);
    let start = [scene.start.left, scene.start.right].map(|p| p.position());
    let end = [scene.end.left, scene.end.right].map(|p| p.position());
    let mut layers: Vec<Vec<Pair>> = vec![vec![start]];
    for &circle in order {
        layers.push(search.gates(world.circles[circle].center));
    }
    layers.push(vec![end]);
    // For each pair of the layer that was reached, its cost and the way to it.
    let mut reached: Vec<(f64, Vec<Pair>)> = vec![(0.0, vec![start])];
    for (k, layer) in layers.iter().enumerate().skip(1) {
        let free = search.free(&layers[k - 1], layer, &mut draw);
        reached = search.next(&reached, &free, layer);
        if reached.is_empty() {
            let what = order
                .get(k - 1)
                .map_or("the end".to_owned(), |c| format!("circle {c}"));
            return Err(format!("no way to {what} with a net of {net_length:.2} m"));
        }
    }
    let best = reached.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
    best.map(|b| b.1).ok_or_else(|| "no way".to_owned())
}

impl Search<'_> {
    /// Pairs whose line passes over a point.
    fn gates(&self, center: Point) -> Vec<Pair> {
        let near = self
            .scene
            .objects
            .iter()
            .filter(|o| o.position.distance(center) < 1.0);
        let keep = near.map(|o| o.footprint_radius()).fold(0.0, f64::max)
            + self.scene.robot.radius
            + SPARE;
        let mut gates = Vec::new();
        for i in 0..ANGLES {
            let normal = Point::unit(std::f64::consts::TAU * i as f64 / ANGLES as f64).perp();
            for (left, right) in [
                (keep, keep),
                (keep, 1.6 * keep),
                (1.6 * keep, keep),
                (1.6 * keep, 1.6 * keep),
            ] {
                let gate = [center + normal * left, center + normal * -right];
                if self.stands(&gate) {
                    gates.push(gate);
                }
            }
        }
        gates
    }

    /// Free pairs between two layers.
    fn free(&self, from: &[Pair], to: &[Pair], draw: &mut Normal) -> Vec<Pair> {
        let all: Vec<Point> = from.iter().chain(to).flatten().copied().collect();
        let bounds = |of: fn(&Point) -> f64| {
            let values = all.iter().map(of);
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
                (l.min(v), h.max(v))
            })
        };
        let (x, y) = (bounds(|p| p.x), bounds(|p| p.y));
        let mut pairs = Vec::new();
        for _ in 0..4 * FREE {
            let center = Point::new(
                draw.between([x.0 - 0.7, x.1 + 0.7]),
                draw.between([y.0 - 0.7, y.1 + 0.7]),
            );
            let half = 0.5 * draw.between([2.0 * self.scene.robot.radius + SPARE, self.net_length]);
            let normal = Point::unit(draw.between([0.0, std::f64::consts::TAU]));
            let pair = [center + normal * half, center + normal * -half];
            if self.stands(&pair) && pairs.len() < FREE {
                pairs.push(pair);
            }
        }
        pairs
    }

    /// True when both robots may stand there.
    fn stands(&self, pair: &Pair) -> bool {
        let apart = pair[0].distance(pair[1]);
        apart <= self.net_length && apart >= 2.0 * self.scene.robot.radius && self.moves(pair, pair)
    }

    /// True when the straight motion from one pair to another is free. The distance of the robots is convex along it, so
    /// its bound holds in between.
    fn moves(&self, a: &Pair, b: &Pair) -> bool {
        let radius = self.scene.robot.radius;
        let inside = |p: &Point| {
            let area = &self.scene.area;
            p.x >= area.min.x && p.x <= area.max.x && p.y >= area.min.y && p.y <= area.max.y
        };
        if !b.iter().all(inside) {
            return false;
        }
        for robot in [0, 1] {
            let way = Segment::new(a[robot], b[robot]);
            let objects = self.scene.objects.iter();
            if objects
                .into_iter()
                .any(|o| way.distance(o.position) < radius + o.footprint_radius())
            {
                return false;
            }
        }
        // The least distance of the robots on the way.
        let relative = Segment::new(a[0] - a[1], b[0] - b[1]);
        if relative.distance(Point::ZERO) < 2.0 * radius {
            return false;
        }
        let Some(clearance) = &self.clearance else {
            return false;
        };
        let clear = |points: &[Point], keep: f64| {
            clearance
                .distance(&Hull::of(points))
                .is_none_or(|d| d >= keep)
        };
        clear(&[a[0], b[0]], radius)
            && clear(&[a[1], b[1]], radius)
            && clear(&[a[0], a[1], b[0], b[1]], 0.0)
    }

    /// From the pairs of a layer that are reached to those of the next, through free ones: Dijkstra.
    fn next(
        &self,
        reached: &[(f64, Vec<Pair>)],
        free: &[Pair],
        layer: &[Pair],
    ) -> Vec<(f64, Vec<Pair>)> {
        let first = reached.iter().map(|(_, way)| way[way.len() - 1]);
        let nodes: Vec<Pair> = first
            .chain(free.iter().copied())
            .chain(layer.iter().copied())
            .collect();
        let (sources, targets) = (reached.len(), reached.len() + free.len());
        let mut cost = vec![f64::INFINITY; nodes.len()];
        let mut before = vec![usize::MAX; nodes.len()];
        let mut open = BinaryHeap::new();
        for (i, (known, _)) in reached.iter().enumerate() {
            cost[i] = *known;
            open.push(Reverse((Ordered(*known), i)));
        }
        let mut closed = vec![false; nodes.len()];
        while let Some(Reverse((_, node))) = open.pop() {
            if closed[node] || node >= targets {
                closed[node] = true;
                continue;
            }
            closed[node] = true;
            for other in sources..nodes.len() {
                let way = [0, 1].map(|r| nodes[node][r].distance(nodes[other][r]));
                let new = cost[node] + way[0] + way[1];
                if closed[other] || new >= cost[other] || way[0].max(way[1]) > REACH {
                    continue;
                }
                if self.moves(&nodes[node], &nodes[other]) {
                    (cost[other], before[other]) = (new, node);
                    open.push(Reverse((Ordered(new), other)));
                }
            }
        }
        (targets..nodes.len())
            .filter(|&t| cost[t].is_finite())
            .map(|target| {
                let mut back = vec![nodes[target]];
                let mut node = before[target];
                while node != usize::MAX && node >= sources {
                    back.push(nodes[node]);
                    node = before[node];
                }
                let mut way = reached.get(node).map_or_else(Vec::new, |r| r.1.clone());
                way.extend(back.into_iter().rev());
                (cost[target], way)
            })
            .collect()
    }
}

/// A cost with a total order.
#[derive(Clone, Copy, PartialEq)]
struct Ordered(f64);

impl Eq for Ordered {}

impl PartialOrd for Ordered {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Ordered {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// A way of the pair as waypoints: at each corner both robots turn on the spot, then drive straight.
pub fn waypoints(scene: &Scene, way: &[Pair]) -> PairTrajectory {
    let planner = &scene.planner;
    let mut pair = [scene.start.left, scene.start.right];
    let mut found = PairTrajectory {
        left: vec![pair[0]],
        right: vec![pair[1]],
        step_time: default_step_time(&scene.robot, planner),
    };
    let mut go = |pair: &mut [Pose; 2], to: [Pose; 2], steps: usize| {
        let from = *pair;
        for k in 1..=steps {
            let part = k as f64 / steps as f64;
            found.left.push(from[0].lerp(to[0], part));
            found.right.push(from[1].lerp(to[1], part));
        }
        *pair = to;
    };
    let turned = |pose: Pose, heading: f64| {
        Pose::at(
            pose.position(),
            pose.heading + wrap_angle(heading - pose.heading),
        )
    };
    let turn_steps = |a: &[Pose; 2], b: &[Pose; 2]| {
        let most = [0, 1].map(|r| (b[r].heading - a[r].heading).abs());
        (most[0].max(most[1]) / planner.max_turn).ceil() as usize
    };
    for leg in way.windows(2) {
        let towards = [0, 1].map(|r| {
            let way = leg[1][r] - leg[0][r];
            if way.norm() > 1e-6 {
                turned(pair[r], way.angle())
            } else {
                pair[r]
            }
        });
        let steps = turn_steps(&pair, &towards);
        go(&mut pair, towards, steps);
        let there = [0, 1].map(|r| Pose::at(leg[1][r], pair[r].heading));
        let most = [0, 1].map(|r| leg[0][r].distance(leg[1][r]));
        let steps = (most[0].max(most[1]) / (planner.max_step - 1e-6)).ceil() as usize;
        go(&mut pair, there, steps);
    }
    let last = [
        turned(pair[0], scene.end.left.heading),
        turned(pair[1], scene.end.right.heading),
    ];
    let steps = turn_steps(&pair, &last);
    go(&mut pair, last, steps);
    found
}
