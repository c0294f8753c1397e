//! Linear forms of the unknowns: the velocity along two directions at a place that depends on few of them.

use crate::envelope::Envelope;
use pairtrawl_geometry::Point;

/// Two robots' three unknowns and two hinges' two each, at most, on either side of a contact.
const CAPACITY: usize = 12;

/// Two linear forms over the same unknowns.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Row {
    count: usize,
    unknowns: [usize; CAPACITY],
    along: [f64; CAPACITY],
    across: [f64; CAPACITY],
}

/// How the velocity of a place follows from the unknowns.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Tie {
    /// A hinge of its own: two unknowns.
    Free {
        /// The first of them.
        offset: usize,
    },
    /// A point of a body with three unknowns (velocity of its center of mass, turning rate).
    Held {
        /// The first of them.
        offset: usize,
        /// From the center of mass to the point.
        arm: Point,
    },
}

impl Tie {
    /// The velocity of the place.
    pub(crate) fn velocity(&self, u: &[f64]) -> Point {
        match *self {
            Self::Free { offset } => Point::new(u[offset], u[offset + 1]),
            Self::Held { offset, arm } => {
                Point::new(u[offset], u[offset + 1]) + arm.perp() * u[offset + 2]
            }
        }
    }
}

impl Row {
    /// Adds `along * velocity` and `across * velocity` of a tied place. Places of one row must not share unknowns.
    pub(crate) fn push(&mut self, tie: Tie, along: Point, across: Point) {
        let (offset, count) = match tie {
            Tie::Free { offset } => (offset, 2),
            Tie::Held { offset, .. } => (offset, 3),
        };
        let turn = match tie {
            Tie::Free { .. } => [0.0; 2],
            Tie::Held { arm, .. } => [arm.cross(along), arm.cross(across)],
        };
        let (a, b) = ([along.x, along.y, turn[0]], [across.x, across.y, turn[1]]);
        for k in 0..count {
            self.unknowns[self.count] = offset + k;
            self.along[self.count] = a[k];
            self.across[self.count] = b[k];
            self.count += 1;
        }
    }

    /// Adds to the first form only; unknowns may come again.
    pub(crate) fn merge(&mut self, unknown: usize, along: f64) {
        let known = self.unknowns[..self.count]
            .iter()
            .position(|&u| u == unknown);
        let at = known.unwrap_or(self.count);
        if at == self.count {
            self.unknowns[at] = unknown;
            self.count += 1;
        }
        self.along[at] += along;
    }

    /// As [`Self::merge`] with `along * velocity` of a tied place.
    pub(crate) fn merge_tied(&mut self, tie: Tie, along: Point) {
        match tie {
            Tie::Free { offset } => {
                self.merge(offset, along.x);
                self.merge(offset + 1, along.y);
            }
            Tie::Held { offset, arm } => {
                self.merge(offset, along.x);
                self.merge(offset + 1, along.y);
                self.merge(offset + 2, arm.cross(along));
            }
        }
    }

    /// The form `along + factor * across`.
    pub(crate) fn mixed(mut self, factor: f64) -> Self {
        for k in 0..self.count {
            self.along[k] += factor * self.across[k];
        }
        self
    }

    /// `sum of across^2 * weight(unknown)`.
    pub(crate) fn across_squared(&self, weight: impl Fn(usize) -> f64) -> f64 {
        (0..self.count)
            .map(|k| self.across[k] * self.across[k] * weight(self.unknowns[k]))
            .sum()
    }

    /// Both forms at `x`.
    pub(crate) fn at(&self, x: &[f64]) -> (f64, f64) {
        let (mut a, mut b) = (0.0, 0.0);
        for k in 0..self.count {
            let value = x[self.unknowns[k]];
            a += self.along[k] * value;
            b += self.across[k] * value;
        }
        (a, b)
    }

    /// `x += along * a + across * b` over the unknowns.
    pub(crate) fn spread(&self, a: f64, b: f64, x: &mut [f64]) {
        for k in 0..self.count {
            x[self.unknowns[k]] += self.along[k] * a + self.across[k] * b;
        }
    }

    /// Adds `a along along^T + b across across^T` to a matrix.
    pub(crate) fn square(&self, a: f64, b: f64, matrix: &mut Envelope) {
        for i in 0..self.count {
            let (ai, bi) = (self.along[i] * a, self.across[i] * b);
            for j in 0..=i {
                let value = ai * self.along[j] + bi * self.across[j];
                matrix.add(self.unknowns[i], self.unknowns[j], value);
            }
        }
    }
}

/// Adds a vector at a tied place to a vector of unknowns.
pub(crate) fn scatter(tie: Tie, value: Point, x: &mut [f64]) {
    match tie {
        Tie::Free { offset } => {
            x[offset] += value.x;
            x[offset + 1] += value.y;
        }
        Tie::Held { offset, arm } => {
            x[offset] += value.x;
            x[offset + 1] += value.y;
            x[offset + 2] += arm.cross(value);
        }
    }
}
