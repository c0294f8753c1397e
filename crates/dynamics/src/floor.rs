//! Friction of an object on the floor: four support points, each with a quarter of the weight.

use crate::block::Triple;
use crate::friction::{self, Drag};
use crate::matrix::Matrix;
use pairtrawl_geometry::Point;

/// Support points of an object and their part in the system of a step.
#[derive(Clone, Debug)]
pub(crate) struct Supports {
    /// In the body frame.
    places: [Point; 4],
    /// mu m g / 4, N.
    limit: f64,
    arms: [Point; 4],
    drags: [Drag; 4],
}

impl Supports {
    /// At (+-x, +-y) of `corner`, with friction `limit` (N) together.
    pub(crate) fn new(corner: Point, limit: f64) -> Self {
        Self {
            places: [
                corner,
                Point::new(-corner.x, corner.y),
                -corner,
                Point::new(corner.x, -corner.y),
            ],
            limit: 0.25 * limit,
            arms: [Point::ZERO; 4],
            drags: [Drag::default(); 4],
        }
    }

    /// At the beginning of a step.
    pub(crate) fn begin(&mut self, axis: Point) {
        self.arms = self.places.map(|p| axis * p.x + axis.perp() * p.y);
    }

    /// Adds minus the floor's impulses at the velocities `u` of the object to its gradient.
    pub(crate) fn evaluate(&mut self, dt: f64, first: bool, u: &Triple, gradient: &mut Triple) {
        let velocity = Point::new(u[0], u[1]);
        let (mut force, mut torque) = (Point::ZERO, 0.0);
        for (arm, drag) in self.arms.iter().zip(&mut self.drags) {
            let held = first && drag.holds;
            *drag = friction::drag(self.limit, velocity + arm.perp() * u[2], held);
            force += drag.force;
            torque += arm.cross(drag.force);
        }
        gradient[0] -= dt * force.x;
        gradient[1] -= dt * force.y;
        gradient[2] -= dt * torque;
    }

    /// Minus the power of the floor's impulses along the direction `d`, at the velocities `u`.
    pub(crate) fn slope(&self, dt: f64, u: &Triple, d: &Triple) -> f64 {
        let (velocity, rate) = (Point::new(u[0], u[1]), Point::new(d[0], d[1]));
        let mut power = 0.0;
        for arm in &self.arms {
            let n = arm.perp();
            let force = friction::force(self.limit, velocity + n * u[2]);
            power += force.dot(rate + n * d[2]);
        }
        -dt * power
    }

    /// Adds the derivative of [`Self::evaluate`]'s terms.
    pub(crate) fn add_stiffness(&self, dt: f64, slot: u32, matrix: &mut Matrix) {
        let mut sum = [0.0; 6];
        for (arm, drag) in self.arms.iter().zip(&self.drags) {
            let (t, n) = (drag.direction, drag.direction.perp());
            for (direction, weight) in [(t, drag.along), (n, drag.across)] {
                let turn = arm.cross(direction);
                let scaled = direction * weight;
                sum[0] += scaled.x * direction.x;
                sum[1] += scaled.y * direction.x;
                sum[2] += scaled.y * direction.y;
                sum[3] += scaled.x * turn;
                sum[4] += scaled.y * turn;
                sum[5] += weight * turn * turn;
            }
        }
        let [xx, xy, yy, xt, yt, tt] = sum.map(|value| dt * value);
        let rows = [[xx, xy, xt], [xy, yy, yt], [xt, yt, tt]];
        let block = &mut matrix.blocks[slot as usize];
        for (column, values) in block.iter_mut().zip(rows) {
            for (entry, value) in column.iter_mut().zip(values) {
                *entry += value;
            }
        }
    }
}

/// The corner at which the support points of a disc stand: at the distance that gives the moment of an even pressure (two thirds
/// of the radius).
pub(crate) fn disc_corner(radius: f64) -> Point {
    let s = radius * 2.0 / 3.0 * std::f64::consts::FRAC_1_SQRT_2;
    Point::new(s, s)
}
