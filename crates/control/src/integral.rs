//! The third law, which the adaptive one is fairly compared with: eq. 22 plus proportional and integral feedback of the velocity error,
//! tau_bar = M_bar v_d_dot + C_bar v_d + K (v_d - v) + K_I z, z_dot = v_d - v, z held while torque saturates.

use crate::parameter::{not_negative, positive};
use crate::{
    BodyForce, Desired, ParameterError, Real, RobotModel, Step, Velocity, model_based_force,
};

/// Gains of the integral law, each for (nu, omega).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntegralGains<T> {
    /// K, N s/m and N m s/rad. The same as the adaptive law's by default.
    pub velocity: [T; 2],
    /// K_I, N/m and N m/rad.
    pub integral: [T; 2],
    /// Greatest magnitude of K_I z, N and N m.
    pub bound: [T; 2],
}

impl<T: Real> Default for IntegralGains<T> {
    /// For the TurtleBot3 Waffle Pi: 1.43 kg and, by its model file, 0.0146 kg m^2.
    fn default() -> Self {
        Self::for_inertia([T::of(1.43), T::of(0.0146)])
    }
}

impl<T: Real> IntegralGains<T> {
    /// Default gains for a robot of about this mass and inertia (kg, kg m^2): those of the adaptive law's feedback and bias.
    pub fn for_inertia([m, j]: [T; 2]) -> Self {
        Self {
            velocity: [m * T::of(8.0), j * T::of(8.0)],
            integral: [m * T::of(16.0), j * T::of(40.0)],
            bound: [T::of(12.0), T::of(2.5)],
        }
    }

    /// Checks that gains are finite and not below zero and bounds above it.
    ///
    /// # Errors
    /// Names the first that is not.
    pub fn validate(&self) -> Result<(), ParameterError> {
        for value in self.velocity {
            not_negative("integral.velocity (K)", value)?;
        }
        for value in self.integral {
            not_negative("integral.integral (K_I)", value)?;
        }
        for value in self.bound {
            positive("integral.bound", value)?;
        }
        Ok(())
    }
}

/// The integral law with its state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntegralLaw<T> {
    gains: IntegralGains<T>,
    accumulated: [T; 2],
}

impl<T: Real> IntegralLaw<T> {
    /// The law with an empty integrator.
    ///
    /// # Errors
    /// When a gain is out of range.
    pub fn new(gains: IntegralGains<T>) -> Result<Self, ParameterError> {
        gains.validate()?;
        Ok(Self {
            gains,
            accumulated: [T::ZERO; 2],
        })
    }

    /// K_I z, N and N m.
    pub fn accumulated(&self) -> [T; 2] {
        self.accumulated
    }

    /// Empties the integrator.
    pub fn reset(&mut self) {
        self.accumulated = [T::ZERO; 2];
    }

    /// tau_bar for the measured velocity; `dt` in s since the last call, `saturated` when torque was cut then.
    pub fn force(
        &mut self,
        model: &RobotModel<T>,
        desired: &Desired<T>,
        heading: T,
        velocity: Velocity<T>,
        step: Step<T>,
    ) -> BodyForce<T> {
        let base = model_based_force(model, desired, heading, velocity.angular);
        let g = &self.gains;
        let e = [
            desired.velocity.linear - velocity.linear,
            desired.velocity.angular - velocity.angular,
        ];
        if !step.saturated {
            self.accumulated = [
                (self.accumulated[0] + g.integral[0] * e[0] * step.dt).limited(g.bound[0]),
                (self.accumulated[1] + g.integral[1] * e[1] * step.dt).limited(g.bound[1]),
            ];
        }
        BodyForce {
            force: base.force + g.velocity[0] * e[0] + self.accumulated[0],
            torque: base.torque + g.velocity[1] * e[1] + self.accumulated[1],
        }
    }
}
