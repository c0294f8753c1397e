use crate::term::{Jet, PAIR, Term};
use pairtrawl_geometry::Point;

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

/// `sign d + offset + slope d_max`.
struct Linear {
    sign: f64,
    offset: f64,
    slope: f64,
}

impl Linear {
    #[inline]
    fn slope(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR]) -> (f64, [f64; PAIR]) {
        let d = Point::new(rx, ry).norm();
        let scale = self.sign / d;
        (
            self.sign * d + self.offset + self.slope * d_max,
            [scale * rx, scale * ry, 0.0, 0.0, self.slope],
        )
    }

    fn jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        let (value, gradient) = self.slope(z);
        let mut jet = Jet::constant(value);
        jet.gradient = gradient;
        let (ux, uy) = (self.sign * gradient[0], self.sign * gradient[1]);
        let bend = self.sign / Point::new(z[0], z[1]).norm();
        jet.hessian[0][0] = bend * uy * uy;
        jet.hessian[1][1] = bend * ux * ux;
        jet.set_mixed(0, 1, -bend * ux * uy);
        jet
    }
}

impl SeparationAbove {
    fn linear(&self) -> Linear {
        Linear {
            sign: 1.0,
            offset: -self.lower,
            slope: -self.ratio,
        }
    }
}

impl SeparationBelow {
    fn linear(&self) -> Linear {
        Linear {
            sign: -1.0,
            offset: -self.reserve,
            slope: self.ratio,
        }
    }
}

impl Term<PAIR> for SeparationAbove {
    #[inline]
    fn value(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR]) -> f64 {
        Point::new(rx, ry).norm() - self.lower - self.ratio * d_max
    }

    #[inline]
    fn slope(&self, z: &[f64; PAIR]) -> (f64, [f64; PAIR]) {
        self.linear().slope(z)
    }

    fn jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        self.linear().jet(z)
    }
}

impl Term<PAIR> for SeparationBelow {
    #[inline]
    fn value(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR]) -> f64 {
        self.ratio * d_max - self.reserve - Point::new(rx, ry).norm()
    }

    #[inline]
    fn slope(&self, z: &[f64; PAIR]) -> (f64, [f64; PAIR]) {
        self.linear().slope(z)
    }

    fn jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        self.linear().jet(z)
    }
}
