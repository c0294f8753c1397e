/// How the interior point works. Budgets count iterations, so that results do not depend on the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Most iterations.
    pub max_iterations: usize,
    /// First barrier parameter.
    pub initial_mu: f64,
    /// The start is presumed to meet its constraints or nearly so, else every row begins on the central path.
    pub nearly_optimal: bool,
    /// Factor of the barrier parameter from one barrier problem to the next.
    pub barrier_decrease: f64,
    /// Summed complementarity at which the problem counts as solved, as a share of the cost.
    pub relative_gap: f64,
    /// Decrease that a full Newton step promises at which the problem counts as solved, as a share of the cost.
    pub relative_decrease: f64,
    /// Greatest residual of a constraint at which the problem counts as solved, m or rad.
    pub feasibility_tolerance: f64,
    /// Greatest residual after a solved problem has taken a last step or two, which do not count as iterations: see
    /// [`Settings::settled`].
    pub settled_tolerance: f64,
    /// Relative optimality residual ([`Residuals::relative`]) down to which a solved problem is polished, in iterations that
    /// count; where that takes too many, the solved problem is returned as it was. Infinite: not at all.
    ///
    /// [`Residuals::relative`]: crate::Residuals::relative
    pub tolerance: f64,
    /// Cost of a meter (or radian) of violation of an elastic constraint.
    pub elastic_weight: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            max_iterations: 300,
            initial_mu: 1.0,
            nearly_optimal: false,
            barrier_decrease: 0.1,
            relative_gap: 2e-4,
            relative_decrease: 1e-5,
            feasibility_tolerance: 1e-6,
            settled_tolerance: 1e-6,
            tolerance: f64::INFINITY,
            elastic_weight: 3e3,
        }
    }
}

impl Settings {
    /// For a start that is nearly optimal already, such as the plan before a small change of the scene.
    pub fn warm() -> Self {
        Self {
            initial_mu: 1e-4,
            nearly_optimal: true,
            ..Self::default()
        }
    }

    /// The same with a last step or two that bring residuals far below the tolerance, as a plan at any scale needs them:
    /// claims have absolute tolerances in m, down to 1e-6 m, which are tiny in units of a machine a thousand times the size of
    /// the paper's. What the bounds keep in reserve makes up for the rest.
    #[must_use]
    pub fn settled(self) -> Self {
        Self {
            settled_tolerance: 8e-8,
            ..self
        }
    }
}
