//! What route planning knows of the scene: distances on a grid of its own, the pair's measures, the objects.

use pairtrawl_geometry::Point;
use pairtrawl_model::Scene;
use pairtrawl_world::{Lattice, OPEN_NET_LENGTH, World};

/// Finest spacing of the distance samples.
const PITCH: f64 = 0.05;
/// Most samples that a terrain holds; larger areas are sampled more coarsely.
const MAX_SAMPLES: f64 = 4e6;
/// Finest spacing of the buckets that objects are looked up in, and most buckets.
const BUCKET: f64 = 1.0;
const MAX_BUCKETS: f64 = 1e6;
/// How much beyond its bounds the separation of a baseline stays, each robot.
const SPARE: f64 = 0.005;
/// Comfortable turning radius over that of a robot that turns and drives as much as it may in every step.
const COMFORT: f64 = 1.2;

/// The measures of the pair that decide where it fits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairMeasures {
    /// Radius of a robot, of one with a body half its width: the room that it takes while it drives. The optimizer and the
    /// certificate know the body itself.
    pub radius: f64,
    /// Margin wanted beyond the radius.
    pub clearance: f64,
    /// l of eq. 1.
    pub half_separation: f64,
    /// Half of the least separation.
    pub min_half: f64,
    /// Half of the greatest separation that a baseline uses.
    pub max_half: f64,
    /// Turning radius of the midpoint at which neither robot need slow down or all but turn on the spot.
    pub turning: f64,
}

impl PairMeasures {
    pub fn of(scene: &Scene) -> Self {
        let net = scene.net.length.unwrap_or(OPEN_NET_LENGTH);
        let radius = scene.robot.circles().half_width();
        let min_half = radius.max(0.5 * scene.planner.min_ratio * net) + SPARE;
        let max_half = (0.475 * net).max(min_half);
        let half_separation = scene.planner.half_separation.clamp(min_half, max_half);
        let sharpest = scene.planner.max_step / scene.planner.max_turn;
        Self {
            radius,
            clearance: scene.planner.clearance,
            half_separation,
            min_half,
            max_half,
            turning: (COMFORT * sharpest).max(2.0 * half_separation),
        }
    }
}

/// An object's footprint circle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Disc {
    pub center: Point,
    pub radius: f64,
}

/// Bilinear samples of the distance that a robot center has, with the area's border as a soft wall:
/// the value is `radius + clearance` on the border, so a center that keeps its margin stays inside.
#[derive(Clone, Debug)]
pub(crate) struct Terrain {
    pub min: Point,
    pub max: Point,
    pub pair: PairMeasures,
    pub objects: Vec<Disc>,
    pitch: f64,
    columns: usize,
    rows: usize,
    distance: Vec<f64>,
    bucket: f64,
    bucket_columns: usize,
    bucket_rows: usize,
    buckets: Vec<Vec<u32>>,
    /// For every object those behind it in the list that no robot passes between it and.
    ties: Vec<Vec<u32>>,
}

/// Width and height of the area, neither of them zero.
fn size(scene: &Scene) -> (f64, f64) {
    let (min, max) = (scene.area.min, scene.area.max);
    ((max.x - min.x).max(PITCH), (max.y - min.y).max(PITCH))
}

/// Where distances are sampled.
fn lattice(scene: &Scene) -> Lattice {
    let (width, height) = size(scene);
    let pitch = PITCH.max((width * height / MAX_SAMPLES).sqrt());
    Lattice {
        min: scene.area.min,
        pitch,
        columns: (width / pitch).ceil() as usize + 1,
        rows: (height / pitch).ceil() as usize + 1,
    }
}

impl Terrain {
    /// Objects that are left are obstacles: there may be no room for a robot behind them. So are closed places.
    pub fn new(world: &World, scene: &Scene) -> Self {
        let left = (scene.objects.iter())
            .filter(|object| object.leave)
            .map(|object| Disc {
                center: object.position,
                radius: object.footprint_radius(),
            });
        let closed = world.closed.iter().map(|place| Disc {
            center: place.center,
            radius: place.radius,
        });
        let discs: Vec<Disc> = left.chain(closed).collect();
        let lattice = lattice(scene);
        let distances = world.distances_on(&lattice);
        let off_discs = |(p, &distance): (Point, &f64)| {
            let off_discs = discs
                .iter()
                .map(|disc| p.distance(disc.center) - disc.radius);
            off_discs.fold(distance, f64::min)
        };
        Self::over(scene, lattice.points().zip(distances.iter()).map(off_discs))
    }

    /// Samples a signed distance (negative inside obstacles) over the scene's area.
    #[cfg(test)]
    pub fn sample(scene: &Scene, field: impl Fn(Point) -> f64) -> Self {
        Self::over(scene, lattice(scene).points().map(field))
    }

    /// From signed distances at the points of the scene's lattice.
    fn over(scene: &Scene, distances: impl Iterator<Item = f64>) -> Self {
        let (min, max) = (scene.area.min, scene.area.max);
        let pair = PairMeasures::of(scene);
        let lattice = lattice(scene);
        let softened = |(p, distance): (Point, f64)| {
            let inside = (p.x - min.x)
                .min(max.x - p.x)
                .min(p.y - min.y)
                .min(max.y - p.y);
            distance.min(inside + pair.radius + pair.clearance)
        };
        let distance = lattice.points().zip(distances).map(softened).collect();
        let (width, height) = size(scene);
        let objects: Vec<Disc> = scene
            .objects
            .iter()
            .map(|o| Disc {
                center: o.position,
                radius: o.footprint_radius(),
            })
            .collect();
        // Within a bucket's edge of a point lies every object that a robot of a pair around it could touch.
        let largest = objects.iter().map(|o| o.radius).fold(0.0, f64::max);
        let touching = largest + pair.half_separation + pair.radius + 2.0 * pair.clearance;
        let tied = 2.0 * (largest + pair.radius);
        let bucket = touching
            .max(tied)
            .max(BUCKET)
            .max((width * height / MAX_BUCKETS).sqrt());
        let bucket_columns = (width / bucket) as usize + 1;
        let bucket_rows = (height / bucket) as usize + 1;
        let mut terrain = Self {
            min,
            max,
            pair,
            objects,
            pitch: lattice.pitch,
            columns: lattice.columns,
            rows: lattice.rows,
            distance,
            bucket,
            bucket_columns,
            bucket_rows,
            buckets: vec![Vec::new(); bucket_columns * bucket_rows],
            ties: Vec::new(),
        };
        for (i, object) in terrain.objects.iter().enumerate() {
            let (column, row) = terrain.bucket(object.center);
            // Listed in the neighbors too: a lookup then reads one bucket and finds all within its edge.
            for r in row.saturating_sub(1)..=(row + 1).min(bucket_rows - 1) {
                for c in column.saturating_sub(1)..=(column + 1).min(bucket_columns - 1) {
                    terrain.buckets[r * bucket_columns + c].push(i as u32);
                }
            }
        }
        terrain.ties = (0..terrain.objects.len())
            .map(|i| terrain.tied_to(i))
            .collect();
        terrain
    }

    /// Objects behind object i in the list between which and it there is no room for a robot.
    fn tied_to(&self, i: usize) -> Vec<u32> {
        let object = self.objects[i];
        let leaves_no_room = |j: &u32| {
            let other = self.objects[*j as usize];
            let room = object.center.distance(other.center) - object.radius - other.radius;
            *j as usize > i && room < 2.0 * self.pair.radius
        };
        let near = self.near(object.center).iter().copied();
        near.filter(leaves_no_room).collect()
    }

    fn bucket(&self, p: Point) -> (usize, usize) {
        let index = |v: f64, n: usize| ((v / self.bucket).max(0.0) as usize).min(n - 1);
        (
            index(p.x - self.min.x, self.bucket_columns),
            index(p.y - self.min.y, self.bucket_rows),
        )
    }

    /// Objects near a point: all that a pair around it could touch, perhaps some more.
    pub fn objects_near(&self, p: Point) -> impl Iterator<Item = &Disc> {
        self.near(p).iter().map(|&i| &self.objects[i as usize])
    }

    /// Pairs of objects near a point that leave no room for a robot between them.
    pub fn ties_near(&self, p: Point) -> impl Iterator<Item = [Disc; 2]> {
        self.near(p).iter().flat_map(move |&i| {
            let tied = self.ties[i as usize].iter();
            tied.map(move |&j| [self.objects[i as usize], self.objects[j as usize]])
        })
    }

    fn near(&self, p: Point) -> &[u32] {
        let (column, row) = self.bucket(p);
        &self.buckets[row * self.bucket_columns + column]
    }

    /// Distance of a robot center to the nearest obstacle or the softened border.
    pub fn distance(&self, p: Point) -> f64 {
        self.interpolate(p).0
    }

    /// Distance and its gradient.
    pub fn distance_and_gradient(&self, p: Point) -> (f64, Point) {
        self.interpolate(p)
    }

    fn interpolate(&self, p: Point) -> (f64, Point) {
        let gx = (p.x - self.min.x) / self.pitch;
        let gy = (p.y - self.min.y) / self.pitch;
        let x = gx.clamp(0.0, (self.columns - 1) as f64);
        let y = gy.clamp(0.0, (self.rows - 1) as f64);
        // Beyond the samples the distance falls by the way back to them.
        let out = Point::new(gx - x, gy - y) * self.pitch;
        let column = (x as usize).min(self.columns - 2);
        let row = (y as usize).min(self.rows - 2);
        let (fx, fy) = (x - column as f64, y - row as f64);
        let i = row * self.columns + column;
        let [a, b] = [self.distance[i], self.distance[i + 1]];
        let [c, d] = [
            self.distance[i + self.columns],
            self.distance[i + self.columns + 1],
        ];
        let low = a + (b - a) * fx;
        let high = c + (d - c) * fx;
        let gradient = Point::new(
            ((b - a) * (1.0 - fy) + (d - c) * fy) / self.pitch,
            (high - low) / self.pitch,
        );
        let value = low + (high - low) * fy;
        let far = out.norm();
        if far > 0.0 {
            (value - far, out * (-1.0 / far))
        } else {
            (value, gradient)
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use pairtrawl_geometry::Pose;
    use pairtrawl_model::{
        Area, Footprint, NetSpec, Object, PairPose, PhysicsParameters, PlannerParameters, Robot,
    };

    /// A pair pose around a midpoint, 0.6 m apart.
    pub fn pair_pose(x: f64, y: f64, heading: f64) -> PairPose {
        let normal = Point::unit(heading).perp() * 0.3;
        let middle = Point::new(x, y);
        PairPose {
            left: Pose::at(middle + normal, heading),
            right: Pose::at(middle - normal, heading),
        }
    }

    /// An empty scene with objects of radius 0.035 m.
    pub fn scene(
        width: f64,
        height: f64,
        objects: &[[f64; 2]],
        start: PairPose,
        end: PairPose,
    ) -> Scene {
        Scene {
            name: "test".into(),
            area: Area {
                min: Point::ZERO,
                max: Point::new(width, height),
                resolution: 0.05,
            },
            obstacles: Vec::new(),
            map: None,
            objects: objects
                .iter()
                .map(|&p| Object {
                    position: p.into(),
                    footprint: Footprint::Disc(0.035),
                    mass: 0.025,
                    leave: false,
                })
                .collect(),
            start,
            end,
            robot: Robot::default(),
            net: NetSpec {
                length: Some(1.5),
                start: None,
            },
            planner: PlannerParameters::default(),
            physics: PhysicsParameters::default(),
        }
    }

    /// Signed distance to an axis-parallel box.
    pub fn box_distance(p: Point, [x0, y0, x1, y1]: [f64; 4]) -> f64 {
        let dx = (x0 - p.x).max(p.x - x1);
        let dy = (y0 - p.y).max(p.y - y1);
        if dx > 0.0 && dy > 0.0 {
            Point::new(dx, dy).norm()
        } else {
            dx.max(dy)
        }
    }

    #[test]
    fn samples_follow_the_field_and_the_border() {
        let s = scene(
            4.0,
            3.0,
            &[[1.0, 1.0]],
            pair_pose(1.0, 1.0, 0.0),
            pair_pose(3.0, 1.0, 0.0),
        );
        let t = Terrain::sample(&s, |p| p.distance(Point::new(2.0, 1.5)) - 0.5);
        let p = Point::new(3.01, 1.52);
        let (d, g) = t.distance_and_gradient(p);
        assert!((d - (p.distance(Point::new(2.0, 1.5)) - 0.5)).abs() < 2e-3);
        assert!((g.x - 1.0).abs() < 2e-2 && g.y.abs() < 0.05);
        // On the border a robot just keeps its margin; beyond it the value goes on falling.
        assert!((t.distance(Point::new(0.0, 0.0)) - 0.29).abs() < 1e-9);
        assert!((t.distance(Point::new(-0.3, 0.0)) + 0.01).abs() < 1e-9);
        assert_eq!(t.objects_near(Point::new(1.9, 1.9)).count(), 1);
        assert_eq!(t.objects_near(Point::new(3.9, 2.9)).count(), 0);
    }
}
