//! The adaptive law, eqs. 25 to 30, written out.
//!
//! With X = v, the known model M_k, C_k and a split inertia L (printed as I = 1 kg, 1 kg m^2):
//!
//! - tau_bar = u + (M_k - L) v_r_dot + C_k X (eq. 27; v_r_dot instead of the measured acceleration, see [`InertiaSplit`])
//! - reference model L X_m_dot = -K X_m + u_m (eq. 28); X_m = v_d makes u_m = L v_d_dot + K v_d (eq. 29)
//! - u = -K X + u_m - Delta_X X + Delta_m u_m - Delta_b (eq. 30, and a bias, since a dragged net is dry friction)
//! - e = X - X_m, K^T P + P K = Q, all diagonal, so P = Q / (2 K)
//! - Delta_X_dot = +Gamma_X P e X^T, Delta_m_dot = -Gamma_m P e u_m^T, Delta_b_dot = +Gamma_b P e
//!
//! A plant M X_dot = u - a X - f is matched by Delta_m = M/L - 1, Delta_X = (M/L - 1) K - a, Delta_b = -f, and
//! V = e^T P L e + sum (L/M) (Delta - Delta*)^2 / Gamma has V_dot = -e^T Q e.
//!
//! Leakage pulls the parameters to zero, a box bounds them (projection), and they hold while torque saturates.

use crate::parameter::{not_negative, positive};
use crate::{BodyForce, Desired, ParameterError, Real, RobotModel, Step, Velocity};

/// How the known inertia is split, eqs. 25 and 27.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum InertiaSplit<T> {
    /// M_k = (M_k - L) + L, times the acceleration of the reference: no acceleration is fed back.
    #[default]
    Reference,
    /// As printed: M_k = (M_k - I) + I with I = 1 kg and 1 kg m^2, times the measured acceleration, which has to be a filtered
    /// difference. It feeds acceleration back with gain (M_k - I) / M and is unstable for short filters.
    Literal {
        /// Time constant of the first-order filter on the differenced velocity, s.
        filter_time: T,
    },
}

/// Gains of the adaptive law, each for (nu, omega).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MracGains<T> {
    /// L, kg and kg m^2: near the true inertia.
    pub split_inertia: [T; 2],
    /// K, N s/m and N m s/rad. K / L is the bandwidth of the velocity loop: 4 to 20 1/s; below 1 / (2 delay).
    pub feedback: [T; 2],
    /// Q of K^T P + P K = Q; 2 K makes P = 1.
    pub lyapunov: [T; 2],
    /// Gamma_X: rows of Delta_X.
    pub state_rate: [T; 2],
    /// Gamma_m: rows of Delta_m.
    pub input_rate: [T; 2],
    /// Gamma_b, N/m and N m/rad with P = 1. K^2 / (4 L) to K^2 / L: critically damped and faster.
    pub bias_rate: [T; 2],
    /// Leakage of Delta_X, Delta_m and Delta_b, 1/s.
    pub leakage: [T; 3],
    /// Bounds of the entries of Delta_X by row, N s/m and N m s/rad.
    pub state_bound: [T; 2],
    /// Bounds of the entries of Delta_m by row.
    pub input_bound: [T; 2],
    /// Bounds of Delta_b, N and N m.
    pub bias_bound: [T; 2],
    /// How the known inertia is split.
    pub split: InertiaSplit<T>,
}

impl<T: Real> Default for MracGains<T> {
    /// For the TurtleBot3 Waffle Pi: 1.43 kg and, by its model file, 0.0146 kg m^2.
    fn default() -> Self {
        Self::for_inertia([T::of(1.43), T::of(0.0146)])
    }
}

impl<T: Real> MracGains<T> {
    /// Default gains for a robot of about this mass and inertia (kg, kg m^2): velocity loops of 8 1/s, which bear
    /// 60 ms of delay in the loop on half the mass and half the inertia.
    pub fn for_inertia(split_inertia: [T; 2]) -> Self {
        let [m, j] = split_inertia;
        let feedback = [m * T::of(8.0), j * T::of(8.0)];
        Self {
            split_inertia,
            feedback,
            lyapunov: feedback.map(|k| k + k),
            state_rate: [m * T::of(5.0), j * T::of(5.0)],
            input_rate: [T::of(0.2), T::of(0.1)],
            bias_rate: [m * T::of(16.0), j * T::of(30.0)],
            leakage: [T::of(0.1), T::of(0.1), T::of(0.01)],
            state_bound: feedback,
            input_bound: [T::of(0.8), T::of(0.8)],
            bias_bound: [T::of(12.0), T::of(2.5)],
            split: InertiaSplit::Reference,
        }
    }

    /// Checks that gains are finite and in range.
    ///
    /// # Errors
    /// Names the first that is not.
    pub fn validate(&self) -> Result<(), ParameterError> {
        for i in [0, 1] {
            positive("mrac.split_inertia (L)", self.split_inertia[i])?;
            positive("mrac.feedback (K)", self.feedback[i])?;
            positive("mrac.lyapunov (Q)", self.lyapunov[i])?;
            not_negative("mrac.state_rate (Gamma_X)", self.state_rate[i])?;
            not_negative("mrac.input_rate (Gamma_m)", self.input_rate[i])?;
            not_negative("mrac.bias_rate (Gamma_b)", self.bias_rate[i])?;
            positive("mrac.state_bound", self.state_bound[i])?;
            positive("mrac.input_bound", self.input_bound[i])?;
            positive("mrac.bias_bound", self.bias_bound[i])?;
        }
        for value in self.leakage {
            not_negative("mrac.leakage", value)?;
        }
        if let InertiaSplit::Literal { filter_time } = self.split {
            positive("mrac.split.filter_time", filter_time)?;
        }
        Ok(())
    }
}

/// Delta_X, Delta_m and Delta_b.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AdaptedParameters<T> {
    /// Delta_X: rows force and torque, columns nu and omega.
    pub state: [[T; 2]; 2],
    /// Delta_m: rows force and torque, columns those of u_m.
    pub input: [[T; 2]; 2],
    /// Delta_b, N and N m: minus the constant force that was found.
    pub bias: [T; 2],
}

/// The adaptive law with its state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MracLaw<T> {
    gains: MracGains<T>,
    adapted: AdaptedParameters<T>,
    /// P = Q / (2 K).
    weight: [T; 2],
    last_velocity: Option<[T; 2]>,
    measured_acceleration: [T; 2],
}

impl<T: Real> MracLaw<T> {
    /// The law with all adapted parameters at zero.
    ///
    /// # Errors
    /// When a gain is out of range.
    pub fn new(gains: MracGains<T>) -> Result<Self, ParameterError> {
        gains.validate()?;
        let weight = [
            gains.lyapunov[0] / (T::of(2.0) * gains.feedback[0]),
            gains.lyapunov[1] / (T::of(2.0) * gains.feedback[1]),
        ];
        Ok(Self {
            gains,
            adapted: AdaptedParameters::default(),
            weight,
            last_velocity: None,
            measured_acceleration: [T::ZERO; 2],
        })
    }

    /// Delta_X, Delta_m, Delta_b.
    pub fn adapted(&self) -> &AdaptedParameters<T> {
        &self.adapted
    }

    /// Sets all adapted parameters to zero and forgets the last velocity.
    pub fn reset(&mut self) {
        self.adapted = AdaptedParameters::default();
        self.last_velocity = None;
        self.measured_acceleration = [T::ZERO; 2];
    }

    /// L: as given, or 1 kg and 1 kg m^2 in the literal split.
    pub fn split_inertia(&self) -> [T; 2] {
        match self.gains.split {
            InertiaSplit::Reference => self.gains.split_inertia,
            InertiaSplit::Literal { .. } => [T::ONE; 2],
        }
    }

    /// u_m = L v_d_dot + K v_d (eq. 29), N and N m.
    pub fn reference_input(&self, desired: &Desired<T>) -> [T; 2] {
        let (l, k) = (self.split_inertia(), self.gains.feedback);
        [
            l[0] * desired.acceleration.linear + k[0] * desired.velocity.linear,
            l[1] * desired.acceleration.angular + k[1] * desired.velocity.angular,
        ]
    }

    /// tau_bar (eq. 27) for the measured velocity; the parameters adapt by one step.
    pub fn force(
        &mut self,
        model: &RobotModel<T>,
        desired: &Desired<T>,
        heading: T,
        velocity: Velocity<T>,
        step: Step<T>,
    ) -> BodyForce<T> {
        let x = velocity.to_array();
        let input = self.reference_input(desired);
        if !step.saturated {
            self.adapt(x, desired.velocity.to_array(), input, step.dt);
        }
        let u = self.feedback(x, input);
        let known = model.reduced(heading, velocity.angular);
        let l = self.split_inertia();
        let acceleration = match self.gains.split {
            InertiaSplit::Reference => desired.reference_acceleration.to_array(),
            InertiaSplit::Literal { filter_time } => self.differenced(x, filter_time, step.dt),
        };
        let row = |i: usize, m: [T; 2], c: [T; 2]| {
            let known = m[0] * acceleration[0] + m[1] * acceleration[1] + c[0] * x[0] + c[1] * x[1];
            u[i] + known - l[i] * acceleration[i]
        };
        BodyForce {
            force: row(0, known.inertia[0], known.coriolis[0]),
            torque: row(1, known.inertia[1], known.coriolis[1]),
        }
    }

    /// u of eq. 30.
    fn feedback(&self, x: [T; 2], input: [T; 2]) -> [T; 2] {
        let (k, a) = (self.gains.feedback, &self.adapted);
        let row = |i: usize| {
            input[i] - k[i] * x[i] - a.state[i][0] * x[0] - a.state[i][1] * x[1]
                + a.input[i][0] * input[0]
                + a.input[i][1] * input[1]
                - a.bias[i]
        };
        [row(0), row(1)]
    }

    /// One explicit Euler step of the adaptive laws, with leakage and projection.
    fn adapt(&mut self, x: [T; 2], x_m: [T; 2], input: [T; 2], dt: T) {
        let g = &self.gains;
        for i in [0, 1] {
            let drive = self.weight[i] * (x[i] - x_m[i]);
            for j in [0, 1] {
                let state = self.adapted.state[i][j];
                let rate = g.state_rate[i] * drive * x[j] - g.leakage[0] * state;
                self.adapted.state[i][j] = (state + dt * rate).limited(g.state_bound[i]);
                let gain = self.adapted.input[i][j];
                let rate = -g.input_rate[i] * drive * input[j] - g.leakage[1] * gain;
                self.adapted.input[i][j] = (gain + dt * rate).limited(g.input_bound[i]);
            }
            let bias = self.adapted.bias[i];
            let rate = g.bias_rate[i] * drive - g.leakage[2] * bias;
            self.adapted.bias[i] = (bias + dt * rate).limited(g.bias_bound[i]);
        }
    }

    /// The measured acceleration: a difference behind a first-order filter.
    fn differenced(&mut self, x: [T; 2], filter_time: T, dt: T) -> [T; 2] {
        if dt > T::ZERO {
            if let Some(last) = self.last_velocity {
                for i in [0, 1] {
                    let raw = (x[i] - last[i]) / dt;
                    let a = self.measured_acceleration[i];
                    self.measured_acceleration[i] = a + (raw - a) * dt / (filter_time + dt);
                }
            }
            self.last_velocity = Some(x);
        }
        self.measured_acceleration
    }
}
