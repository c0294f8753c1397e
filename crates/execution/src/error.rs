use pairtrawl_control::ParameterError;
use pairtrawl_model::Claim;
use pairtrawl_reference::ReferenceError;
use pairtrawl_simulation::SimulationError;
use thiserror::Error;

/// Why a plan cannot be executed. A drive that goes wrong is a result, not an error.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ExecutionError {
    /// The plan does not hold what it must.
    #[error(
        "the plan cannot be proven: {} fails; plan the scene again, or ask for a drive of an unproven plan",
        names(claims)
    )]
    Unproven {
        /// The claims that fail.
        claims: Vec<Claim>,
    },
    /// The plan cannot become a reference.
    #[error(transparent)]
    Reference(#[from] ReferenceError),
    /// A controller cannot be built.
    #[error(transparent)]
    Controller(#[from] ParameterError),
    /// The world cannot be simulated.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
    /// An option is out of its range.
    #[error("execution option {name} is {value}, but it must be {bound}: choose another value")]
    Option {
        /// Its name.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        bound: &'static str,
    },
}

fn names(claims: &[Claim]) -> String {
    let names: Vec<_> = claims.iter().map(|claim| claim.id.name()).collect();
    names.join(", ")
}
