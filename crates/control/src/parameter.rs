use crate::Real;

/// A parameter that no controller can be built from.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "{name} is {value}, but it must be {bound}; choose another value or leave it at its default"
)]
pub struct ParameterError {
    /// The parameter's field.
    pub name: &'static str,
    /// What was given.
    pub value: f64,
    /// What is allowed, in words, with its unit.
    pub bound: &'static str,
}

/// Checks that a parameter is finite and above zero.
pub(crate) fn positive<T: Real>(name: &'static str, value: T) -> Result<(), ParameterError> {
    require(name, value, value > T::ZERO, "finite and above 0")
}

/// Checks that a parameter is finite and not below zero.
pub(crate) fn not_negative<T: Real>(name: &'static str, value: T) -> Result<(), ParameterError> {
    require(name, value, value >= T::ZERO, "finite and not below 0")
}

/// Checks that a parameter is finite and that a condition holds for it.
pub(crate) fn require<T: Real>(
    name: &'static str,
    value: T,
    holds: bool,
    bound: &'static str,
) -> Result<(), ParameterError> {
    if value.is_finite() && holds {
        Ok(())
    } else {
        Err(ParameterError {
            name,
            value: value.to_f64(),
            bound,
        })
    }
}
