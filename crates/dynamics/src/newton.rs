//! Newton's method for the velocities at the end of a step.
//!
//! The momentum that is left over at velocities u, `A u - c` and what the terms add, is the gradient of a convex function. Each
//! iteration solves a linear system for the direction in which the terms' present state (what slides, sticks, pushes) would be
//! balanced. Where the force along the direction turns around before its end, the step ends where it does (regula falsi). The
//! first iteration takes the states of the step before for granted: while they last, it is the only one.

use crate::envelope::Envelope;

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
    /// Adds minus the impulses at the velocities `u` to the gradient. At the `first` look states are those of the step before.
    fn evaluate(&mut self, first: bool, u: &[f64], gradient: &mut [f64]);

    /// Adds the derivative at the last evaluation.
    fn add_stiffness(&self, matrix: &mut Envelope);
}

/// The linear system of a step and its unknowns, kept from step to step so that nothing is allocated.
#[derive(Clone, Debug, Default)]
pub(crate) struct System {
    /// A: what is linear.
    pub(crate) linear: Envelope,
    /// c.
    pub(crate) constant: Vec<f64>,
    /// The velocities: a guess before, the solution after.
    pub(crate) u: Vec<f64>,
    /// Which unknowns are turning rates.
    pub(crate) turning: Vec<bool>,
    matrix: Envelope,
    trial: Vec<f64>,
    gradient: Vec<f64>,
    direction: Vec<f64>,
}

/// How a step was solved.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome {
    /// Linear systems.
    pub(crate) systems: u64,
    /// The tolerance was met.
    pub(crate) solved: bool,
}

impl System {
    /// Zero, with these first columns of the rows.
    pub(crate) fn reset(&mut self, first_columns: &[usize]) {
        self.linear.reset(first_columns);
        for list in [
            &mut self.u,
            &mut self.trial,
            &mut self.constant,
            &mut self.gradient,
            &mut self.direction,
        ] {
            list.clear();
            list.resize(first_columns.len(), 0.0);
        }
        self.turning.clear();
        self.turning.resize(first_columns.len(), false);
    }

    /// Finds the velocities; the terms are then those of the solution.
    pub(crate) fn solve(&mut self, terms: &mut impl Terms, dt: f64) -> Outcome {
        self.evaluate(terms, true);
        for iteration in 0..ITERATIONS {
            self.matrix.copy_from(&self.linear);
            terms.add_stiffness(&mut self.matrix);
            self.matrix.factor();
            for (d, g) in self.direction.iter_mut().zip(&self.gradient) {
                *d = -g;
            }
            self.matrix.solve(&mut self.direction);
            self.search(terms, iteration == 0);
            std::mem::swap(&mut self.u, &mut self.trial);
            if self.residual() <= TOLERANCE * dt {
                return Outcome {
                    systems: iteration as u64 + 1,
                    solved: true,
                };
            }
        }
        Outcome {
            systems: ITERATIONS as u64,
            solved: false,
        }
    }

    /// How far to go along the direction: `trial` and its gradient.
    fn search(&mut self, terms: &mut impl Terms, whole: bool) {
        let slope = dot(&self.direction, &self.gradient);
        let mut length = 1.0;
        let (mut low, mut low_slope) = (0.0, slope);
        let mut high: Option<(f64, f64)> = None;
        for _ in 0..SHORTENINGS {
            for ((t, u), d) in self.trial.iter_mut().zip(&self.u).zip(&self.direction) {
                *t = u + length * d;
            }
            std::mem::swap(&mut self.u, &mut self.trial);
            self.evaluate(terms, false);
            std::mem::swap(&mut self.u, &mut self.trial);
            let now = dot(&self.direction, &self.gradient);
            if whole || now.abs() <= OVERSHOOT * slope.abs() || (length >= 1.0 && now < 0.0) {
                return;
            }
            if now > 0.0 {
                high = Some((length, now));
                low_slope *= 0.5;
            } else {
                (low, low_slope) = (length, now);
                high = high.map(|(far, far_slope)| (far, 0.5 * far_slope));
            }
            let Some((far, far_slope)) = high else { return };
            // Where a straight line through both slopes is zero; an end that stays counts half (Illinois).
            let part = (low_slope / (low_slope - far_slope)).clamp(0.01, 0.99);
            length = low + part * (far - low);
        }
    }

    /// The gradient at `u`.
    fn evaluate(&mut self, terms: &mut impl Terms, first: bool) {
        self.linear.multiply(&self.u, &mut self.gradient);
        for (g, c) in self.gradient.iter_mut().zip(&self.constant) {
            *g -= c;
        }
        terms.evaluate(first, &self.u, &mut self.gradient);
    }

    /// Greatest impulse that is left over.
    fn residual(&self) -> f64 {
        let weigh = |(g, turns): (&f64, &bool)| if *turns { g.abs() / ARM } else { g.abs() };
        let impulses = self.gradient.iter().zip(&self.turning).map(weigh);
        impulses.fold(0.0, f64::max)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
