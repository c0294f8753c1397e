use crate::anchor::PairAt;
use crate::problem::{Problem, SeparationRule};
use crate::rule::{Rule, Stake};
use crate::sight::Sight;
use crate::term::{Jet, PAIR, Term};
use pairtrawl_geometry::Point;
use pairtrawl_model::ClaimId;

/// The net reaches from hitch to hitch: `d_max - reserve - |r - hitch (u(phi_l) - u(phi_r))| >= 0`,
/// `r` from the right to the left robot, `u` the unit vector of a heading.
pub struct NetReach {
    /// Distance of the hitch behind the axle center, m.
    pub hitch: f64,
    /// Kept in reserve for what happens between waypoints, m.
    pub reserve: f64,
}

/// The line between the hitches.
struct Hitches {
    reach: f64,
    /// Unit vector from the right hitch to the left one.
    ux: f64,
    uy: f64,
    /// Sine and cosine of the left heading, and of the right one.
    left: (f64, f64),
    right: (f64, f64),
}

impl NetReach {
    #[inline]
    fn hitches(&self, &[rx, ry, phi_l, phi_r, _]: &[f64; PAIR]) -> Hitches {
        let h = self.hitch;
        let (sl, cl) = libm::sincos(phi_l);
        let (sr, cr) = libm::sincos(phi_r);
        let (x, y) = (rx - h * (cl - cr), ry - h * (sl - sr));
        let reach = Point::new(x, y).norm();
        Hitches {
            reach,
            ux: x / reach,
            uy: y / reach,
            left: (sl, cl),
            right: (sr, cr),
        }
    }

    #[inline]
    fn slope_from(&self, hitches: &Hitches, d_max: f64) -> (f64, [f64; PAIR]) {
        let &Hitches { reach, ux, uy, .. } = hitches;
        let ((sl, cl), (sr, cr)) = (hitches.left, hitches.right);
        let left = self.hitch * (cl * uy - sl * ux);
        let right = self.hitch * (sr * ux - cr * uy);
        (d_max - self.reserve - reach, [-ux, -uy, left, right, 1.0])
    }
}

impl Term<PAIR> for NetReach {
    #[inline]
    fn value(&self, z: &[f64; PAIR]) -> f64 {
        z[4] - self.reserve - self.hitches(z).reach
    }

    #[inline]
    fn slope(&self, z: &[f64; PAIR]) -> (f64, [f64; PAIR]) {
        self.slope_from(&self.hitches(z), z[4])
    }

    fn jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        let h = self.hitch;
        let hitches = self.hitches(z);
        let mut jet = Jet::constant(0.0);
        (jet.value, jet.gradient) = self.slope_from(&hitches, z[4]);
        let Hitches { reach, ux, uy, .. } = hitches;
        let ((sl, cl), (sr, cr)) = (hitches.left, hitches.right);
        // Columns of d(x, y)/dz for z = rx, ry, phi_l, phi_r.
        let columns = [[1.0, 0.0], [0.0, 1.0], [h * sl, -h * cl], [-h * sr, h * cr]];
        let across = columns.map(|[a, b]| b * ux - a * uy);
        for i in 0..4 {
            for j in 0..4 {
                jet.hessian[i][j] = -across[i] * across[j] / reach;
            }
        }
        jet.hessian[2][2] -= h * (cl * ux + sl * uy);
        jet.hessian[3][3] += h * (cr * ux + sr * uy);
        jet
    }
}

/// A row at every waypoint; those of the ends bound a net length that is free.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HitchesWithinReach;

impl Rule<PairAt, PAIR> for HitchesWithinReach {
    fn look_up(sight: &mut Sight, at: PairAt, add: &mut impl FnMut(Self)) {
        let problem = sight.problem;
        let bounded = problem.separation != SeparationRule::Free;
        if bounded && (sight.is_inner(at.0 as usize) || problem.net_length.is_none()) {
            add(Self);
        }
    }

    #[inline]
    fn term(self, problem: &Problem, _: PairAt) -> impl Term<PAIR> {
        NetReach {
            hitch: problem.robot.hitch,
            reserve: problem.reserve.net_reach,
        }
    }

    fn stake(self, problem: &Problem) -> Option<Stake<'_>> {
        Stake::claim(ClaimId::NetReach, problem.reserve.net_reach)
    }
}
