use crate::term::{Jet, STEP, Term};

/// A bound on one coordinate of a step: `offset + sign z >= 0` (the paper's eq. 11).
#[derive(Clone, Copy, Debug)]
pub struct StepBound {
    /// 1 or -1.
    pub sign: f64,
    /// m or rad.
    pub offset: f64,
}

impl Term<STEP> for StepBound {
    #[inline]
    fn value(&self, &[z]: &[f64; STEP]) -> f64 {
        self.offset + self.sign * z
    }

    #[inline]
    fn slope(&self, z: &[f64; STEP]) -> (f64, [f64; STEP]) {
        (self.value(z), [self.sign])
    }

    fn jet(&self, z: &[f64; STEP]) -> Jet<STEP> {
        Jet::linear(self.value(z), [self.sign])
    }
}
