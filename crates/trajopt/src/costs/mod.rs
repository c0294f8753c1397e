//! The terms of the paper's J that bend, in differentiable form. J_dist is linear in the coordinates of a step
//! (`step.rs`), J_s is quadratic and lives in the assembly.

mod expansion;

pub use expansion::Expansion;
