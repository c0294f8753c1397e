//! Rolling without slip: A(q) q_dot = 0 (eq. 16) and q_dot = S(q) v (eqs. 18, 19).
//!
//! `offset` is the paper's d in A and S: how far the reference point lies ahead of the axle, m. Plans use the axle center,
//! offset 0.

use crate::{Real, Velocity};

/// A(q), eq. 16: the row with A q_dot = 0.
pub fn constraint_row<T: Real>(heading: T, offset: T) -> [T; 3] {
    let (sin, cos) = heading.sine_cosine();
    [-sin, cos, -offset]
}

/// S(q), eq. 18: a basis of the null space of A, rows x, y, phi and columns nu, omega.
pub fn null_basis<T: Real>(heading: T, offset: T) -> [[T; 2]; 3] {
    let (sin, cos) = heading.sine_cosine();
    [[cos, -offset * sin], [sin, offset * cos], [T::ZERO, T::ONE]]
}

/// S_dot(q): the time derivative of [`null_basis`] at a turning rate in rad/s.
pub fn null_basis_rate<T: Real>(heading: T, rate: T, offset: T) -> [[T; 2]; 3] {
    let (sin, cos) = heading.sine_cosine();
    [
        [-rate * sin, -rate * offset * cos],
        [rate * cos, -rate * offset * sin],
        [T::ZERO, T::ZERO],
    ]
}

/// q_dot = S(q) v, eq. 19, in m/s, m/s and rad/s.
pub fn pose_rate<T: Real>(heading: T, velocity: Velocity<T>, offset: T) -> [T; 3] {
    null_basis(heading, offset).map(|[a, b]| a * velocity.linear + b * velocity.angular)
}
