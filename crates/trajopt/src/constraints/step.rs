use crate::costs::Distance;
use crate::term::{Jet, STEP, Term};

/// A step is at most Delta L_max long: `max_step - s >= 0` (paper's maximum velocity constraint).
pub struct StepLength {
    /// Delta L_max, m.
    pub max_step: f64,
}

const BACKWARD: Distance = Distance { weight: -1.0 };

impl Term<STEP> for StepLength {
    fn value(&self, z: &[f64; STEP]) -> f64 {
        self.max_step + BACKWARD.value(z)
    }

    fn jet(&self, z: &[f64; STEP]) -> Jet<STEP> {
        let mut jet = BACKWARD.jet(z);
        jet.value += self.max_step;
        jet
    }
}
