//! The tracking law, eqs. 23 and 24: from the pose error to a desired velocity v_d, and its derivative in closed form.
//!
//! Errors are turned into the robot's frame (printed in the world frame, which converges near phi = 0 only), so that
//!
//! - e_x_dot = omega e_y - nu + nu_r cos e_phi
//! - e_y_dot = -omega e_x + nu_r sin e_phi
//! - e_phi_dot = omega_r - omega
//!
//! With nu = nu_r cos e_phi + k1 e_x and V = (e_x^2 + e_y^2)/2 + (1 - cos e_phi)/k2, V_dot is for nu_r >= 0
//!
//! | form | omega_d - omega_r | V_dot |
//! |---|---|---|
//! | `HeadingAlways` (default) | k2 nu_r e_y + k3 sin e_phi | -k1 e_x^2 - (k3/k2) sin^2 e_phi |
//! | `Printed` | k2 nu_r (e_y + k3 nu_r sin e_phi) | -k1 e_x^2 - k3 nu_r^2 sin^2 e_phi |
//! | `Usual` | nu_r (k2 e_y + k3 sin e_phi) | -k1 e_x^2 - (k3/k2) nu_r sin^2 e_phi |
//!
//! Only the default turns a robot that stands still (nu_r = 0) to its reference heading.

use crate::parameter::positive;
use crate::{ParameterError, Pose, Real, ReferenceSample, Velocity};

/// Where the heading error enters omega_d.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TrackingForm {
    /// k2 nu_r e_y + k3 sin e_phi; k3 in 1/s.
    #[default]
    HeadingAlways,
    /// The printed bracket, k2 nu_r (e_y + k3 nu_r sin e_phi); k3 in s.
    Printed,
    /// nu_r (k2 e_y + k3 sin e_phi), as in the literature; k3 in 1/m.
    Usual,
}

/// Gains of eq. 23.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackingGains<T> {
    /// k1, 1/s: how fast an error along the path vanishes. Range 0.3 to 3.
    pub along: T,
    /// k2, 1/m^2: at speed nu the error across behaves like s^2 + k3 s + k2 nu^2. Range 5 to 80.
    pub across: T,
    /// k3, unit by [`TrackingForm`]. Range 1 to 6 1/s in the default form.
    pub heading: T,
    /// Where k3 enters.
    pub form: TrackingForm,
    /// d of eq. 23, m: poses and reference lie this far ahead of the axle. 0 for plans.
    pub offset: T,
}

impl<T: Real> Default for TrackingGains<T> {
    fn default() -> Self {
        Self {
            along: T::of(1.5),
            across: T::of(40.0),
            heading: T::of(3.0),
            form: TrackingForm::HeadingAlways,
            offset: T::ZERO,
        }
    }
}

impl<T: Real> TrackingGains<T> {
    /// Checks that gains are finite and above zero.
    ///
    /// # Errors
    /// Names the first gain that is not.
    pub fn validate(&self) -> Result<(), ParameterError> {
        positive("tracking.along (k1)", self.along)?;
        positive("tracking.across (k2)", self.across)?;
        positive("tracking.heading (k3)", self.heading)?;
        crate::parameter::not_negative("tracking.offset (d)", self.offset)
    }
}

/// e of eq. 24 in the robot's frame, moved to the axle when poses lie d ahead of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrackingError<T> {
    /// e_x: the reference lies this far ahead, m.
    pub along: T,
    /// e_y: the reference lies this far to the left, m.
    pub across: T,
    /// sin e_phi.
    pub sin_heading: T,
    /// cos e_phi.
    pub cos_heading: T,
}

impl<T: Real> TrackingError<T> {
    /// The error of a pose against a reference pose; both `offset` ahead of the axle, m.
    pub fn between(pose: &Pose<T>, reference: &Pose<T>, offset: T) -> Self {
        let (sin, cos) = pose.heading.sine_cosine();
        let (dx, dy) = (reference.x - pose.x, reference.y - pose.y);
        let (sin_heading, cos_heading) = (reference.heading - pose.heading).sine_cosine();
        Self {
            along: cos * dx + sin * dy + offset * (T::ONE - cos_heading),
            across: cos * dy - sin * dx - offset * sin_heading,
            sin_heading,
            cos_heading,
        }
    }

    /// V of the module's table, m^2.
    pub fn lyapunov(&self, gains: &TrackingGains<T>) -> T {
        T::of(0.5) * (self.along * self.along + self.across * self.across)
            + (T::ONE - self.cos_heading) / gains.across
    }

    /// Time derivative (e_x_dot, e_y_dot, e_phi_dot) at a robot velocity.
    pub fn rate(&self, reference: Velocity<T>, velocity: Velocity<T>) -> [T; 3] {
        [
            velocity.angular * self.across - velocity.linear + reference.linear * self.cos_heading,
            reference.linear * self.sin_heading - velocity.angular * self.along,
            reference.angular - velocity.angular,
        ]
    }
}

/// v_d and its derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Desired<T> {
    /// v_d of eq. 23.
    pub velocity: Velocity<T>,
    /// v_d_dot at the measured velocity, by the chain rule: nothing is differenced.
    pub acceleration: Velocity<T>,
    /// (nu_r_dot, omega_r_dot): the part of the derivative that no measurement enters.
    pub reference_acceleration: Velocity<T>,
}

/// v_d (eq. 23) and v_d_dot for a pose error, a reference and the robot's measured velocity.
pub fn desired_velocity<T: Real>(
    gains: &TrackingGains<T>,
    error: &TrackingError<T>,
    reference: &ReferenceSample<T>,
    velocity: Velocity<T>,
) -> Desired<T> {
    let (nu, nu_dot) = (reference.velocity.linear, reference.acceleration.linear);
    let (sin, cos) = (error.sin_heading, error.cos_heading);
    let [x_dot, y_dot, phi_dot] = error.rate(reference.velocity, velocity);
    let (k1, k2, k3) = (gains.along, gains.across, gains.heading);
    let (y, sin_dot) = (error.across, cos * phi_dot);
    let (turn, turn_dot) = match gains.form {
        TrackingForm::HeadingAlways => (
            k2 * nu * y + k3 * sin,
            k2 * (nu_dot * y + nu * y_dot) + k3 * sin_dot,
        ),
        TrackingForm::Printed => (
            k2 * nu * (y + k3 * nu * sin),
            k2 * nu_dot * (y + k3 * nu * sin)
                + k2 * nu * (y_dot + k3 * (nu_dot * sin + nu * sin_dot)),
        ),
        TrackingForm::Usual => (
            nu * (k2 * y + k3 * sin),
            nu_dot * (k2 * y + k3 * sin) + nu * (k2 * y_dot + k3 * sin_dot),
        ),
    };
    Desired {
        velocity: Velocity {
            linear: nu * cos + k1 * error.along,
            angular: reference.velocity.angular + turn,
        },
        acceleration: Velocity {
            linear: nu_dot * cos - nu * sin * phi_dot + k1 * x_dot,
            angular: reference.acceleration.angular + turn_dot,
        },
        reference_acceleration: reference.acceleration,
    }
}
