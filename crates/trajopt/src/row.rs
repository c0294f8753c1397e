//! One inequality of the interior point, `c(x) - s + e = 0`, with slack `s > 0`, elastic violation `0 <= e`, and multiplier `z`.
//!
//! Violation costs `weight * e`, so `0 < z < weight`, and `y = weight - z` is the multiplier of `e >= 0`:
//! `s z = mu`, `e y = mu` on the central path. An infinite weight makes the row hard (`e = 0`). Eliminating `s`, `e`, `z` from
//! the Newton system leaves `sigma grad grad^T - z hess` in the matrix.

use crate::merit::Merit;

/// Positive quantities keep the rest of their distance to zero in a step.
const FRACTION_TO_BOUNDARY: f64 = 0.99;

/// The longest step, at most 1, in which a positive value does not lose more than its share.
#[inline]
fn longest_step(value: f64, change: f64) -> f64 {
    if FRACTION_TO_BOUNDARY * value < -change {
        -FRACTION_TO_BOUNDARY * value / change
    } else {
        1.0
    }
}

/// The state of a row.
#[derive(Clone, Copy, Debug)]
pub struct Row<const K: usize> {
    /// Cost of a unit of violation; infinite for a hard row.
    pub weight: f64,
    /// Slack.
    pub s: f64,
    /// Elastic violation.
    pub e: f64,
    /// Multiplier.
    pub z: f64,
    /// The constraint's value at the iterate.
    pub c: f64,
    /// Its value at the last trial point.
    pub trial: f64,
    /// Its gradient at the iterate, in the row's local coordinates.
    pub gradient: [f64; K],
    /// Directions of the last Newton step.
    pub ds: f64,
    /// See `ds`.
    pub de: f64,
    /// See `ds`.
    pub dz: f64,
}

/// What a row contributes to the condensed system.
#[derive(Clone, Copy)]
pub struct Condensed {
    /// Weight of `grad grad^T`.
    pub sigma: f64,
    /// Weight of `-grad` in the right-hand side's gradient: `z + sigma rho`.
    pub force: f64,
}

impl<const K: usize> Row<K> {
    /// A row on the central path of `mu` for a constraint of value `c`.
    pub fn centered(c: f64, weight: f64, mu: f64) -> Self {
        let mut row = Self {
            weight,
            s: 0.0,
            e: 0.0,
            z: 0.0,
            c,
            trial: c,
            gradient: [0.0; K],
            ds: 0.0,
            de: 0.0,
            dz: 0.0,
        };
        row.center(mu);
        row
    }

    /// Puts `s`, `e`, `z` on the central path of `mu` for the present value `c`.
    pub fn center(&mut self, mu: f64) {
        let (c, w) = (self.c, self.weight);
        if w.is_finite() {
            let root = (c * w).hypot(2.0 * mu) + 2.0 * mu;
            if c >= 0.0 {
                self.z = 2.0 * mu * w / (root + c * w);
                self.e = mu / (w - self.z);
                self.s = self.e + c;
            } else {
                self.z = w - 2.0 * mu * w / (root - c * w);
                self.s = mu / self.z;
                self.e = self.s - c;
            }
        } else {
            self.s = c.max(1e-3);
            self.e = 0.0;
            self.z = mu / self.s;
        }
    }

    /// Multiplier of `e >= 0`.
    pub fn y(&self) -> f64 {
        self.weight - self.z
    }

    /// Residual `c - s + e`.
    pub fn residual(&self) -> f64 {
        self.c - self.s + self.e
    }

    /// Weight of `grad grad^T` in the condensed matrix.
    #[inline]
    pub fn sigma(&self) -> f64 {
        let flex = self.s / self.z;
        1.0 / if self.weight.is_finite() {
            flex + self.e / self.y()
        } else {
            flex
        }
    }

    /// The row's part of the condensed Newton system at barrier parameter `mu`, for a residual that may carry a
    /// second-order correction.
    #[inline]
    pub fn condense(&self, mu: f64, residual: f64) -> Condensed {
        let sigma = self.sigma();
        let mut rho = mu / self.z - self.s - residual;
        if self.weight.is_finite() {
            rho += self.e - mu / self.y();
        }
        Condensed {
            sigma,
            force: self.z + sigma * rho,
        }
    }

    /// Computes `ds`, `de`, `dz` from the change `dc` of the linearized constraint.
    #[inline]
    pub fn recover(&mut self, mu: f64, residual: f64, dc: f64) {
        let Condensed { sigma, force } = self.condense(mu, residual);
        self.dz = force - self.z - sigma * dc;
        self.ds = mu / self.z - self.s - self.s / self.z * self.dz;
        self.de = if self.weight.is_finite() {
            let y = self.y();
            mu / y - self.e + self.e / y * self.dz
        } else {
            0.0
        };
    }

    /// Shrinks the common step length so that the slack keeps a share of its distance to zero.
    ///
    /// Violation and multiplier go their own lengths ([`Self::stepped`], [`Self::advance`]): they concern no other row, and
    /// one of thousands at its bound would hold up all.
    #[inline]
    pub fn limit_step(&self, longest: &mut f64) {
        *longest = longest.min(longest_step(self.s, self.ds));
    }

    /// Slack and violation after a primal step of length `alpha` to where the constraint has value `c`: slack that the
    /// constraint does not need is given back at once.
    #[inline]
    pub fn stepped(&self, alpha: f64, c: f64) -> (f64, f64) {
        let e = (self.e + alpha * self.de).max((1.0 - FRACTION_TO_BOUNDARY) * self.e);
        ((self.s + alpha * self.ds).max(c + e), e)
    }

    /// Forgets the direction.
    pub fn rest(&mut self) {
        (self.ds, self.de, self.dz) = (0.0, 0.0, 0.0);
    }

    /// Takes the step to the last trial point, and as much of the dual step as keeps `z` and `y` positive.
    #[inline]
    pub fn advance(&mut self, alpha: f64) {
        self.c = self.trial;
        (self.s, self.e) = self.stepped(alpha, self.c);
        let mut dual = longest_step(self.z, self.dz);
        if self.weight.is_finite() {
            dual = dual.min(longest_step(self.y(), -self.dz));
        }
        self.z += dual * self.dz;
    }

    /// Adds cost of violation and logarithms at given `s` and `e` to a merit.
    #[inline]
    pub fn add_to(&self, merit: &mut Merit, s: f64, e: f64) {
        if self.weight.is_finite() {
            merit.elastic += self.weight * e;
            merit.logarithms.push(s * e);
        } else {
            merit.logarithms.push(s);
        }
    }

    /// Slope of the barrier function along the step.
    #[inline]
    pub fn barrier_slope(&self, mu: f64) -> f64 {
        let s = -mu * self.ds / self.s;
        if self.weight.is_finite() {
            s + (self.weight - mu / self.e) * self.de
        } else {
            s
        }
    }

    /// Greatest deviation of the complementarity products from `mu`, and their sum.
    #[inline]
    pub fn complementarity(&self, mu: f64) -> (f64, f64) {
        let sz = self.s * self.z;
        if self.weight.is_finite() {
            let ey = self.e * self.y();
            ((sz - mu).abs().max((ey - mu).abs()), sz + ey)
        } else {
            ((sz - mu).abs(), sz)
        }
    }
}
