//! What a line search compares: violation, and the barrier function by its parts; and what says that a point is optimal.

/// Merit of a point.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Merit {
    /// Sum of all residuals.
    pub theta: f64,
    /// Objective.
    pub cost: f64,
    /// Cost of elastic violations.
    pub elastic: f64,
    /// That of all rows but those of turning, whose violation is no violation but its cost.
    pub violation: f64,
    /// Of all slacks and violations.
    pub logarithms: LogarithmSum,
}

impl Merit {
    /// Barrier function at barrier parameter `mu`.
    pub fn phi(&self, mu: f64) -> f64 {
        self.cost + self.elastic - mu * self.logarithms.sum()
    }
}

/// A sum of logarithms by way of products: few logarithms are taken.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LogarithmSum {
    sum: f64,
    product: f64,
}

impl Default for LogarithmSum {
    fn default() -> Self {
        Self {
            sum: 0.0,
            product: 1.0,
        }
    }
}

impl LogarithmSum {
    /// Adds the logarithm of a positive number; of anything else the sum becomes NaN.
    #[inline]
    pub fn push(&mut self, value: f64) {
        let product = self.product * value;
        if (1e-200..1e200).contains(&product) {
            self.product = product;
        } else {
            self.sum += libm::log(self.product) + libm::log(value);
            self.product = 1.0;
        }
    }

    /// The sum.
    pub fn sum(&self) -> f64 {
        self.sum + libm::log(self.product)
    }
}

/// Measures of optimality at an iterate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Residuals {
    /// Largest entry of the Lagrangian's gradient, as a share of the largest entry of the objective's gradient.
    pub dual: f64,
    /// Largest violation of `c - s + e = 0` and of the equalities.
    pub primal: f64,
    /// Largest deviation of a complementarity product from the barrier parameter.
    pub complementarity: f64,
    /// Sum of all complementarity products: bounds the cost above the optimum.
    pub gap: f64,
    /// How many products that are.
    pub products: usize,
}

impl Residuals {
    /// The relative optimality residual at an objective of value `cost`: the largest of the dual residual, of the primal one
    /// (m or rad, in units of the length scale), and of the gap as a share of the cost.
    pub fn relative(&self, cost: f64) -> f64 {
        (self.dual.max(self.primal)).max(self.gap / cost.abs().max(1.0))
    }
}
