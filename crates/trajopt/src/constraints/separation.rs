use crate::term::{Jet, PAIR, Term};

/// `d >= lower + ratio d_max`: robots keep clear of each other.
pub struct SeparationAbove {
    /// m.
    pub lower: f64,
    /// Share of the net length.
    pub ratio: f64,
}

/// `d <= ratio d_max - reserve`: the net is long enough between the axle centers (`ratio` 1).
pub struct SeparationBelow {
    /// m.
    pub reserve: f64,
    /// Share of the net length.
    pub ratio: f64,
}

/// `sign d + offset + slope d_max` with derivatives.
fn distance_jet(rx: f64, ry: f64, d_max: f64, sign: f64, offset: f64, slope: f64) -> Jet<PAIR> {
    let d = rx.hypot(ry);
    let (ux, uy) = (rx / d, ry / d);
    let mut jet = Jet::constant(sign * d + offset + slope * d_max);
    jet.gradient = [sign * ux, sign * uy, 0.0, 0.0, slope];
    jet.hessian[0][0] = sign * uy * uy / d;
    jet.hessian[1][1] = sign * ux * ux / d;
    jet.set_mixed(0, 1, -sign * ux * uy / d);
    jet
}

impl Term<PAIR> for SeparationAbove {
    fn value(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR]) -> f64 {
        rx.hypot(ry) - self.lower - self.ratio * d_max
    }

    fn jet(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR]) -> Jet<PAIR> {
        distance_jet(rx, ry, d_max, 1.0, -self.lower, -self.ratio)
    }
}

impl Term<PAIR> for SeparationBelow {
    fn value(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR]) -> f64 {
        self.ratio * d_max - self.reserve - rx.hypot(ry)
    }

    fn jet(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR]) -> Jet<PAIR> {
        distance_jet(rx, ry, d_max, -1.0, -self.reserve, self.ratio)
    }
}
