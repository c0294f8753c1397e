//! Linear algebra of the stage structure: a banded Cholesky factorization.

mod band;

pub use band::BandMatrix;
