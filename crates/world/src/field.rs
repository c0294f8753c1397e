use crate::grid::{OccupancyGrid, Owners};
use pairtrawl_geometry::{Convex, Point};

/// Signed distance to the nearest obstacle, m: positive outside, negative inside.
///
/// Samples at the cell centers: the distance transform finds the nearest shapes, and the distance to them is exact. Between
/// the centers: the Catmull-Rom bicubic, which takes the samples' values, has
/// continuous first derivatives everywhere and is exact for planes. Beyond the grid it goes on linearly.
#[derive(Clone, Debug, PartialEq)]
pub struct DistanceField {
    /// Outer corner of the first cell, and the unit vector along the grid's rows, map frame.
    corner: Point,
    axis: Point,
    resolution: f64,
    columns: usize,
    rows: usize,
    samples: Vec<f64>,
}

impl DistanceField {
    pub(crate) fn new(grid: &OccupancyGrid, owners: &Owners, pieces: &[Convex]) -> Self {
        let samples = crate::samples::signed_distances(grid, owners, pieces);
        Self {
            corner: grid.origin.position(),
            axis: grid.axis(),
            resolution: grid.resolution,
            columns: grid.columns,
            rows: grid.rows,
            samples,
        }
    }

    /// Distance from the nearest obstacle at a map-frame point, m. NaN for a point that is not finite.
    pub fn distance(&self, p: Point) -> f64 {
        self.distance_and_gradient(p).0
    }

    /// Distance, m, and its gradient (exact derivative of the interpolation, 1), both in the map frame.
    pub fn distance_and_gradient(&self, p: Point) -> (f64, Point) {
        if !p.is_finite() {
            return (f64::NAN, Point::new(f64::NAN, f64::NAN));
        }
        let Point { x: cos, y: sin } = self.axis;
        let d = (p - self.corner) / self.resolution;
        let (column, wx, dx) = weights(cos * d.x + sin * d.y - 0.5);
        let (row, wy, dy) = weights(cos * d.y - sin * d.x - 0.5);
        let (mut value, mut along_x, mut along_y) = (0.0, 0.0, 0.0);
        for j in 0..4 {
            let line: [f64; 4] =
                std::array::from_fn(|i| self.sample(column + i as i64 - 1, row + j as i64 - 1));
            let across = dot(&wx, &line);
            value += wy[j] * across;
            along_x += wy[j] * dot(&dx, &line);
            along_y += dy[j] * across;
        }
        let gradient = Point::new(cos * along_x - sin * along_y, sin * along_x + cos * along_y)
            / self.resolution;
        (value, gradient)
    }

    /// The sample at a cell center, continued linearly beyond the border.
    fn sample(&self, column: i64, row: i64) -> f64 {
        let (c, beyond_c) = inward(column, self.columns);
        let (r, beyond_r) = inward(row, self.rows);
        let at = |c: usize, r: usize| self.samples[r * self.columns + c];
        let here = at(c, r);
        if beyond_c == 0.0 && beyond_r == 0.0 {
            return here;
        }
        let back_c = if c == 0 {
            1.min(self.columns - 1)
        } else {
            c - 1
        };
        let back_r = if r == 0 { 1.min(self.rows - 1) } else { r - 1 };
        here + beyond_c * (here - at(back_c, r)) + beyond_r * (here - at(c, back_r))
    }
}

/// The index brought into `0..n`, and by how much it lay outside.
fn inward(i: i64, n: usize) -> (usize, f64) {
    let inside = i.clamp(0, n as i64 - 1);
    (inside as usize, (i as f64 - inside as f64).abs())
}

/// Catmull-Rom: the node left of u, the weights of the nodes from one before it to two after it, and their derivatives.
fn weights(u: f64) -> (i64, [f64; 4], [f64; 4]) {
    // Far beyond the grid the sums would overflow; nothing is that far.
    let u = u.clamp(-1e9, 1e9);
    let node = u.floor();
    let t = u - node;
    let (t2, t3) = (t * t, t * t * t);
    let w = [
        0.5 * (2.0 * t2 - t - t3),
        0.5 * (3.0 * t3 - 5.0 * t2 + 2.0),
        0.5 * (4.0 * t2 - 3.0 * t3 + t),
        0.5 * (t3 - t2),
    ];
    let d = [
        0.5 * (4.0 * t - 1.0 - 3.0 * t2),
        0.5 * (9.0 * t2 - 10.0 * t),
        0.5 * (8.0 * t - 9.0 * t2 + 1.0),
        0.5 * (3.0 * t2 - 2.0 * t),
    ];
    (node as i64, w, d)
}

fn dot(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
