//! Circles of a robot's body whose centers are off the axle: they move when the robot turns.

use super::carried::Carried;
use super::point_distance::{KeepOff, OffObject, OffObstacle};
use crate::anchor::{Anchor, PointAt, PoseAt};
use crate::problem::Problem;
use crate::rule::{Rule, Stake};
use crate::sight::Sight;
use crate::term::{POINT, POSE, Term};
use pairtrawl_geometry::Pose;

/// A circle of a robot's body near a thing, from which it keeps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BodyOff<K> {
    pub circle: u8,
    pub off: K,
}

pub(crate) type BodyOffObject = BodyOff<OffObject>;
pub(crate) type BodyOffObstacle = BodyOff<OffObstacle>;

/// Keys of the rows about one circle follow those about the one before: a body has at most 16.
fn key(circle: u8, thing: u32) -> u32 {
    (u32::from(circle) << 28) | thing
}

impl<K: KeepOff + Rule<PointAt, POINT>> Rule<PoseAt, POSE> for BodyOff<K> {
    fn look_up(sight: &mut Sight, at: PoseAt, add: &mut impl FnMut(Self)) {
        let problem = sight.problem;
        let here = (at.stage(), at.robot());
        let pose = Pose::from(sight.x.pose(at.stage(), at.robot()));
        for (circle, c) in (0..).zip(&problem.circles) {
            let center = c.center_at(pose);
            K::near(sight, here, center, c.radius, |off| {
                add(Self { circle, off })
            });
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
