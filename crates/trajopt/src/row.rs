//! One inequality of the interior point, `c(x) - s + e = 0`, with slack `s > 0`, elastic violation `0 <= e`, and multiplier `z`.
//!
//! Violation costs `weight * e`, so `0 < z < weight`, and `y = weight - z` is the multiplier of `e >= 0`:
//! `s z = mu`, `e y = mu` on the central path. An infinite weight makes the row hard (`e = 0`). Eliminating `s`, `e`, `z` from
//! the Newton system leaves `sigma grad grad^T - z hess` in the matrix.

use crate::merit::Merit;

/// Positive quantities keep the rest of their distance to zero in a step.
const FRACTION_TO_BOUNDARY: f64 = 0.99;

/// The multiplier of a bound that a step would run into too early rises by this many of its Newton steps: one is what the
/// bound's own stiffness asks for, and it has to stand up to that of everything else.
const RAISE: f64 = 4.0;

/// Least slack of a row at a start that is presumed to be nearly optimal, m or rad.
const LEAST_SLACK: f64 = 1e-5;

/// How rows begin: on the central path of `mu`, most at a price of `elastic` for a unit of violation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beginning {
    pub elastic: f64,
    pub mu: f64,
}

/// The longest step, at most 1, in which a positive value does not lose more than its share.
#[inline]
fn longest_step(value: f64, change: f64) -> f64 {
    if FRACTION_TO_BOUNDARY * value < -change {
        -FRACTION_TO_BOUNDARY * value / change
    } else {
        1.0
    }
}

/// The larger of two numbers; unlike `f64::max` a single instruction, since NaN need not be told from a number here.
#[inline]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The smaller of two numbers, likewise.
#[inline]
fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The state of a row.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Cost of a unit of violation; infinite for a hard row.
    pub weight: f64,
    /// Slack.
    pub s: f64,
    /// Elastic violation.
    pub e: f64,
    /// Multiplier.
    pub z: f64,
    /// The constraint's value at the iterate, or at the last trial point.
    pub c: f64,
    /// Directions of the last Newton step.
    pub ds: f64,
    /// See `ds`.
    pub de: f64,
    /// See `ds`.
    pub dz: f64,
    /// Its part of the condensed system.
    condensed: Condensed,
}

/// What a row contributes to the condensed system.
#[derive(Clone, Copy, Debug, Default)]
pub struct Condensed {
    /// Weight of `grad grad^T`.
    pub sigma: f64,
    /// Weight of `-grad` in the right-hand side's gradient: `z + sigma rho`.
    pub force: f64,
}

impl Row {
    /// A row on the central path of `mu` for a constraint of value `c`.
    pub fn centered(c: f64, weight: f64, mu: f64) -> Self {
        let mut row = Self {
            weight,
            s: 0.0,
            e: 0.0,
            z: 0.0,
            c,
            ds: 0.0,
            de: 0.0,
            dz: 0.0,
            condensed: Condensed::default(),
        };
        row.center(mu);
        row
    }

    /// Puts `s`, `e`, `z` on the central path of `mu` for the present value `c`.
    pub fn center(&mut self, mu: f64) {
        let (c, w) = (self.c, self.weight);
        if w.is_finite() {
            let root = (c * w * c * w + 4.0 * mu * mu).sqrt() + 2.0 * mu;
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

    /// A start for a point that is nearly optimal: slack as the constraint has it and hardly any violation, so that what is
    /// violated shows as a residual for the Newton steps to remove. (On the central path a constraint at its bound has half of
    /// `weight` for a multiplier, far more than it is worth.)
    pub fn presume_met(&mut self, mu: f64) {
        self.s = self.c.max(LEAST_SLACK);
        self.z = (mu / self.s).min(0.5 * self.weight);
        self.e = mu / self.y();
    }

    /// Multiplier of `e >= 0`.
    pub fn y(&self) -> f64 {
        self.weight - self.z
    }

    /// Residual `c - s + e`.
    pub fn residual(&self) -> f64 {
        self.c - self.s + self.e
    }

    /// The row's part of the condensed Newton system at barrier parameter `mu`; the row remembers it for [`Self::recover`].
    ///
    /// A hard row has `y` infinite and `e` zero, for which the same formulas hold.
    #[inline]
    pub fn condense(&mut self, mu: f64) -> Condensed {
        let (flex, give) = (1.0 / self.z, 1.0 / self.y());
        let sigma = 1.0 / (self.s * flex + self.e * give);
        let force = self.z + sigma * (mu * (flex - give) - self.c);
        self.condensed = Condensed { sigma, force };
        self.condensed
    }

    /// Computes `ds`, `de`, `dz` from the change `dc` of the linearized constraint.
    #[inline]
    pub fn recover(&mut self, mu: f64, dc: f64) {
        self.dz = self.condensed.force - self.z - self.condensed.sigma * dc;
        // The smaller of slack and violation by its own product, which keeps its digits; the other one by the sum.
        if self.s < self.e {
            self.ds = (mu - self.s * self.dz) / self.z - self.s;
            self.de = self.ds - dc - self.residual();
        } else {
            self.de = (mu + self.e * self.dz) / self.y() - self.e;
            self.ds = self.residual() + dc + self.de;
        }
    }

    /// Shrinks the common step length so that the slack keeps a share of its distance to zero.
    ///
    /// Violation and multiplier go their own lengths ([`Self::stepped`], [`Self::advance`]): they concern no other row, and
    /// one of thousands at its bound would hold up all.
    #[inline]
    pub fn limit_step(&self, longest: &mut f64) {
        *longest = smaller(*longest, longest_step(self.s, self.ds));
    }

    /// Takes the multiplier's step at once when the slack would end the primal step before `limit`; returns what that adds
    /// to the condensed system.
    ///
    /// A slack that shrinks too fast belongs to a bound that the Newton step does not feel yet: its multiplier is still small.
    #[inline]
    pub fn reinforce(&mut self, mu: f64, limit: f64) -> Option<Condensed> {
        let mut own = 1.0;
        self.limit_step(&mut own);
        if own >= limit || self.dz <= 0.0 {
            return None;
        }
        let before = self.condensed;
        let raise = RAISE * self.dz;
        self.z += longest_step(self.y(), -raise) * raise;
        let after = self.condense(mu);
        Some(Condensed {
            sigma: after.sigma - before.sigma,
            force: after.force - before.force,
        })
    }

    /// Slack and violation after a primal step of length `alpha` to where the constraint has value `c`: slack that the
    /// constraint does not need is given back at once.
    #[inline]
    pub fn stepped(&self, alpha: f64, c: f64) -> (f64, f64) {
        let e = larger(
            self.e + alpha * self.de,
            (1.0 - FRACTION_TO_BOUNDARY) * self.e,
        );
        (larger(self.s + alpha * self.ds, c + e), e)
    }

    /// Forgets the direction.
    pub fn rest(&mut self) {
        (self.ds, self.de, self.dz) = (0.0, 0.0, 0.0);
    }

    /// Takes the step to the last trial point, and as much of the dual step as keeps `z` and `y` positive.
    #[inline]
    pub fn advance(&mut self, alpha: f64) {
        (self.s, self.e) = self.stepped(alpha, self.c);
        let dual = smaller(
            longest_step(self.z, self.dz),
            longest_step(self.y(), -self.dz),
        );
        self.z += dual * self.dz;
    }

    /// Whether the row may give way.
    #[inline]
    fn gives_way(&self) -> bool {
        self.weight < f64::INFINITY
    }

    /// Adds cost of violation and logarithms at given `s` and `e` to a merit.
    #[inline]
    pub fn add_to(&self, merit: &mut Merit, s: f64, e: f64) {
        if self.gives_way() {
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
        if self.gives_way() {
            s + (self.weight - mu / self.e) * self.de
        } else {
            s
        }
    }

    /// How many complementarity products there are.
    #[inline]
    pub fn products(&self) -> usize {
        1 + usize::from(self.gives_way())
    }

    /// Greatest deviation of the complementarity products from `mu`, and their sum.
    #[inline]
    pub fn complementarity(&self, mu: f64) -> (f64, f64) {
        let sz = self.s * self.z;
        if self.gives_way() {
            let ey = self.e * self.y();
            (larger((sz - mu).abs(), (ey - mu).abs()), sz + ey)
        } else {
            ((sz - mu).abs(), sz)
        }
    }
}
