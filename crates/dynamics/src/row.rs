//! Linear forms of the unknowns: the velocity along two directions at a place that depends on few parts.

use crate::block::{self, Triple};
use crate::matrix::Matrix;
use crate::pattern::Pattern;
use pairtrawl_geometry::Point;

/// Two parts on either side of a contact, at most.
const CAPACITY: usize = 4;

/// Two linear forms over the same parts, which are kept by ascending slot.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Row {
    count: usize,
    slots: [u32; CAPACITY],
    along: [Triple; CAPACITY],
    across: [Triple; CAPACITY],
    /// Where a matrix keeps the blocks of these parts, row by row of the lower triangle.
    blocks: [u32; CAPACITY * (CAPACITY + 1) / 2],
}

/// How the velocity of a place follows from the unknowns.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Tie {
    /// A hinge of its own.
    Free {
        /// Its slot.
        slot: u32,
    },
    /// A point of a body with three unknowns (velocity of its center of mass, turning rate).
    Held {
        /// The body's slot.
        slot: u32,
        /// From the center of mass to the point.
        arm: Point,
    },
}

impl Tie {
    /// The velocity of the place.
    pub(crate) fn velocity(&self, u: &[Triple]) -> Point {
        match *self {
            Self::Free { slot } => {
                let [x, y, _] = u[slot as usize];
                Point::new(x, y)
            }
            Self::Held { slot, arm } => {
                let [x, y, turn] = u[slot as usize];
                Point::new(x, y) + arm.perp() * turn
            }
        }
    }

    pub(crate) fn slot(&self) -> u32 {
        match *self {
            Self::Free { slot } | Self::Held { slot, .. } => slot,
        }
    }

    /// What a direction at the place means for the three unknowns.
    fn form(&self, direction: Point) -> Triple {
        let turn = match *self {
            Self::Free { .. } => 0.0,
            Self::Held { arm, .. } => arm.cross(direction),
        };
        [direction.x, direction.y, turn]
    }
}

impl Row {
    /// Adds `along * velocity` and `across * velocity` of a tied place.
    pub(crate) fn push(&mut self, tie: Tie, along: Point, across: Point) {
        self.add(tie.slot(), tie.form(along), tie.form(across));
    }

    /// Adds a multiple of the turning rate of a part to the first form.
    pub(crate) fn push_turn(&mut self, slot: u32, along: f64) {
        self.add(slot, [0.0, 0.0, along], [0.0; 3]);
    }

    fn add(&mut self, slot: u32, along: Triple, across: Triple) {
        let mut at = self.count;
        while at > 0 && self.slots[at - 1] > slot {
            at -= 1;
        }
        if at > 0 && self.slots[at - 1] == slot {
            for k in 0..3 {
                self.along[at - 1][k] += along[k];
                self.across[at - 1][k] += across[k];
            }
            return;
        }
        for k in (at..self.count).rev() {
            self.slots[k + 1] = self.slots[k];
            self.along[k + 1] = self.along[k];
            self.across[k + 1] = self.across[k];
        }
        self.slots[at] = slot;
        self.along[at] = along;
        self.across[at] = across;
        self.count += 1;
    }

    /// Looks up where a matrix keeps its blocks; all parts of the row are tied.
    pub(crate) fn locate(&mut self, pattern: &Pattern) {
        let mut k = 0;
        for i in 0..self.count {
            for j in 0..=i {
                self.blocks[k] = pattern.block(self.slots[i], self.slots[j]) as u32;
                k += 1;
            }
        }
    }

    /// The form `along + factor * across`.
    pub(crate) fn mixed(mut self, factor: f64) -> Self {
        for (along, across) in self.along.iter_mut().zip(&self.across).take(self.count) {
            for (a, b) in along.iter_mut().zip(across) {
                *a += factor * b;
            }
        }
        self
    }

    /// `sum of across^2 * weight(slot)`.
    pub(crate) fn across_squared(&self, weight: impl Fn(u32) -> Triple) -> f64 {
        let parts = self.slots.iter().zip(&self.across).take(self.count);
        let of_part = |(&slot, a): (&u32, &Triple)| {
            let w = weight(slot);
            a[0] * a[0] * w[0] + a[1] * a[1] * w[1] + a[2] * a[2] * w[2]
        };
        parts.map(of_part).sum()
    }

    /// Both forms at `x`.
    pub(crate) fn at(&self, x: &[Triple]) -> (f64, f64) {
        let (mut a, mut b) = (0.0, 0.0);
        for k in 0..self.count {
            let (value, along, across) =
                (&x[self.slots[k] as usize], &self.along[k], &self.across[k]);
            a += along[0] * value[0] + along[1] * value[1] + along[2] * value[2];
            b += across[0] * value[0] + across[1] * value[1] + across[2] * value[2];
        }
        (a, b)
    }

    /// `x += along * a + across * b` over the parts.
    pub(crate) fn spread(&self, a: f64, b: f64, x: &mut [Triple]) {
        for k in 0..self.count {
            let value = &mut x[self.slots[k] as usize];
            for ((v, along), across) in value.iter_mut().zip(&self.along[k]).zip(&self.across[k]) {
                *v += along * a + across * b;
            }
        }
    }

    /// Adds `a along along^T + b across across^T` to a matrix in which its blocks were located.
    pub(crate) fn square(&self, a: f64, b: f64, matrix: &mut Matrix) {
        let mut k = 0;
        for i in 0..self.count {
            let (along, across) = (self.along[i].map(|x| a * x), self.across[i].map(|x| b * x));
            for j in 0..=i {
                let block = &mut matrix.blocks[self.blocks[k] as usize];
                block::add_product(block, &along, &self.along[j]);
                if b != 0.0 {
                    block::add_product(block, &across, &self.across[j]);
                }
                k += 1;
            }
        }
    }
}

/// Adds a vector at a tied place to a vector of unknowns.
pub(crate) fn scatter(tie: Tie, value: Point, x: &mut [Triple]) {
    let form = tie.form(value);
    for (x, f) in x[tie.slot() as usize].iter_mut().zip(form) {
        *x += f;
    }
}
