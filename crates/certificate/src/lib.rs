//! Exact, continuous proof that a plan holds every claim.
