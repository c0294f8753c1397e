use crate::term::{Jet, PAIR, Term};
use pairtrawl_geometry::Point;
use std::f64::consts::FRAC_PI_2;

/// Expansion cost J_e of the net at one waypoint: a U over the separation `d`, written in `eta = d / d_max`,
/// with `rho = d_rest / d_max` and `sigma = d_min / d_max`:
///
/// - below rest: `kd1 tan^2(pi/2 (rho - eta)/(rho - sigma))`;
/// - above rest: `kd2 (d - rho d_max)^2 + q^2/(1 - q)^2`, `q = (eta - rho)/(1 - rho)` (the paper prints a minus sign,
///   which rewards overstretching).
///
/// Close to its poles the function goes on as its second-order Taylor polynomial, so that an iterate outside the domain
/// still has a value; the poles themselves are kept off by the separation constraints.
pub struct Expansion {
    /// a4.
    pub weight: f64,
    /// kd1.
    pub kd1: f64,
    /// kd2, 1/m^2.
    pub kd2: f64,
    /// rho.
    pub rest_ratio: f64,
    /// sigma.
    pub min_ratio: f64,
}

/// Beyond this share of the inner branch the tangent goes on as a polynomial.
const INNER_LIMIT: f64 = 0.97;
/// Beyond this share of the outer branch the barrier goes on as a polynomial.
const OUTER_LIMIT: f64 = 0.97;

/// Value and two derivatives of a function of one variable.
type Scalar = [f64; 3];

/// Goes on with the second-order Taylor polynomial at `limit`.
fn extended(f: impl Fn(f64) -> Scalar, t: f64, limit: f64) -> Scalar {
    if t <= limit {
        return f(t);
    }
    let [f0, f1, f2] = f(limit);
    let u = t - limit;
    [f0 + u * (f1 + 0.5 * u * f2), f1 + u * f2, f2]
}

fn tangent_squared(p: f64) -> Scalar {
    let t = libm::tan(FRAC_PI_2 * p);
    let sec2 = 1.0 + t * t;
    [
        t * t,
        2.0 * FRAC_PI_2 * t * sec2,
        2.0 * FRAC_PI_2 * FRAC_PI_2 * sec2 * (sec2 + 2.0 * t * t),
    ]
}

fn barrier(q: f64) -> Scalar {
    let v = 1.0 / (1.0 - q);
    [
        q * q * v * v,
        2.0 * q * v * v * v,
        2.0 * v * v * v + 6.0 * q * (v * v * v * v),
    ]
}

impl Expansion {
    /// J_e as a function of `eta` (both branches but for the kd2 term) with two derivatives in `eta`.
    fn of_ratio(&self, eta: f64) -> Scalar {
        if eta < self.rest_ratio {
            let width = self.rest_ratio - self.min_ratio;
            let [f0, f1, f2] = extended(
                tangent_squared,
                (self.rest_ratio - eta) / width,
                INNER_LIMIT,
            );
            [
                self.kd1 * f0,
                -self.kd1 * f1 / width,
                self.kd1 * f2 / (width * width),
            ]
        } else {
            let width = 1.0 - self.rest_ratio;
            let [f0, f1, f2] = extended(barrier, (eta - self.rest_ratio) / width, OUTER_LIMIT);
            [f0, f1 / width, f2 / (width * width)]
        }
    }
}

impl Expansion {
    /// As [`Term::jet`], its Hessian without what is negative: a positive semidefinite stand-in.
    pub fn convex_jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        self.jet_with(z, true)
    }

    fn jet_with(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR], convex: bool) -> Jet<PAIR> {
        let d = Point::new(rx, ry).norm();
        let eta = d / d_max;
        let [f0, f1, f2] = self.of_ratio(eta);
        let stretch = (d - self.rest_ratio * d_max).max(0.0);
        let k = if stretch > 0.0 { self.kd2 } else { 0.0 };
        let rho = self.rest_ratio;
        // Derivatives in (d, d_max) ...
        let value = f0 + k * stretch * stretch;
        let j_d = f1 / d_max + 2.0 * k * stretch;
        let j_m = -f1 * eta / d_max - 2.0 * k * rho * stretch;
        let j_dd = f2 / (d_max * d_max) + 2.0 * k;
        let j_dm = -(f1 + f2 * eta) / (d_max * d_max) - 2.0 * k * rho;
        let mut j_mm = (2.0 * f1 * eta + f2 * eta * eta) / (d_max * d_max) + 2.0 * k * rho * rho;
        if convex && j_dd > 0.0 {
            j_mm = j_mm.max(j_dm * j_dm / j_dd);
        }
        // ... and d in (rx, ry).
        let (ux, uy) = (rx / d, ry / d);
        let w = self.weight;
        let mut jet = Jet::constant(w * value);
        jet.gradient = [w * j_d * ux, w * j_d * uy, 0.0, 0.0, w * j_m];
        let bend = if convex { j_d.max(0.0) } else { j_d } / d;
        jet.hessian[0][0] = w * (j_dd * ux * ux + bend * uy * uy);
        jet.hessian[1][1] = w * (j_dd * uy * uy + bend * ux * ux);
        jet.set_mixed(0, 1, w * (j_dd - bend) * ux * uy);
        jet.set_mixed(0, 4, w * j_dm * ux);
        jet.set_mixed(1, 4, w * j_dm * uy);
        jet.hessian[4][4] = w * j_mm;
        jet
    }
}

impl Term<PAIR> for Expansion {
    #[inline]
    fn value(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR]) -> f64 {
        let d = Point::new(rx, ry).norm();
        let stretch = (d - self.rest_ratio * d_max).max(0.0);
        self.weight * (self.of_ratio(d / d_max)[0] + self.kd2 * stretch * stretch)
    }

    fn slope(&self, z: &[f64; PAIR]) -> (f64, [f64; PAIR]) {
        let jet = self.jet(z);
        (jet.value, jet.gradient)
    }

    #[inline]
    fn jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        self.jet_with(z, false)
    }
}
