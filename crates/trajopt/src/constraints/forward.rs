use crate::costs::Distance;
use crate::term::{Jet, STEP, Term};

/// Robots do not drive backwards: `s >= 0`.
pub struct Forward;

const ALONG: Distance = Distance { weight: 1.0 };

impl Term<STEP> for Forward {
    fn value(&self, z: &[f64; STEP]) -> f64 {
        ALONG.value(z)
    }

    fn jet(&self, z: &[f64; STEP]) -> Jet<STEP> {
        ALONG.jet(z)
    }
}
