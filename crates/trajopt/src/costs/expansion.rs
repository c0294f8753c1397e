use crate::problem::{Problem, SeparationRule};
use crate::term::{Jet, PAIR, Term};
use pairtrawl_geometry::Point;
use pairtrawl_model::{PlannerParameters, Robot, RobotSize};
use std::f64::consts::FRAC_PI_2;

/// Expansion cost J_e of the net at one waypoint (the paper's eq. 8): a U over the separation `d`, written in `eta = d / d_max`,
/// with `rho = d_rest / d_max` and `sigma = d_min / d_max`:
///
/// - below rest: `kd1 tan^2(pi/2 (rho - eta)/(rho - sigma))`;
/// - above rest: `kd2 (d - rho d_max)^2 + q^2/(1 - q)^2`, `q = (eta - rho)/(1 - rho)` (the paper prints a minus sign,
///   which rewards overstretching).
///
/// Close to its poles the function goes on as its second-order Taylor polynomial, so that an iterate outside the domain
/// still has a value; the poles themselves are kept off by the separation constraints.
pub struct Expansion {
    /// a4, or what it is per waypoint where the cost is summed per meter.
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

/// Beyond these shares of the inner and the outer branch they go on as polynomials.
const LIMITS: [f64; 2] = [0.97; 2];

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
    /// As the paper has it, or per meter where the parameters say so.
    pub fn literal(p: &PlannerParameters, robot: &Robot) -> Self {
        Self {
            weight: RobotSize::of(robot).expansion_weight(p),
            kd1: p.kd1,
            kd2: p.kd2,
            rest_ratio: p.rest_ratio,
            min_ratio: p.min_ratio,
        }
    }

    /// What is minimized in a problem.
    pub fn of(problem: &Problem) -> Self {
        let mut cost = Self::literal(&problem.planner, &problem.robot);
        if problem.separation == SeparationRule::Free {
            cost.weight = 0.0;
        }
        cost
    }

    /// J_e for reports: to its poles, and `weight outside` beyond them.
    pub fn to_the_poles(&self, d: f64, d_max: f64, outside: f64) -> f64 {
        if d < self.min_ratio * d_max || d > d_max {
            return self.weight * outside;
        }
        let [value, ..] = self.of_ratio(d / d_max, [1.0; 2]);
        let stretch = self.stretch(d, d_max);
        self.weight * (value + self.kd2 * stretch * stretch)
    }

    /// How far the separation is above rest.
    fn stretch(&self, d: f64, d_max: f64) -> f64 {
        (d - self.rest_ratio * d_max).max(0.0)
    }

    /// J_e as a function of `eta` (both branches but for the kd2 term) with two derivatives in `eta`; `limits` are the
    /// shares of the inner and the outer branch beyond which it goes on as a polynomial.
    fn of_ratio(&self, eta: f64, [inner, outer]: [f64; 2]) -> Scalar {
        if eta < self.rest_ratio {
            let width = self.rest_ratio - self.min_ratio;
            let [f0, f1, f2] = extended(tangent_squared, (self.rest_ratio - eta) / width, inner);
            [
                self.kd1 * f0,
                -self.kd1 * f1 / width,
                self.kd1 * f2 / (width * width),
            ]
        } else {
            let width = 1.0 - self.rest_ratio;
            let [f0, f1, f2] = extended(barrier, (eta - self.rest_ratio) / width, outer);
            [f0, f1 / width, f2 / (width * width)]
        }
    }

    fn jet_with(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR], convex: bool) -> Jet<PAIR> {
        let d = Point::new(rx, ry).norm();
        let eta = d / d_max;
        let [f0, f1, f2] = self.of_ratio(eta, LIMITS);
        let stretch = self.stretch(d, d_max);
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
        let stretch = self.stretch(d, d_max);
        self.weight * (self.of_ratio(d / d_max, LIMITS)[0] + self.kd2 * stretch * stretch)
    }

    #[inline]
    fn jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        self.jet_with(z, false)
    }

    /// Its Hessian without what is negative: a positive semidefinite stand-in.
    #[inline]
    fn convex_jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        self.jet_with(z, true)
    }
}
