use crate::anchor::PairAt;
use crate::problem::Problem;
use crate::rule::{Rule, Stake};
use crate::sight::{LOOK_AHEAD, Sight};
use crate::term::{Jet, PAIR, Term};
use pairtrawl_geometry::Point;
use pairtrawl_model::ClaimId;

/// A circle of the left robot's body keeps clear of one of the right robot's: `|r + a(phi_l) - b(phi_r)| - keep >= 0`, `r`
/// from the right to the left axle center, `a` and `b` from the axle centers to those of the circles.
pub struct CirclesApart {
    /// Center of the left robot's circle in its frame, m.
    pub left: Point,
    /// Center of the right robot's circle in its frame, m.
    pub right: Point,
    /// Least distance of the centers, m.
    pub keep: f64,
}

/// The vector between two circles, and the arms to their centers.
struct Between {
    distance: f64,
    unit: Point,
    left: Point,
    right: Point,
}

impl CirclesApart {
    #[inline]
    fn between(&self, &[rx, ry, phi_l, phi_r, _]: &[f64; PAIR]) -> Between {
        let turned = |p: Point, phi: f64| {
            let (sin, cos) = libm::sincos(phi);
            Point::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y)
        };
        let (left, right) = (turned(self.left, phi_l), turned(self.right, phi_r));
        let v = Point::new(rx, ry) + left - right;
        let distance = v.norm();
        Between {
            distance,
            unit: v / distance,
            left,
            right,
        }
    }

    #[inline]
    fn gradient(between: &Between) -> [f64; PAIR] {
        let u = between.unit;
        let (left, right) = (between.left.perp(), between.right.perp());
        [u.x, u.y, u.dot(left), -u.dot(right), 0.0]
    }
}

impl Term<PAIR> for CirclesApart {
    #[inline]
    fn value(&self, z: &[f64; PAIR]) -> f64 {
        self.between(z).distance - self.keep
    }

    #[inline]
    fn slope(&self, z: &[f64; PAIR]) -> (f64, [f64; PAIR]) {
        let between = self.between(z);
        (between.distance - self.keep, Self::gradient(&between))
    }

    fn jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        let between = self.between(z);
        let mut jet = Jet::constant(between.distance - self.keep);
        jet.gradient = Self::gradient(&between);
        let (u, left, right) = (between.unit, between.left.perp(), between.right.perp());
        // How far each coordinate moves the vector across itself.
        let across = [-u.y, u.x, u.cross(left), -u.cross(right)];
        for i in 0..4 {
            for j in 0..4 {
                jet.hessian[i][j] = across[i] * across[j] / between.distance;
            }
        }
        jet.hessian[2][2] -= u.dot(between.left);
        jet.hessian[3][3] += u.dot(between.right);
        jet
    }
}

/// Circles of both bodies that are near each other, by their numbers. Only for robots with a body: the separation keeps
/// discs apart.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BodiesApart {
    pub left: u8,
    pub right: u8,
}

impl Rule<PairAt, PAIR> for BodiesApart {
    fn look_up(sight: &mut Sight, at: PairAt, add: &mut impl FnMut(Self)) {
        let (problem, stage) = (sight.problem, at.0 as usize);
        if problem.robot.body.is_none() || !sight.is_inner(stage) {
            return;
        }
        let z = sight.x.pair(stage);
        let numbers = || 0..problem.body.circles().len() as u8;
        for left in numbers() {
            for right in numbers() {
                let rule = Self { left, right };
                if rule.apart(problem).value(&z) < LOOK_AHEAD {
                    add(rule);
                }
            }
        }
    }

    #[inline]
    fn term(self, problem: &Problem, _: PairAt) -> impl Term<PAIR> {
        self.apart(problem)
    }

    fn key(self) -> u32 {
        (u32::from(self.left) << 8) | u32::from(self.right)
    }

    fn stake(self, problem: &Problem) -> Option<Stake<'_>> {
        Stake::claim(ClaimId::RobotsApart, problem.reserve.separation)
    }
}

impl BodiesApart {
    #[inline]
    fn apart(self, problem: &Problem) -> CirclesApart {
        let [left, right] =
            [self.left, self.right].map(|number| problem.body.circles()[usize::from(number)]);
        CirclesApart {
            left: left.center,
            right: right.center,
            keep: left.radius + right.radius + problem.reserve.separation,
        }
    }
}
