use crate::term::{BEND, Jet, Term};
use pairtrawl_model::PlannerParameters;

/// Smoothness cost J_s of one coordinate at one bend (the paper's eq. 9): `weight (z[i-1] - 2 z[i] + z[i+1])^2`, the second
/// difference with unit step.
#[derive(Clone, Copy, Debug)]
pub struct Smoothness {
    /// `a1 b_j`, for this coordinate.
    pub weight: f64,
}

/// The second difference of three values.
const STENCIL: [f64; BEND] = [1.0, -2.0, 1.0];

impl Smoothness {
    /// Of x (0), y (1) or heading (2).
    #[inline]
    pub fn of_coordinate(p: &PlannerParameters, coordinate: usize) -> Self {
        Self {
            weight: p.a1 * [p.b1, p.b2, p.b3][coordinate],
        }
    }
}

impl Term<BEND> for Smoothness {
    #[inline]
    fn value(&self, &[before, here, after]: &[f64; BEND]) -> f64 {
        let second = before - 2.0 * here + after;
        self.weight * second * second
    }

    #[inline]
    fn jet(&self, z: &[f64; BEND]) -> Jet<BEND> {
        let w = 2.0 * self.weight;
        let second = z[0] - 2.0 * z[1] + z[2];
        Jet {
            value: self.value(z),
            gradient: STENCIL.map(|a| w * second * a),
            hessian: STENCIL.map(|a| STENCIL.map(|b| w * a * b)),
        }
    }
}
