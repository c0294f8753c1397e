use crate::anchor::PairAt;
use crate::problem::Problem;
use crate::rule::{Rule, Stake};
use crate::sight::Sight;
use crate::term::{Jet, PAIR, Term};
use pairtrawl_geometry::Point;
use pairtrawl_model::{ClaimId, Side};

/// Robots drive abreast: the angle between a heading and the normal of the line between the robots (the vector from right
/// to left turned by -90 degrees, `n = (ry, -rx)/d`) stays within `max_skew`: `n . u(phi) - cos(max_skew) >= 0`.
#[derive(Clone, Copy, Debug)]
pub struct Abreast {
    /// cos(max_skew).
    pub cos_max_skew: f64,
    /// Whose heading.
    pub robot: Side,
}

impl Abreast {
    /// Place of the heading among the local coordinates of the pair.
    #[inline]
    fn heading(&self) -> usize {
        2 + self.robot.index()
    }
}

impl Term<PAIR> for Abreast {
    #[inline]
    fn value(&self, z: &[f64; PAIR]) -> f64 {
        let [rx, ry, ..] = *z;
        let (sin, cos) = libm::sincos(z[self.heading()]);
        (ry * cos - rx * sin) / Point::new(rx, ry).norm() - self.cos_max_skew
    }

    #[inline]
    fn slope(&self, z: &[f64; PAIR]) -> (f64, [f64; PAIR]) {
        let [rx, ry, ..] = *z;
        let (sin, cos) = libm::sincos(z[self.heading()]);
        let d2 = rx * rx + ry * ry;
        let flat = 1.0 / d2.sqrt();
        let (s, c) = ((ry * cos - rx * sin) * flat, (rx * cos + ry * sin) * flat);
        let mut gradient = [-c * ry / d2, c * rx / d2, 0.0, 0.0, 0.0];
        gradient[self.heading()] = -c;
        (s - self.cos_max_skew, gradient)
    }

    #[inline]
    fn jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        // With beta the angle of r, the constraint is sin(beta - phi) - cos(max_skew).
        let (value, gradient) = self.slope(z);
        let [rx, ry, ..] = *z;
        let k = self.heading();
        let (s, c) = (value + self.cos_max_skew, -gradient[k]);
        let d2 = rx * rx + ry * ry;
        let b = [-ry / d2, rx / d2];
        let bend = [
            [2.0 * rx * ry / (d2 * d2), (ry * ry - rx * rx) / (d2 * d2)],
            [(ry * ry - rx * rx) / (d2 * d2), -2.0 * rx * ry / (d2 * d2)],
        ];
        let mut jet = Jet::constant(value);
        jet.gradient = gradient;
        for i in 0..2 {
            for j in 0..2 {
                jet.hessian[i][j] = -s * b[i] * b[j] + c * bend[i][j];
            }
            jet.set_mixed(i, k, s * b[i]);
        }
        jet.hessian[k][k] = -s;
        jet
    }
}

/// One row a robot at every waypoint.
#[derive(Clone, Copy, Debug)]
pub(crate) struct KeepAbreast(pub Abreast);

impl Rule<PairAt, PAIR> for KeepAbreast {
    fn look_up(sight: &mut Sight, at: PairAt, add: &mut impl FnMut(Self)) {
        if sight.is_inner(at.0 as usize) {
            let problem = sight.problem;
            // Found once, since rows are evaluated often.
            let cos_max_skew = libm::cos(problem.planner.max_skew - problem.reserve.skew);
            for robot in Side::BOTH {
                add(Self(Abreast {
                    cos_max_skew,
                    robot,
                }));
            }
        }
    }

    #[inline]
    fn term(self, _: &Problem, _: PairAt) -> impl Term<PAIR> {
        self.0
    }

    fn key(self) -> u32 {
        self.0.robot.index() as u32
    }

    fn stake(self, problem: &Problem) -> Option<Stake<'_>> {
        Stake::claim(ClaimId::Abreast, problem.reserve.skew)
    }
}
