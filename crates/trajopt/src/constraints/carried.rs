use crate::term::{Jet, POINT, POSE, Term};
use pairtrawl_geometry::Point;

/// A constraint on a point that a robot carries: `term(p + x u(phi) + y u(phi + pi/2))`, the point `(x, y)` in the robot's
/// frame.
pub struct Carried<T> {
    /// The point in the robot's frame, m.
    pub point: Point,
    /// What is asked of it.
    pub term: T,
}

impl<T> Carried<T> {
    /// Where the point is, and how it moves when the robot turns: at this rate, and with minus `arm` for an acceleration.
    #[inline]
    fn place(&self, &[x, y, phi]: &[f64; POSE]) -> (Point, Point) {
        let (sin, cos) = libm::sincos(phi);
        let o = self.point;
        let arm = Point::new(cos * o.x - sin * o.y, sin * o.x + cos * o.y);
        (Point::new(x, y) + arm, arm)
    }
}

impl<T: Term<POINT>> Term<POSE> for Carried<T> {
    #[inline]
    fn value(&self, z: &[f64; POSE]) -> f64 {
        self.term.value(&self.place(z).0.into())
    }

    #[inline]
    fn slope(&self, z: &[f64; POSE]) -> (f64, [f64; POSE]) {
        let (p, arm) = self.place(z);
        let (value, [gx, gy]) = self.term.slope(&p.into());
        (value, [gx, gy, Point::new(gx, gy).dot(arm.perp())])
    }

    fn jet(&self, z: &[f64; POSE]) -> Jet<POSE> {
        let (p, arm) = self.place(z);
        let of_point = self.term.jet(&p.into());
        let gradient = Point::from(of_point.gradient);
        let turn = arm.perp();
        let [a, b] = of_point.hessian.map(|row| Point::from(row).dot(turn));
        let mut jet = Jet::constant(of_point.value);
        jet.gradient = [gradient.x, gradient.y, gradient.dot(turn)];
        for i in 0..POINT {
            for j in 0..POINT {
                jet.hessian[i][j] = of_point.hessian[i][j];
            }
        }
        jet.set_mixed(0, 2, a);
        jet.set_mixed(1, 2, b);
        jet.hessian[2][2] = Point::new(a, b).dot(turn) - gradient.dot(arm);
        jet
    }
}
