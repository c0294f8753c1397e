use crate::bounding_circle::minimum_bounding_circle;
use pairtrawl_geometry::Point;
use pairtrawl_model::{Circle, Footprint, Object, Scene};
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::TAU;

/// d_max that merging assumes while the net length is open.
pub const OPEN_NET_LENGTH: f64 = 2.0;

/// Sides of the polygon that stands for a disc in the bounding circle of several objects. It contains the disc, and is
/// wider by at most 0.13 %.
const DISC_SIDES: usize = 64;

/// One circle per object that is to be gathered: the minimum bounding circle of its footprint, enlarged by gamma.
pub(crate) fn object_circles(scene: &Scene) -> Vec<Circle> {
    let gamma = margin(scene);
    (scene.objects.iter().enumerate())
        .filter(|(_, object)| !object.leave)
        .map(|(i, o)| Circle {
            center: o.position,
            radius: o.footprint_radius() + gamma,
            objects: vec![i],
        })
        .collect()
}

/// gamma: the planner's `circle_margin`, or the robot radius, of a body half its width.
fn margin(scene: &Scene) -> f64 {
    let half_width = || scene.robot.circles().half_width();
    scene.planner.circle_margin.unwrap_or_else(half_width)
}

/// Circles of close objects merged into their bounding circle (enlarged by gamma): the two with the nearest centers first,
/// while centers are closer than 2 gamma and the merged diameter is at most min(d_rest, 0.8 d_max). Sorted by their first object.
pub(crate) fn merged_circles(scene: &Scene, net_length: Option<f64>) -> Vec<Circle> {
    let gamma = margin(scene);
    let d_max = net_length.unwrap_or(OPEN_NET_LENGTH);
    let greatest_diameter = d_max * scene.planner.rest_ratio.min(0.8);

    // Clusters are never changed: a merged one is appended and its two parts are emptied.
    let mut clusters: Vec<Option<Circle>> = object_circles(scene).into_iter().map(Some).collect();
    let mut queue = BinaryHeap::new();
    for i in 0..clusters.len() {
        enqueue(&mut queue, &clusters, i, 2.0 * gamma);
    }
    while let Some(Reverse(Candidate { i, j, .. })) = queue.pop() {
        let (Some(a), Some(b)) = (&clusters[i], &clusters[j]) else {
            continue;
        };
        let mut objects = [a.objects.as_slice(), b.objects.as_slice()].concat();
        objects.sort_unstable();
        let outline: Vec<Point> = objects
            .iter()
            .flat_map(|&k| outline(&scene.objects[k]))
            .collect();
        let (center, radius) = minimum_bounding_circle(&outline);
        let merged = Circle {
            center,
            radius: radius + gamma,
            objects,
        };
        if 2.0 * merged.radius <= greatest_diameter {
            clusters[i] = None;
            clusters[j] = None;
            clusters.push(Some(merged));
            let last = clusters.len() - 1;
            enqueue(&mut queue, &clusters, last, 2.0 * gamma);
        }
    }
    let mut circles: Vec<Circle> = clusters.into_iter().flatten().collect();
    circles.sort_by(|a, b| a.objects.cmp(&b.objects));
    circles
}

/// Two clusters (`i > j`) with close centers; ordered by distance, then by index.
struct Candidate {
    distance: f64,
    i: usize,
    j: usize,
}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.distance
            .total_cmp(&other.distance)
            .then(self.j.cmp(&other.j))
            .then(self.i.cmp(&other.i))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Candidate {}

/// Adds the pairs of cluster `i` with those before it whose centers are closer than `reach`.
fn enqueue(
    queue: &mut BinaryHeap<Reverse<Candidate>>,
    clusters: &[Option<Circle>],
    i: usize,
    reach: f64,
) {
    let Some(new) = &clusters[i] else { return };
    for (j, old) in clusters[..i].iter().enumerate() {
        if let Some(old) = old {
            let distance = old.center.distance(new.center);
            if distance < reach {
                queue.push(Reverse(Candidate { distance, i, j }));
            }
        }
    }
}

/// Points whose bounding circle contains the footprint.
fn outline(object: &Object) -> Vec<Point> {
    let c = object.position;
    match object.footprint {
        Footprint::Box(w, d) => [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]
            .map(|(x, y)| Point::new(c.x + x * w, c.y + y * d))
            .to_vec(),
        Footprint::Disc(radius) => {
            let step = TAU / DISC_SIDES as f64;
            (0..DISC_SIDES)
                .map(|k| c + Point::unit(k as f64 * step) * (radius / libm::cos(0.5 * step)))
                .collect()
        }
    }
}
