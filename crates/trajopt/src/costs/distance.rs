use crate::term::{Jet, STEP, Term};

/// Driven distance `t1 s` with `s = dx cos psi + dy sin psi`: on steps without sideways slip, and forward, `s` is the
/// length of the displacement, without its square root (paper's J_dist; turning is an elastic row, see `constraints`).
pub struct Distance {
    /// a2 t1, 1/m.
    pub weight: f64,
}

impl Term<STEP> for Distance {
    fn value(&self, &[dx, dy, psi, _]: &[f64; STEP]) -> f64 {
        self.weight * (dx * psi.cos() + dy * psi.sin())
    }

    fn jet(&self, &[dx, dy, psi, _]: &[f64; STEP]) -> Jet<STEP> {
        let (sin, cos) = psi.sin_cos();
        let w = self.weight;
        let along = dx * cos + dy * sin;
        let across = dy * cos - dx * sin;
        let mut jet = Jet::constant(w * along);
        jet.gradient = [w * cos, w * sin, w * across, 0.0];
        jet.set_mixed(0, 2, -w * sin);
        jet.set_mixed(1, 2, w * cos);
        jet.hessian[2][2] = -w * along;
        jet
    }
}
