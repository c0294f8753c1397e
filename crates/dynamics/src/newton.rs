//! Newton's method for the velocities at the end of a step.
//!
//! The momentum that is left over at velocities u, `A u - c` and what the terms add, is the gradient of a convex function. Each
//! iteration solves a linear system for the direction in which the terms' present state (what slides, sticks, pushes) would be
//! balanced. Where the force along the direction turns around before its end, the step ends where it does (regula falsi); looking
//! for that place takes numbers only, one or two for each term. The first iteration takes the states of the step before for
//! granted: while they last, it is the only one.

use crate::block::Triple;
use crate::factor::Factor;
use crate::matrix::Matrix;
use crate::pattern::Pattern;
use crate::work::{Stage, Stopwatch, Work};

/// A step is solved when no part is left with more force than this, in units of the machine's force.
const TOLERANCE: f64 = 1e-4;
/// A torque counts as the force on this arm, in units of the machine's length.
const ARM: f64 = 0.05;
/// Linear systems per step at most.
const ITERATIONS: usize = 40;
/// Shortenings of a Newton step at most.
const SHORTENINGS: usize = 16;
/// A Newton step is shortened when the force along it turns around and is more than this part of what it was.
const OVERSHOOT: f64 = 0.3;

/// What acts besides what is linear in the velocities.
pub(crate) trait Terms {
    /// Looks at the velocities `u`, at which a step begins.
    fn begin(&mut self, u: &[Triple]);

    /// Looks at the direction of a search.
    fn direct(&mut self, direction: &[Triple]);

    /// Minus the power of the impulses along the direction `d`, at `u + length d`.
    fn slope(&self, u: &[Triple], d: &[Triple], length: f64) -> f64;

    /// Goes so far along the direction.
    fn advance(&mut self, length: f64);

    /// Adds minus the impulses at the velocities `u` to the gradient. At the `first` look states are those of the step before.
    fn evaluate(&mut self, first: bool, u: &[Triple], gradient: &mut [Triple]);

    /// Adds the derivative at the last evaluation.
    fn add_stiffness(&self, matrix: &mut Matrix);
}

/// The linear system of a step and its unknowns, kept from step to step so that nothing is allocated.
#[derive(Clone, Debug, Default)]
pub(crate) struct System {
    /// A: what is linear.
    pub(crate) linear: Matrix,
    /// c.
    pub(crate) constant: Vec<Triple>,
    /// The velocities: a guess before, the solution after.
    pub(crate) u: Vec<Triple>,
    matrix: Matrix,
    factor: Factor,
    /// A u - c.
    balance: Vec<Triple>,
    /// The balance and minus the impulses of the terms.
    gradient: Vec<Triple>,
    direction: Vec<Triple>,
    /// A times the direction.
    product: Vec<Triple>,
}

impl System {
    /// Zero, on a pattern, which may be a `new` one.
    pub(crate) fn reset(&mut self, pattern: &Pattern, new: bool) {
        if new {
            self.factor.reset();
        }
        self.linear.reset(pattern);
        for list in [
            &mut self.u,
            &mut self.constant,
            &mut self.balance,
            &mut self.gradient,
            &mut self.direction,
            &mut self.product,
        ] {
            list.clear();
            list.resize(pattern.size(), [0.0; 3]);
        }
    }

    /// Finds the velocities; the terms are then those of the solution.
    pub(crate) fn solve(
        &mut self,
        pattern: &Pattern,
        terms: &mut impl Terms,
        dt: f64,
        (work, watch): (&mut Work, &mut Stopwatch),
    ) {
        self.linear.multiply(pattern, &self.u, &mut self.balance);
        add(&mut self.balance, -1.0, &self.constant);
        terms.begin(&self.u);
        self.evaluate(terms, true);
        for iteration in 0..ITERATIONS {
            self.matrix.copy_from(&self.linear);
            terms.add_stiffness(&mut self.matrix);
            watch.ends(Stage::Matrices, work);
            work.systems += 1;
            work.products += self.factor.update(pattern, &self.matrix);
            watch.ends(Stage::Factors, work);
            for (d, g) in self.direction.iter_mut().zip(&self.gradient) {
                *d = g.map(|g| -g);
            }
            self.factor.solve(pattern, &mut self.direction);
            watch.ends(Stage::Solutions, work);
            terms.direct(&self.direction);
            let along = &self.direction;
            self.linear.multiply(pattern, along, &mut self.product);
            let length = if iteration == 0 {
                1.0
            } else {
                self.search(terms, work)
            };
            add(&mut self.u, length, &self.direction);
            add(&mut self.balance, length, &self.product);
            terms.advance(length);
            self.evaluate(terms, false);
            watch.ends(Stage::Searches, work);
            if self.residual() <= TOLERANCE * dt {
                return;
            }
        }
        work.unconverged += 1;
    }

    /// How far to go along the direction.
    fn search(&self, terms: &impl Terms, work: &mut Work) -> f64 {
        let slope = dot(&self.direction, &self.gradient);
        let linear = dot(&self.direction, &self.balance);
        let rise = dot(&self.direction, &self.product);
        let mut length = 1.0;
        let (mut low, mut low_slope) = (0.0, slope);
        let mut high: Option<(f64, f64)> = None;
        for _ in 0..SHORTENINGS {
            work.looks += 1;
            let of_terms = terms.slope(&self.u, &self.direction, length);
            let now = linear + length * rise + of_terms;
            if now.abs() <= OVERSHOOT * slope.abs() || (length >= 1.0 && now < 0.0) {
                break;
            }
            if now > 0.0 {
                high = Some((length, now));
                low_slope *= 0.5;
            } else {
                (low, low_slope) = (length, now);
                high = high.map(|(far, far_slope)| (far, 0.5 * far_slope));
            }
            let Some((far, far_slope)) = high else { break };
            // Where a straight line through both slopes is zero; an end that stays counts half (Illinois).
            let part = (low_slope / (low_slope - far_slope)).clamp(0.01, 0.99);
            length = low + part * (far - low);
        }
        length
    }

    /// The gradient at `u`.
    fn evaluate(&mut self, terms: &mut impl Terms, first: bool) {
        self.gradient.copy_from_slice(&self.balance);
        terms.evaluate(first, &self.u, &mut self.gradient);
    }

    /// Greatest impulse that is left over.
    fn residual(&self) -> f64 {
        let of_part = |&[x, y, turn]: &Triple| x.abs().max(y.abs()).max(turn.abs() / ARM);
        self.gradient.iter().map(of_part).fold(0.0, f64::max)
    }
}

/// `x += factor * y`.
fn add(x: &mut [Triple], factor: f64, y: &[Triple]) {
    for (x, y) in x.as_flattened_mut().iter_mut().zip(y.as_flattened()) {
        *x += factor * y;
    }
}

fn dot(a: &[Triple], b: &[Triple]) -> f64 {
    let pairs = a.as_flattened().iter().zip(b.as_flattened());
    pairs.map(|(x, y)| x * y).sum()
}
