use crate::term::{Jet, PAIR, Term};

/// The net reaches from hitch to hitch: `d_max - reserve - |r - hitch (u(phi_l) - u(phi_r))| >= 0`,
/// `r` from the right to the left robot, `u` the unit vector of a heading.
pub struct NetReach {
    /// Distance of the hitch behind the axle center, m.
    pub hitch: f64,
    /// Kept in reserve for what happens between waypoints, m.
    pub reserve: f64,
}

impl Term<PAIR> for NetReach {
    #[inline]
    fn value(&self, &[rx, ry, phi_l, phi_r, d_max]: &[f64; PAIR]) -> f64 {
        let h = self.hitch;
        let (x, y) = (
            rx - h * (phi_l.cos() - phi_r.cos()),
            ry - h * (phi_l.sin() - phi_r.sin()),
        );
        d_max - self.reserve - (x * x + y * y).sqrt()
    }

    #[inline]
    fn slope(&self, &[rx, ry, phi_l, phi_r, d_max]: &[f64; PAIR]) -> (f64, [f64; PAIR]) {
        let h = self.hitch;
        let (sl, cl) = phi_l.sin_cos();
        let (sr, cr) = phi_r.sin_cos();
        let (x, y) = (rx - h * (cl - cr), ry - h * (sl - sr));
        let reach = (x * x + y * y).sqrt();
        let (ux, uy) = (x / reach, y / reach);
        let left = h * (cl * uy - sl * ux);
        let right = h * (sr * ux - cr * uy);
        (d_max - self.reserve - reach, [-ux, -uy, left, right, 1.0])
    }

    #[inline]
    fn jet(&self, &[rx, ry, phi_l, phi_r, d_max]: &[f64; PAIR]) -> Jet<PAIR> {
        let h = self.hitch;
        let (sl, cl) = phi_l.sin_cos();
        let (sr, cr) = phi_r.sin_cos();
        let (x, y) = (rx - h * (cl - cr), ry - h * (sl - sr));
        let reach = (x * x + y * y).sqrt();
        let (ux, uy) = (x / reach, y / reach);
        // Columns of d(x, y)/dz for z = rx, ry, phi_l, phi_r.
        let columns = [[1.0, 0.0], [0.0, 1.0], [h * sl, -h * cl], [-h * sr, h * cr]];
        let across = columns.map(|[a, b]| b * ux - a * uy);
        let mut jet = Jet::constant(0.0);
        (jet.value, jet.gradient) = self.slope(&[rx, ry, phi_l, phi_r, d_max]);
        for i in 0..4 {
            for j in 0..4 {
                jet.hessian[i][j] = -across[i] * across[j] / reach;
            }
        }
        jet.hessian[2][2] -= h * (cl * ux + sl * uy);
        jet.hessian[3][3] += h * (cr * ux + sr * uy);
        jet
    }
}
