use crate::term::{Jet, STEP, Term};

/// A linear bound on the heading change of a step: `offset + sign delta >= 0`.
///
/// With `offset = Delta phi_max` it is the paper's limit on one side; with `offset = 0` and an elastic weight of `2 t2` it
/// makes `t2 |delta| = -t2 delta + 2 t2 max(0, delta)` exactly, without a smoothing width.
pub struct Turn {
    /// rad.
    pub offset: f64,
    /// 1 or -1.
    pub sign: f64,
}

impl Term<STEP> for Turn {
    fn value(&self, z: &[f64; STEP]) -> f64 {
        self.offset + self.sign * z[3]
    }

    fn jet(&self, z: &[f64; STEP]) -> Jet<STEP> {
        let mut jet = Jet::constant(self.offset + self.sign * z[3]);
        jet.gradient[3] = self.sign;
        jet
    }
}
