//! The paper's baseline, eq. 22: tau_bar = M_bar v_d_dot + C_bar v_d.
//!
//! No feedback of the velocity error: with k1 the only feedback along the path is through v_d_dot, which holds the
//! velocity, not the position. A constant unknown drag F leaves a velocity error F / (m k1), so the position drifts without
//! end. That is how the paper reports it, and why it is kept as printed.

use crate::{BodyForce, Desired, Real, RobotModel};

/// tau_bar of eq. 22 at a heading and a measured turning rate, rad and rad/s.
pub fn model_based_force<T: Real>(
    model: &RobotModel<T>,
    desired: &Desired<T>,
    heading: T,
    rate: T,
) -> BodyForce<T> {
    let reduced = model.reduced(heading, rate);
    let (v, a) = (desired.velocity, desired.acceleration);
    let row = |m: [T; 2], c: [T; 2]| {
        m[0] * a.linear + m[1] * a.angular + c[0] * v.linear + c[1] * v.angular
    };
    BodyForce {
        force: row(reduced.inertia[0], reduced.coriolis[0]),
        torque: row(reduced.inertia[1], reduced.coriolis[1]),
    }
}
