//! The narrow trait behind which every cost and constraint stands, and the local coordinates that they are written in.

/// Value, gradient and Hessian of a scalar function of `K` local coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Jet<const K: usize> {
    /// Its value.
    pub value: f64,
    /// First derivatives.
    pub gradient: [f64; K],
    /// Second derivatives, symmetric.
    pub hessian: [[f64; K]; K],
}

impl<const K: usize> Jet<K> {
    /// A constant.
    pub fn constant(value: f64) -> Self {
        Self::linear(value, [0.0; K])
    }

    /// A function without curvature.
    pub fn linear(value: f64, gradient: [f64; K]) -> Self {
        Self {
            value,
            gradient,
            hessian: [[0.0; K]; K],
        }
    }

    /// Sets a mixed second derivative on both sides of the diagonal.
    pub fn set_mixed(&mut self, i: usize, j: usize, value: f64) {
        self.hessian[i][j] = value;
        self.hessian[j][i] = value;
    }
}

/// A twice differentiable scalar function of `K` local coordinates: a cost, or a constraint `c >= 0`.
///
/// `value` and the derivatives are written apart, so that a derivative check compares two things.
pub trait Term<const K: usize> {
    /// The value alone.
    fn value(&self, z: &[f64; K]) -> f64;

    /// The value with first and second derivatives.
    fn jet(&self, z: &[f64; K]) -> Jet<K>;

    /// The value with first derivatives, which is all that a constraint needs in every iteration.
    #[inline]
    fn slope(&self, z: &[f64; K]) -> (f64, [f64; K]) {
        let jet = self.jet(z);
        (jet.value, jet.gradient)
    }

    /// The jet of a cost as the solver's matrix gets it. A cost with negative curvature does well to leave that out here:
    /// otherwise the solver has to make up for it in all variables.
    #[inline]
    fn convex_jet(&self, z: &[f64; K]) -> Jet<K> {
        self.jet(z)
    }
}

impl<const K: usize, T: Term<K> + ?Sized> Term<K> for &T {
    #[inline]
    fn value(&self, z: &[f64; K]) -> f64 {
        (**self).value(z)
    }

    #[inline]
    fn jet(&self, z: &[f64; K]) -> Jet<K> {
        (**self).jet(z)
    }

    #[inline]
    fn slope(&self, z: &[f64; K]) -> (f64, [f64; K]) {
        (**self).slope(z)
    }

    #[inline]
    fn convex_jet(&self, z: &[f64; K]) -> Jet<K> {
        (**self).convex_jet(z)
    }
}

/// Local coordinates of the pair at one waypoint: `rx, ry` (from right to left robot, m), `phi_l, phi_r` (rad), `d_max` (m).
pub const PAIR: usize = 5;
/// Local coordinates of one robot at one waypoint: `x, y`, m.
pub const POINT: usize = 2;
/// Local coordinates of one robot's pose at one waypoint: `x, y`, m, `phi`, rad.
pub const POSE: usize = 3;
/// Local coordinates of the line between the robots at both ends of a step: `lx, ly, rx, ry`, then those of the next waypoint, m.
pub const QUAD: usize = 8;
/// Local coordinate of one robot over one step: the way along its mid-step heading, m, or the turn, rad.
pub const STEP: usize = 1;
/// Local coordinates of a bend: one variable at three successive waypoints, m or rad.
pub const BEND: usize = 3;
