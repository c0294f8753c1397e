/// What computes the motion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Engine {
    /// The engine of this project: a chain and contacts in implicit steps (`pairtrawl-dynamics`).
    #[default]
    Implicit,
    /// rapier, a general engine of rigid bodies, in small steps.
    #[cfg(feature = "rapier")]
    Rapier(RapierSolver),
}

/// How often rapier iterates.
#[cfg(feature = "rapier")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RapierSolver {
    /// Solver iterations (substeps) per time step.
    pub iterations: usize,
    /// Gauss-Seidel sweeps over joints and contacts per solver iteration.
    pub sweeps: usize,
}

impl Engine {
    /// Longest time step, for a machine of the paper's size, s.
    pub(crate) fn longest_step(self) -> f64 {
        match self {
            Self::Implicit => 2e-2,
            #[cfg(feature = "rapier")]
            Self::Rapier(_) => 4e-3,
        }
    }
}
