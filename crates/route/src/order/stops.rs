use crate::error::RouteError;
use crate::geodesic::{CostGrid, Geodesic};
use crate::terrain::Terrain;
use pairtrawl_geometry::Point;
use pairtrawl_model::Scene;
use std::f64::consts::{PI, TAU};

/// Up to this many stops every distance is marched for; beyond, only those to near stops.
const FULL_LIMIT: usize = 40;
/// Near stops that distances are marched for, beyond [`FULL_LIMIT`].
const NEAR: usize = 14;

/// Where a path is: before its start, at a stop, behind its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Place {
    Outside,
    Stop(usize),
}

/// All stops with the distances and directions between them. Indices 0..n are circles, n is the start, n + 1 the end.
pub(crate) struct Stops {
    points: Vec<Point>,
    start_heading: f64,
    end_heading: f64,
    length: Vec<f64>,
    /// Radius with which a reversal is priced.
    turning: f64,
    /// `leave[i * m + j]`: angle in which the way from i to j leaves i, rad.
    leave: Vec<f32>,
}

impl Stops {
    pub fn new(
        terrain: &Terrain,
        mut points: Vec<Point>,
        scene: &Scene,
    ) -> Result<Self, RouteError> {
        let grid = &CostGrid::new(terrain);
        let n = points.len();
        points.push(scene.start.midpoint());
        points.push(scene.end.midpoint());
        let m = n + 2;
        let mut stops = Self {
            start_heading: scene.start.normal_heading(),
            end_heading: scene.end.normal_heading(),
            turning: terrain.pair.turning,
            length: vec![f64::INFINITY; m * m],
            leave: vec![f32::NAN; m * m],
            points,
        };
        let mut march = Geodesic::new(grid);
        for j in 0..m {
            stops.march_from(&mut march, j, if m <= FULL_LIMIT { m } else { NEAR });
        }
        if m > FULL_LIMIT {
            stops.connect(&mut march)?;
            stops.complete();
        }
        // Ways that nobody marched for leave straight.
        for i in 0..m * m {
            if stops.leave[i].is_nan() {
                stops.leave[i] = (stops.points[i % m] - stops.points[i / m]).angle() as f32;
            }
        }
        for j in 0..m {
            if !stops.length[n * m + j].is_finite() {
                return Err(RouteError::NoPath {
                    from: stops.points[n],
                    to: stops.points[j],
                });
            }
        }
        Ok(stops)
    }

    /// Number of circles.
    pub fn count(&self) -> usize {
        self.points.len() - 2
    }

    fn all(&self) -> usize {
        self.points.len()
    }

    /// Distances between stop `j` and the `near` ones that the front reaches first.
    fn march_from(&mut self, march: &mut Geodesic, j: usize, near: usize) {
        let m = self.all();
        let source = self.points[j];
        // A front that has passed a stop by a few cells has settled the values around it.
        let mut wanted: Vec<f64> = self.points.iter().map(|p| p.distance(source)).collect();
        wanted.sort_by(f64::total_cmp);
        let everything = near >= m;
        let enough = wanted[near.min(m - 1)];
        let limit = if everything {
            f64::INFINITY
        } else {
            1.5 * enough + 2.0
        };
        march.march(source, |_, t| t > limit);
        for i in 0..m {
            if i == j {
                self.length[i * m + j] = 0.0;
                continue;
            }
            if self.points[i].distance(source) > limit + 1.0 {
                continue;
            }
            let t = march.at_stop(self.points[i]);
            if t.is_finite() {
                let symmetric = if self.length[j * m + i].is_finite() {
                    0.5 * (t + self.length[j * m + i])
                } else {
                    t
                };
                self.length[i * m + j] = symmetric;
                self.length[j * m + i] = symmetric;
                self.leave[i * m + j] = (-march.arrival(self.points[i])).angle() as f32;
            }
        }
    }

    /// Links parts of the graph that no near distance joins, by fronts that run until they meet another part.
    fn connect(&mut self, march: &mut Geodesic) -> Result<(), RouteError> {
        let m = self.all();
        loop {
            let part = self.parts();
            let Some(outside) = (0..m).find(|&i| part[i] != part[m - 2]) else {
                return Ok(());
            };
            self.march_from(march, outside, m);
            if (0..m).all(|i| part[i] == part[outside] || !self.length[outside * m + i].is_finite())
            {
                return Err(RouteError::NoPath {
                    from: self.points[m - 2],
                    to: self.points[outside],
                });
            }
        }
    }

    /// The connected part that each stop belongs to.
    fn parts(&self) -> Vec<usize> {
        let m = self.all();
        let mut part = vec![usize::MAX; m];
        for seed in 0..m {
            if part[seed] != usize::MAX {
                continue;
            }
            let mut stack = vec![seed];
            while let Some(i) = stack.pop() {
                if part[i] != usize::MAX {
                    continue;
                }
                part[i] = seed;
                stack.extend(
                    (0..m).filter(|&j| part[j] == usize::MAX && self.length[i * m + j].is_finite()),
                );
            }
        }
        part
    }

    /// Distances between far stops: along chains of near ones (Dijkstra on the sparse graph).
    fn complete(&mut self) {
        let m = self.all();
        let near: Vec<Vec<(usize, f64)>> = (0..m)
            .map(|i| {
                (0..m)
                    .filter(|&j| j != i)
                    .map(|j| (j, self.length[i * m + j]))
                    .filter(|e| e.1.is_finite())
                    .collect()
            })
            .collect();
        for source in 0..m {
            let mut time = vec![f64::INFINITY; m];
            let mut heap = std::collections::BinaryHeap::new();
            time[source] = 0.0;
            heap.push((std::cmp::Reverse(0u64), source));
            while let Some((std::cmp::Reverse(bits), i)) = heap.pop() {
                let t = f64::from_bits(bits);
                if t > time[i] {
                    continue;
                }
                for &(j, d) in &near[i] {
                    if t + d < time[j] {
                        time[j] = t + d;
                        heap.push((std::cmp::Reverse((t + d).to_bits()), j));
                    }
                }
            }
            for (j, t) in time.into_iter().enumerate() {
                if !self.length[source * m + j].is_finite() {
                    self.length[source * m + j] = t;
                }
            }
        }
        // Sums run in different orders: keep the matrix exactly symmetric.
        for i in 0..m {
            for j in 0..i {
                self.length[i * m + j] = self.length[j * m + i];
            }
        }
    }

    /// Length of the way between two stops, of open floor.
    pub fn length(&self, i: usize, j: usize) -> f64 {
        self.length[i * self.all() + j]
    }

    /// Angle in which the way from i to j leaves i.
    fn leave(&self, i: usize, j: usize) -> f64 {
        f64::from(self.leave[i * self.all() + j])
    }

    /// Price of turning at `b` on the way from `a` to `c`, a length. `Outside` is only ever beside the start or the end.
    pub fn turn(&self, a: Place, b: usize, c: Place) -> f64 {
        let arrive = match a {
            Place::Stop(a) => self.leave(b, a) + PI,
            Place::Outside => self.start_heading,
        };
        let leave = match c {
            Place::Stop(c) => self.leave(b, c),
            Place::Outside => self.end_heading,
        };
        let alpha = (leave - arrive - TAU * ((leave - arrive) / TAU).round()).abs();
        self.turning * alpha * alpha * alpha / (PI * PI)
    }

    /// Cost of a whole order of circles.
    pub fn cost(&self, order: &[usize]) -> f64 {
        let n = self.count();
        let mut path = vec![n];
        path.extend_from_slice(order);
        path.push(n + 1);
        let place = |k: Option<usize>| {
            k.and_then(|k| path.get(k))
                .map_or(Place::Outside, |&s| Place::Stop(s))
        };
        let lengths: f64 = path.windows(2).map(|w| self.length(w[0], w[1])).sum();
        let turns = (0..path.len())
            .map(|k| self.turn(place(k.checked_sub(1)), path[k], place(Some(k + 1))));
        lengths + turns.sum::<f64>()
    }
}
