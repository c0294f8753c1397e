//! The terms of the paper's J in differentiable form, one a file. Smoothness is quadratic and lives in the assembly.

mod distance;
mod expansion;

pub use distance::Distance;
pub use expansion::Expansion;
