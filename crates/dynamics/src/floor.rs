//! Friction of an object on the floor: four support points, each with a quarter of the weight.

use crate::block::Triple;
use crate::friction::CREEP;
use crate::matrix::Matrix;
use pairtrawl_geometry::Point;

/// Support points of an object and their part in the system of a step. What is computed for all four is kept by coordinate, so that the
/// processor computes several at once.
#[derive(Clone, Debug)]
pub(crate) struct Supports {
    /// In the body frame.
    places: [Point; 4],
    /// mu m g / 4, N.
    limit: f64,
    arms: Four,
    velocities: Four,
    /// Force over speed, at the iterate, N s/m.
    weights: [f64; 4],
    /// 1 for points that move, 0 for those that are held.
    moves: [f64; 4],
}

/// Four vectors.
#[derive(Clone, Copy, Debug, Default)]
struct Four {
    x: [f64; 4],
    y: [f64; 4],
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
            arms: Four::default(),
            velocities: Four::default(),
            weights: [0.0; 4],
            moves: [1.0; 4],
        }
    }

    /// At the beginning of a step.
    pub(crate) fn begin(&mut self, axis: Point) {
        for (k, p) in self.places.iter().enumerate() {
            self.arms.x[k] = axis.x * p.x - axis.y * p.y;
            self.arms.y[k] = axis.y * p.x + axis.x * p.y;
        }
    }

    /// What the points move at when the object moves at `u`, and how fast.
    fn velocities(&self, u: &Triple) -> (Four, [f64; 4]) {
        let (mut v, mut speeds) = (Four::default(), [0.0; 4]);
        for (k, speed) in speeds.iter_mut().enumerate() {
            v.x[k] = u[0] - self.arms.y[k] * u[2];
            v.y[k] = u[1] + self.arms.x[k] * u[2];
            *speed = (v.x[k] * v.x[k] + v.y[k] * v.y[k]).sqrt();
        }
        (v, speeds)
    }

    /// Adds minus the floor's impulses at the velocities `u` of the object to its gradient. At the `first` look what was held before
    /// is held.
    pub(crate) fn evaluate(&mut self, dt: f64, first: bool, u: &Triple, gradient: &mut Triple) {
        let (velocities, speeds) = self.velocities(u);
        self.velocities = velocities;
        let mut sum = [0.0; 3];
        for (k, speed) in speeds.into_iter().enumerate() {
            let held = speed < CREEP || (first && self.moves[k] == 0.0);
            self.moves[k] = if held { 0.0 } else { 1.0 };
            self.weights[k] = self.limit / if held { CREEP } else { speed };
            let (x, y) = (
                self.weights[k] * self.velocities.x[k],
                self.weights[k] * self.velocities.y[k],
            );
            sum[0] += x;
            sum[1] += y;
            sum[2] += self.arms.x[k] * y - self.arms.y[k] * x;
        }
        for (g, value) in gradient.iter_mut().zip(sum) {
            *g += dt * value;
        }
    }

    /// Minus the power of the floor's impulses along the direction `d`, at the velocities `u`.
    pub(crate) fn slope(&self, dt: f64, u: &Triple, d: &Triple) -> f64 {
        let (v, speeds) = self.velocities(u);
        let mut powers = [0.0; 4];
        for (k, power) in powers.iter_mut().enumerate() {
            let (x, y) = (d[0] - self.arms.y[k] * d[2], d[1] + self.arms.x[k] * d[2]);
            *power = (v.x[k] * x + v.y[k] * y) * (self.limit / speeds[k].max(CREEP));
        }
        dt * ((powers[0] + powers[1]) + (powers[2] + powers[3]))
    }

    /// Adds the derivative of [`Self::evaluate`]'s terms: for a point that is held its weight in all directions, for one that moves
    /// the same but along its motion.
    pub(crate) fn add_stiffness(&self, dt: f64, slot: u32, matrix: &mut Matrix) {
        let (mut xx, mut xy, mut yy) = ([0.0; 4], [0.0; 4], [0.0; 4]);
        for k in 0..4 {
            let (x, y, weight) = (self.velocities.x[k], self.velocities.y[k], self.weights[k]);
            let along = weight * self.moves[k] / (x * x + y * y).max(CREEP * CREEP);
            xx[k] = weight - along * x * x;
            xy[k] = -along * x * y;
            yy[k] = weight - along * y * y;
        }
        let mut sum = [0.0; 6];
        for k in 0..4 {
            // The turning rate moves the point along n.
            let n = (-self.arms.y[k], self.arms.x[k]);
            let turn = (xx[k] * n.0 + xy[k] * n.1, xy[k] * n.0 + yy[k] * n.1);
            sum[0] += xx[k];
            sum[1] += xy[k];
            sum[2] += yy[k];
            sum[3] += turn.0;
            sum[4] += turn.1;
            sum[5] += n.0 * turn.0 + n.1 * turn.1;
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
