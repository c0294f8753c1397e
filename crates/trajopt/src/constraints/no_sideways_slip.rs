use crate::term::{Jet, STEP, Term};

/// Wheels do not slip sideways: the displacement across the mid-step heading is zero,
/// `h = dy cos psi - dx sin psi = 0`. The only equality.
pub struct NoSidewaysSlip;

impl Term<STEP> for NoSidewaysSlip {
    fn value(&self, &[dx, dy, psi, _]: &[f64; STEP]) -> f64 {
        dy * psi.cos() - dx * psi.sin()
    }

    fn jet(&self, &[dx, dy, psi, _]: &[f64; STEP]) -> Jet<STEP> {
        let (sin, cos) = psi.sin_cos();
        let along = dx * cos + dy * sin;
        let across = dy * cos - dx * sin;
        let mut jet = Jet::constant(across);
        jet.gradient = [-sin, cos, -along, 0.0];
        jet.set_mixed(0, 2, -cos);
        jet.set_mixed(1, 2, -sin);
        jet.hessian[2][2] = -across;
        jet
    }
}
