//! Circles of a robot's body whose centers are off the axle: they move when the robot turns.

use super::carried::Carried;
use super::point_distance::{OffObject, OffObstacle};
use crate::anchor::{Anchor, PoseAt};
use crate::problem::Problem;
use crate::rule::{Rule, Stake};
use crate::sight::Sight;
use crate::term::{POSE, Term};
use pairtrawl_geometry::{Point, Pose};

/// A circle of a robot's body near an object, from which it keeps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BodyOffObject {
    pub circle: u8,
    pub off: OffObject,
}

/// A circle of a robot's body near an obstacle, from which it keeps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BodyOffObstacle {
    pub circle: u8,
    pub off: OffObstacle,
}

/// Number, center and radius of every circle, when the robot is at a pose.
fn circles(sight: &Sight, at: PoseAt) -> impl Iterator<Item = (u8, Point, f64)> + use<> {
    let pose = Pose::from(sight.x.pose(at.stage(), at.robot()));
    let placed =
        |(number, c): (u8, &pairtrawl_model::BodyCircle)| (number, c.center_at(pose), c.radius);
    let placed: Vec<_> = (0..).zip(&sight.problem.circles).map(placed).collect();
    placed.into_iter()
}

/// Keys of the rows about one circle follow those about the one before: a body has at most 16.
fn key(circle: u8, thing: u32) -> u32 {
    (u32::from(circle) << 28) | thing
}

impl Rule<PoseAt, POSE> for BodyOffObject {
    fn look_up(sight: &mut Sight, at: PoseAt, add: &mut impl FnMut(Self)) {
        for (circle, p, radius) in circles(sight, at) {
            let here = (at.stage(), at.robot());
            OffObject::near(sight, here, p, radius, |off| add(Self { circle, off }));
        }
    }

    #[inline]
    fn term(self, problem: &Problem, _: PoseAt) -> impl Term<POSE> {
        let circle = &problem.circles[usize::from(self.circle)];
        Carried {
            point: circle.center,
            term: self.off.distance(problem, circle.radius),
        }
    }

    fn key(self) -> u32 {
        key(self.circle, self.off.key())
    }

    fn price(self, problem: &Problem, elastic: f64) -> f64 {
        self.off.price(problem, elastic)
    }

    fn stake(self, problem: &Problem) -> Option<Stake<'_>> {
        self.off.stake(problem)
    }
}

impl Rule<PoseAt, POSE> for BodyOffObstacle {
    fn look_up(sight: &mut Sight, at: PoseAt, add: &mut impl FnMut(Self)) {
        for (circle, p, radius) in circles(sight, at) {
            OffObstacle::near(sight, p, radius, |off| add(Self { circle, off }));
        }
    }

    #[inline]
    fn term(self, problem: &Problem, _: PoseAt) -> impl Term<POSE> {
        let circle = &problem.circles[usize::from(self.circle)];
        Carried {
            point: circle.center,
            term: self.off.distance(problem, circle.radius),
        }
    }

    fn key(self) -> u32 {
        key(self.circle, self.off.key())
    }

    fn price(self, problem: &Problem, elastic: f64) -> f64 {
        self.off.price(problem, elastic)
    }

    fn stake(self, problem: &Problem) -> Option<Stake<'_>> {
        self.off.stake(problem)
    }
}
