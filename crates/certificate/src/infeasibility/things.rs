use crate::obstacles::{Obstacles, Part};
use pairtrawl_geometry::{Point, Segment};
use pairtrawl_model::{BodyCircle, Robot, Scales, Scene, Side};
use std::fmt;

/// Everything that a robot's center keeps its radius from: obstacles and objects' footprint circles.
pub(super) struct Things<'a> {
    pub(super) scene: &'a Scene,
    pub(super) obstacles: Obstacles<'a>,
    /// What a robot keeps around its axle center from everything at least, m.
    pub(super) keep: f64,
    /// The largest circle of a robot's body: it has to get wherever the robot goes.
    pub(super) largest: BodyCircle,
    /// False when nobody reads the proofs: then no least move is found.
    pub(super) in_words: bool,
    /// The scene's length scale, m.
    pub(super) scale: f64,
}

/// What a robot surely keeps around its axle center from everything, m: the radius of the largest circle around it that its
/// body contains. Below zero where no circle of the body contains the axle center; it is then so deep in an obstacle at
/// most.
pub(super) fn sure_radius(robot: &Robot) -> f64 {
    robot.circles().inner_radius()
}

/// The largest circle of a robot's body; of equal ones that which is nearest to the axle center.
fn largest(robot: &Robot) -> BodyCircle {
    let body = robot.circles();
    let larger = |a: &BodyCircle, b: &BodyCircle| {
        b.radius > a.radius || (b.radius == a.radius && b.offset() < a.offset())
    };
    let mut largest = body.circles()[0];
    for circle in body.circles() {
        if larger(&largest, circle) {
            largest = *circle;
        }
    }
    largest
}

/// One of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Thing {
    Obstacle(Part),
    Object(usize),
}

impl fmt::Display for Thing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Obstacle(part) => part.fmt(f),
            Self::Object(index) => write!(f, "the footprint circle of object {index}"),
        }
    }
}

impl<'a> Things<'a> {
    /// `None` when an obstacle is malformed.
    pub(super) fn new(scene: &'a Scene) -> Option<Self> {
        Obstacles::new(scene).ok().map(|obstacles| Self {
            scene,
            obstacles,
            keep: sure_radius(&scene.robot),
            largest: largest(&scene.robot),
            in_words: true,
            scale: Scales::of(scene).length,
        })
    }

    /// The gap between an obstacle and a footprint circle of this radius that an axle center needs to pass between them, m.
    pub(super) fn gap_to_pass(&self, footprint: f64) -> f64 {
        let body = self.scene.robot.circles();
        let needed = |c: &BodyCircle| {
            let (r, o) = (c.radius, c.offset());
            if c.is_centered() {
                return 2.0 * r;
            }
            // A circle that does not contain the axle center may be elsewhere.
            if o >= r {
                return 0.0;
            }
            let leg = |reach: f64| (reach * reach - o * o).sqrt();
            leg(footprint + r) + leg(r) - footprint
        };
        body.circles().iter().map(needed).fold(0.0, f64::max)
    }

    /// Where the largest circle of a robot is at the scene's start and at its end.
    pub(super) fn ends_of_largest(&self, side: Side) -> [Point; 2] {
        let ends = [self.scene.start, self.scene.end];
        ends.map(|pair| self.largest.center_at(pair.robot(side)))
    }

    /// The signed distance of a point to the nearest thing when it is below `bound`, leaving out one object.
    pub(super) fn nearest(
        &self,
        p: Point,
        bound: f64,
        skip: Option<usize>,
    ) -> Option<(f64, Thing)> {
        let mut found = self
            .obstacles
            .distance(p, bound)
            .map(|(d, part)| (d, Thing::Obstacle(part)));
        for (i, object) in self
            .scene
            .objects
            .iter()
            .enumerate()
            .filter(|(i, _)| Some(*i) != skip)
        {
            let (d, rho) = (object.position - p, object.footprint_radius());
            let best = found.map_or(bound, |(d, _)| d);
            if d.x.abs().max(d.y.abs()) - rho < best {
                let distance = d.norm() - rho;
                if distance < best {
                    found = Some((distance, Thing::Object(i)));
                }
            }
        }
        found
    }

    /// Like [`Self::nearest`], without one thing.
    pub(super) fn nearest_other(
        &self,
        p: Point,
        bound: f64,
        skip: Option<usize>,
        other: Thing,
    ) -> Option<(f64, Thing)> {
        let obstacles = self
            .obstacles
            .distances(p, bound)
            .into_iter()
            .map(|(d, part)| (d, Thing::Obstacle(part)));
        let objects = self
            .scene
            .objects
            .iter()
            .enumerate()
            .filter(|(i, _)| Some(*i) != skip);
        let objects = objects.map(|(i, o)| {
            (
                o.position.distance(p) - o.footprint_radius(),
                Thing::Object(i),
            )
        });
        obstacles
            .chain(objects)
            .filter(|&(d, thing)| d < bound && thing != other)
            .reduce(|a, b| if b.0 < a.0 { b } else { a })
    }

    fn outline(&self, thing: Thing) -> (Vec<Segment>, f64) {
        match thing {
            Thing::Obstacle(part) => self.obstacles.outline(part),
            Thing::Object(i) => {
                let object = &self.scene.objects[i];
                (
                    vec![Segment::new(object.position, object.position)],
                    object.footprint_radius(),
                )
            }
        }
    }

    /// The point of a thing's outline nearest to `p`; `p` itself for a thing without outline.
    pub(super) fn nearest_point(&self, thing: Thing, p: Point) -> Point {
        let (segments, radius) = self.outline(thing);
        let feet = segments.iter().map(|s| s.nearest(p));
        let foot = feet
            .reduce(|a, b| if b.distance(p) < a.distance(p) { b } else { a })
            .unwrap_or(p);
        let away = foot.distance(p);
        if away > 0.0 {
            foot.lerp(p, radius / away)
        } else {
            foot
        }
    }

    /// The point of an obstacle's outline nearest to `p`.
    pub(super) fn nearest_point_of(&self, part: Part, p: Point) -> Point {
        self.nearest_point(Thing::Obstacle(part), p)
    }

    /// The distance between the outlines of two things, m.
    pub(super) fn between(&self, a: Thing, b: Thing) -> f64 {
        let ((a, ra), (b, rb)) = (self.outline(a), self.outline(b));
        let pairs = a
            .iter()
            .flat_map(|s| b.iter().map(move |t| s.gap_to_segment(t).distance));
        pairs.fold(f64::INFINITY, f64::min) - ra - rb
    }
}
