use crate::shape;
use pairtrawl_geometry::{Bounds, Point, Segment};
use pairtrawl_model::{Obstacle, PairTrajectory, Robot};
use std::collections::BTreeMap;

/// Edge length of a bucket, m.
const BUCKET: f64 = 0.5;

/// What the pair sweeps: both paths, the rungs between them, and the floor behind the start where the net lies;
/// in square buckets, so that long courses stay cheap.
pub(crate) struct Band<'a> {
    pub(crate) witness: &'a PairTrajectory,
    /// Driven by robots: clear of objects.
    paths: Buckets,
    /// All of it: clear of obstacles.
    all: Buckets,
    /// Waypoint indices by the bucket of the rung's midpoint.
    rungs: BTreeMap<(i64, i64), Vec<usize>>,
}

#[derive(Default)]
struct Buckets {
    segments: Vec<(Point, Point)>,
    cells: BTreeMap<(i64, i64), Vec<usize>>,
}

fn bucket(p: Point) -> (i64, i64) {
    ((p.x / BUCKET).floor() as i64, (p.y / BUCKET).floor() as i64)
}

impl Buckets {
    fn add(&mut self, a: Point, b: Point) {
        let index = self.segments.len();
        self.segments.push((a, b));
        let (lo, hi) = (
            bucket(Point::new(a.x.min(b.x), a.y.min(b.y))),
            bucket(Point::new(a.x.max(b.x), a.y.max(b.y))),
        );
        for cx in lo.0..=hi.0 {
            for cy in lo.1..=hi.1 {
                self.cells.entry((cx, cy)).or_default().push(index);
            }
        }
    }

    /// Least of `distance` over the segments within `reach` of a bounding box, at most `reach`.
    fn nearest(
        &self,
        lo: Point,
        hi: Point,
        reach: f64,
        distance: impl Fn(Point, Point) -> f64,
    ) -> f64 {
        let margin = Point::new(reach, reach);
        let (from, to) = (bucket(lo - margin), bucket(hi + margin));
        let mut least = reach;
        for cx in from.0..=to.0 {
            for (_, list) in self.cells.range((cx, from.1)..=(cx, to.1)) {
                for &i in list {
                    let (a, b) = self.segments[i];
                    least = least.min(distance(a, b));
                }
            }
        }
        least
    }
}

impl<'a> Band<'a> {
    pub(crate) fn new(witness: &'a PairTrajectory, robot: &Robot, net_length: f64) -> Self {
        let (mut paths, mut all) = (Buckets::default(), Buckets::default());
        let mut rungs: BTreeMap<(i64, i64), Vec<usize>> = BTreeMap::new();
        for i in 0..witness.len() {
            let pair = witness.pair(i);
            all.add(pair.left.position(), pair.right.position());
            rungs.entry(bucket(pair.midpoint())).or_default().push(i);
            if i + 1 < witness.len() {
                let next = witness.pair(i + 1);
                for (a, b) in [(pair.left, next.left), (pair.right, next.right)] {
                    paths.add(a.position(), b.position());
                    all.add(a.position(), b.position());
                }
            }
        }
        let start = witness.pair(0);
        let behind = robot.hitch + 0.5 * net_length;
        for share in [0.0, 0.25, 0.5, 0.75, 1.0] {
            let (l, r) = (
                start.left.hitch_point(behind),
                start.right.hitch_point(behind),
            );
            all.add(
                start.left.position().lerp(start.right.position(), share),
                l.lerp(r, share),
            );
        }
        Self {
            witness,
            paths,
            all,
            rungs,
        }
    }

    /// Length of the midpoint's path, m.
    pub(crate) fn length(&self) -> f64 {
        let w = self.witness;
        (1..w.len())
            .map(|i| w.pair(i - 1).midpoint().distance(w.pair(i).midpoint()))
            .sum()
    }

    /// Distance from an obstacle to everything that the pair sweeps, at most `reach`.
    pub(crate) fn obstacle_distance(&self, obstacle: &Obstacle, reach: f64) -> f64 {
        let Bounds { min, max } = shape::bounds(obstacle);
        self.all.nearest(min, max, reach, |a, b| {
            shape::segment_obstacle(a, b, obstacle)
        })
    }

    /// Distance from a point to both robots' paths, at most `reach`.
    pub(crate) fn path_distance(&self, p: Point, reach: f64) -> f64 {
        self.paths
            .nearest(p, p, reach, |a, b| Segment::new(a, b).distance(p))
    }

    /// True when the point lies strictly inside the quadrilateral of some step.
    pub(crate) fn covers(&self, p: Point) -> bool {
        let (cx, cy) = bucket(p);
        let w = self.witness;
        (cx - 2..=cx + 2).any(|x| {
            self.rungs
                .range((x, cy - 2)..=(x, cy + 2))
                .any(|(_, list)| {
                    list.iter().any(|&i| {
                        i + 1 < w.len() && {
                            let (a, b) = (w.pair(i), w.pair(i + 1));
                            // Counter-clockwise: right, right next, left next, left.
                            let quad = [a.right, b.right, b.left, a.left].map(|q| q.position());
                            (0..4).all(|k| (quad[(k + 1) % 4] - quad[k]).cross(p - quad[k]) >= 0.0)
                        }
                    })
                })
        })
    }
}
