use crate::term::{Jet, POINT, Term};

/// A robot stays on its side of an object where the line between the robots passes over it, or inside the area:
/// `n . p - offset >= 0`.
#[derive(Clone, Copy, Debug)]
pub struct HalfPlane {
    /// Unit normal.
    pub normal: [f64; 2],
    /// m.
    pub offset: f64,
}

impl Term<POINT> for HalfPlane {
    #[inline]
    fn value(&self, p: &[f64; POINT]) -> f64 {
        self.normal[0] * p[0] + self.normal[1] * p[1] - self.offset
    }

    #[inline]
    fn slope(&self, p: &[f64; POINT]) -> (f64, [f64; POINT]) {
        (self.value(p), self.normal)
    }

    fn jet(&self, p: &[f64; POINT]) -> Jet<POINT> {
        let mut jet = Jet::constant(self.value(p));
        jet.gradient = self.normal;
        jet
    }
}
