//! Obstacle-aware distances by fast marching: |grad T| = cost(p), solved on a coarse grid in order of T.
//!
//! The cost is 1 where the pair keeps its margins abreast and grows where it has to squeeze, so T is a length of
//! open floor. Reference: Sethian, "A fast marching level set method" (1996).

use crate::terrain::Terrain;
use pairtrawl_geometry::Point;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Finest spacing of the nodes: a gap of 2 robot radii + 0.2 still has a node in its middle.
const PITCH: f64 = 0.2;
/// Most nodes of a grid.
const MAX_NODES: f64 = 1e6;
/// Share of the robot radius that the midpoint must keep: below it not even a staggered pair passes.
const FLOOR: f64 = 0.8;
/// Growth of the cost per length of missing room for the pair.
const SQUEEZE: f64 = 3.0;

/// The cost of every node.
pub(crate) struct CostGrid {
    min: Point,
    pitch: f64,
    columns: usize,
    rows: usize,
    cost: Vec<f64>,
}

/// Distances from one source; infinite where the pair cannot go or the march was stopped before.
pub(crate) struct Geodesic<'g> {
    grid: &'g CostGrid,
    source: Point,
    time: Vec<f64>,
    settled: Vec<bool>,
    touched: Vec<usize>,
}

impl CostGrid {
    pub fn new(terrain: &Terrain) -> Self {
        let size = terrain.max - terrain.min;
        let pitch = PITCH.max((size.x * size.y / MAX_NODES).sqrt());
        let columns = (size.x / pitch).ceil().max(1.0) as usize + 1;
        let rows = (size.y / pitch).ceil().max(1.0) as usize + 1;
        // Where the nodes are coarse, a gap between them may be wider than it is at the nearest: better too many ways than
        // too few, since the search along them looks closely.
        let floor = FLOOR * terrain.pair.radius - (pitch - PITCH) * std::f64::consts::FRAC_1_SQRT_2;
        let wanted = terrain.pair.half_separation + terrain.pair.radius + terrain.pair.clearance;
        let mut cost = Vec::with_capacity(columns * rows);
        for row in 0..rows {
            for column in 0..columns {
                let d =
                    terrain.distance(terrain.min + Point::new(column as f64, row as f64) * pitch);
                cost.push(if d < floor {
                    f64::INFINITY
                } else {
                    1.0 + SQUEEZE * (wanted - d).max(0.0)
                });
            }
        }
        Self {
            min: terrain.min,
            pitch,
            columns,
            rows,
            cost,
        }
    }

    fn node(&self, i: usize) -> Point {
        self.min + Point::new((i % self.columns) as f64, (i / self.columns) as f64) * self.pitch
    }

    /// The four nodes around a point with their bilinear weights.
    fn corners(&self, p: Point) -> [(usize, f64); 4] {
        let x = ((p.x - self.min.x) / self.pitch).clamp(0.0, (self.columns - 1) as f64);
        let y = ((p.y - self.min.y) / self.pitch).clamp(0.0, (self.rows - 1) as f64);
        let column = (x as usize).min(self.columns - 2);
        let row = (y as usize).min(self.rows - 2);
        let (fx, fy) = (x - column as f64, y - row as f64);
        let i = row * self.columns + column;
        [
            (i, (1.0 - fx) * (1.0 - fy)),
            (i + 1, fx * (1.0 - fy)),
            (i + self.columns, (1.0 - fx) * fy),
            (i + self.columns + 1, fx * fy),
        ]
    }

    /// Free nodes near a source with their distances. Straight lines there avoid the error of fast marching where the
    /// front is strongly curved. A source that stands too close to an obstacle starts at the nearest free node.
    fn around(&self, source: Point) -> Vec<(usize, f64)> {
        let line = |i: usize| (i, self.node(i).distance(source) * self.cost[i]);
        let near = self.nodes_within(source, 2.0 * self.pitch);
        let free: Vec<_> = near
            .into_iter()
            .map(line)
            .filter(|n| n.1.is_finite())
            .collect();
        let stands_free = self
            .corners(source)
            .iter()
            .all(|&(i, _)| self.cost[i].is_finite());
        if stands_free {
            return free;
        }
        let wide = self.nodes_within(source, 4.0 * self.pitch);
        let all = wide.into_iter().map(line).filter(|n| n.1.is_finite());
        all.min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)))
            .into_iter()
            .collect()
    }

    /// Nodes within `radius` of a point, in index order.
    fn nodes_within(&self, p: Point, radius: f64) -> Vec<usize> {
        let low = (p - self.min - Point::new(radius, radius)) / self.pitch;
        let high = (p - self.min + Point::new(radius, radius)) / self.pitch;
        let clamp = |v: f64, n: usize| (v.max(0.0) as usize).min(n - 1);
        let mut nodes = Vec::new();
        for row in clamp(low.y.ceil(), self.rows)..=clamp(high.y, self.rows) {
            for column in clamp(low.x.ceil(), self.columns)..=clamp(high.x, self.columns) {
                let i = row * self.columns + column;
                if self.node(i).distance(p) <= radius {
                    nodes.push(i);
                }
            }
        }
        nodes
    }
}

impl<'g> Geodesic<'g> {
    /// Distances from nowhere yet; one value can march again and again without a new allocation.
    pub fn new(grid: &'g CostGrid) -> Self {
        Self {
            grid,
            source: grid.min,
            time: vec![f64::INFINITY; grid.cost.len()],
            settled: vec![false; grid.cost.len()],
            touched: Vec::new(),
        }
    }

    /// Marches from `source` until `stop(node position, T)` says so, or everywhere.
    pub fn march(&mut self, source: Point, mut stop: impl FnMut(Point, f64) -> bool) {
        let grid = self.grid;
        self.source = source;
        for i in self.touched.drain(..) {
            self.time[i] = f64::INFINITY;
            self.settled[i] = false;
        }
        let mut heap = BinaryHeap::new();
        for (i, t) in grid.around(source) {
            self.time[i] = t;
            self.touched.push(i);
            heap.push((Reverse(t.to_bits()), i));
        }
        let (columns, rows) = (grid.columns, grid.rows);
        while let Some((Reverse(bits), i)) = heap.pop() {
            let t = f64::from_bits(bits);
            if self.settled[i] || t > self.time[i] {
                continue;
            }
            self.settled[i] = true;
            if stop(grid.node(i), t) {
                break;
            }
            let (column, row) = (i % columns, i / columns);
            let neighbors = [
                (column > 0).then(|| i - 1),
                (column + 1 < columns).then(|| i + 1),
                (row > 0).then(|| i - columns),
                (row + 1 < rows).then(|| i + columns),
            ];
            for j in neighbors.into_iter().flatten() {
                if self.settled[j] || !grid.cost[j].is_finite() {
                    continue;
                }
                let new = grid.update(&self.time, j);
                if new < self.time[j] {
                    if self.time[j].is_infinite() {
                        self.touched.push(j);
                    }
                    self.time[j] = new;
                    heap.push((Reverse(new.to_bits()), j));
                }
            }
        }
        // Values that the front has not settled may still be too large.
        for &i in &self.touched {
            if !self.settled[i] {
                self.time[i] = f64::INFINITY;
            }
        }
    }

    /// T at a point; infinite when none of the nodes around it was reached.
    pub fn at(&self, p: Point) -> f64 {
        let direct = p.distance(self.source);
        if direct < 1.5 * self.grid.pitch {
            return direct;
        }
        let mut sum = 0.0;
        let mut weight = 0.0;
        let mut nearest = f64::INFINITY;
        for (i, w) in self.grid.corners(p) {
            let t = self.time[i];
            if t.is_finite() {
                sum += w * t;
                weight += w;
                nearest = nearest.min(t + self.grid.node(i).distance(p));
            }
        }
        if weight > 0.999 {
            sum / weight
        } else {
            nearest
        }
    }

    /// T at a stop that may stand so close to an obstacle that no node around it is free.
    pub fn at_stop(&self, p: Point) -> f64 {
        let t = self.at(p);
        if t.is_finite() {
            return t;
        }
        let nodes = self.grid.nodes_within(p, 4.0 * self.grid.pitch);
        nodes
            .into_iter()
            .map(|i| self.time[i] + self.grid.node(i).distance(p))
            .fold(f64::INFINITY, f64::min)
    }

    /// Unit vector in which the shortest way from the source arrives at `p`; straight when T is not known around.
    pub fn arrival(&self, p: Point) -> Point {
        let reach = 1.5 * self.grid.pitch;
        let d = |v: Point| (self.at(p + v) - self.at(p - v)) / (2.0 * reach);
        let g = Point::new(d(Point::new(reach, 0.0)), d(Point::new(0.0, reach)));
        let straight = p - self.source;
        let v = if g.is_finite() && g.norm() > 0.2 && straight.norm() > 2.0 * reach {
            g
        } else {
            straight
        };
        if v.norm() > 1e-9 {
            v / v.norm()
        } else {
            Point::new(1.0, 0.0)
        }
    }
}

impl CostGrid {
    /// The upwind quadratic: (T - a)^2 + (T - b)^2 = (pitch cost)^2.
    fn update(&self, time: &[f64], j: usize) -> f64 {
        let (column, row) = (j % self.columns, j / self.columns);
        let mut a = f64::INFINITY;
        if column > 0 {
            a = a.min(time[j - 1]);
        }
        if column + 1 < self.columns {
            a = a.min(time[j + 1]);
        }
        let mut b = f64::INFINITY;
        if row > 0 {
            b = b.min(time[j - self.columns]);
        }
        if row + 1 < self.rows {
            b = b.min(time[j + self.columns]);
        }
        let step = self.pitch * self.cost[j];
        let gap = a - b;
        if gap.is_finite() && gap.abs() < step {
            0.5 * (a + b + (2.0 * step * step - gap * gap).sqrt())
        } else {
            a.min(b) + step
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::terrain::tests::{box_distance, pair_pose, scene};

    #[test]
    fn distances_are_straight_in_the_open_and_lead_around_walls() {
        let s = scene(
            10.0,
            8.0,
            &[],
            pair_pose(1.0, 1.0, 0.0),
            pair_pose(9.0, 1.0, 0.0),
        );
        let wall = [4.5, -1.0, 5.5, 5.0];
        let terrain = Terrain::sample(&s, |p| box_distance(p, wall));
        let grid = CostGrid::new(&terrain);
        let mut g = Geodesic::new(&grid);
        g.march(Point::new(2.0, 2.0), |_, _| false);
        let open = g.at(Point::new(3.0, 6.0));
        assert!((open / 17f64.sqrt() - 1.0).abs() < 0.03, "{open}");
        // Around the wall's end, somewhat longer than the tight string because of the pair's width.
        let string = Point::new(2.0, 2.0).distance(Point::new(4.5, 5.0))
            + 1.0
            + Point::new(5.5, 5.0).distance(Point::new(8.0, 2.0));
        let around = g.at(Point::new(8.0, 2.0));
        assert!(
            around > string && around < string + 2.0,
            "{around} {string}"
        );
        let arrival = g.arrival(Point::new(8.0, 2.0));
        assert!(arrival.x > 0.2 && arrival.y < -0.6, "{arrival:?}");
        assert!(g.at(Point::new(5.0, 2.0)).is_infinite());
    }
}
