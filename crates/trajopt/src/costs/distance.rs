use crate::term::{Jet, STEP, Term};
use pairtrawl_model::PlannerParameters;

/// The first part of J_dist (the paper's eq. 7): what a robot drives in one step costs `weight` a unit of length.
///
/// Written in the way along the mid-step heading, which is all of it where wheels do not slip, and linear in the coordinates
/// of the step; reports measure the way between both positions.
#[derive(Clone, Copy, Debug)]
pub struct Distance {
    /// `a2 t1`, 1/m.
    pub weight: f64,
}

impl Distance {
    /// Of a scene.
    pub fn of(p: &PlannerParameters) -> Self {
        Self {
            weight: p.a2 * p.t1,
        }
    }
}

impl Term<STEP> for Distance {
    #[inline]
    fn value(&self, &[way]: &[f64; STEP]) -> f64 {
        self.weight * way
    }

    #[inline]
    fn jet(&self, z: &[f64; STEP]) -> Jet<STEP> {
        Jet::linear(self.value(z), [self.weight])
    }
}
