//! Numbers that all claims and proofs are judged by.

/// Bounds hold to this much unless the file format says otherwise, in the claim's own unit.
pub const TOLERANCE: f64 = 1e-9;

/// Coordinates beyond this are refused, m: above it a double no longer resolves the tolerance of 1e-9 m.
pub const COORDINATE_LIMIT: f64 = 1e6;

/// What is not yet settled below this much is left open, m: the endpoints' tolerance and the rounding of distances.
pub(crate) const CAUTION: f64 = 1e-5;
