//! M q_ddot + C q_dot = B tau - A^T lambda (eq. 12), and its reduction M_bar v_dot + C_bar v = tau_bar (eq. 21).
//!
//! Two models. [`RobotModel`] holds the printed matrices (eqs. 13-17): they agree with each other only if the center of mass
//! lies on the axle and the reference point d ahead of it; M_bar = diag(m, J - m d^2). It is the controller's nominal model.
//! [`PlantModel`] is consistent for plans: reference point on the axle, center of mass d ahead, I_c about it:
//! M_bar = diag(m, I_c + m d^2), C_bar = [[0, -m d omega], [m d omega, 0]].
//!
//! Two misprints. Eq. 14's row 2 has the wrong sign ([`CoriolisForm`]), and C_bar after eq. 21 is S^T M S_dot + S^T C S: the
//! printed S M S_dot has no fitting dimensions.

use crate::kinematics::{constraint_row, null_basis, null_basis_rate};
use crate::parameter::{not_negative, positive, require};
use crate::{BodyForce, ParameterError, Real, Velocity, WheelTorque};

/// Row 2 of C, eq. 14.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CoriolisForm {
    /// -m d phi_dot sin phi, as printed: C_bar then depends on the compass heading and makes or loses energy.
    Printed,
    /// +m d phi_dot sin phi: C_bar = 0.
    #[default]
    Corrected,
}

/// M_bar and C_bar of eq. 21. Rows: force (N), torque (N m); columns: nu, omega.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReducedModel<T> {
    /// M_bar, kg and kg m^2.
    pub inertia: [[T; 2]; 2],
    /// C_bar, per the velocities.
    pub coriolis: [[T; 2]; 2],
}

/// M_bar = S^T M S and C_bar = S^T M S_dot + S^T C S (eq. 21 with its dimensions corrected).
pub fn reduce<T: Real>(
    mass: &[[T; 3]; 3],
    coriolis: &[[T; 3]; 3],
    basis: &[[T; 2]; 3],
    basis_rate: &[[T; 2]; 3],
) -> ReducedModel<T> {
    let project = |m: &[[T; 3]; 3], s: &[[T; 2]; 3]| -> [[T; 2]; 2] {
        let ms = m.map(|row| {
            [
                row[0] * s[0][0] + row[1] * s[1][0] + row[2] * s[2][0],
                row[0] * s[0][1] + row[1] * s[1][1] + row[2] * s[2][1],
            ]
        });
        let entry = |i: usize, j: usize| {
            basis[0][i] * ms[0][j] + basis[1][i] * ms[1][j] + basis[2][i] * ms[2][j]
        };
        [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
    };
    let [a, b] = [project(mass, basis_rate), project(coriolis, basis)];
    ReducedModel {
        inertia: project(mass, basis),
        coriolis: [
            [a[0][0] + b[0][0], a[0][1] + b[0][1]],
            [a[1][0] + b[1][0], a[1][1] + b[1][1]],
        ],
    }
}

/// The robot as the paper prints it: the controller's nominal model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RobotModel<T> {
    /// m, kg.
    pub mass: T,
    /// J, kg m^2.
    pub inertia: T,
    /// R, half the distance between the wheels, m.
    pub half_track: T,
    /// r, m.
    pub wheel_radius: T,
    /// d, m.
    pub offset: T,
    /// Row 2 of eq. 14.
    pub coriolis_form: CoriolisForm,
}

impl<T: Real> RobotModel<T> {
    /// The paper's table: m 1.43 kg, J 0.146 kg m^2, R 0.144 m, r 0.033 m, d 0.020 m.
    pub fn paper() -> Self {
        Self {
            mass: T::of(1.43),
            inertia: T::of(0.146),
            half_track: T::of(0.144),
            wheel_radius: T::of(0.033),
            offset: T::of(0.020),
            coriolis_form: CoriolisForm::Corrected,
        }
    }

    /// The paper's table with J 0.0146 kg m^2, the value of the robot's own model file.
    pub fn robot_file() -> Self {
        Self {
            inertia: T::of(0.0146),
            ..Self::paper()
        }
    }

    /// Checks units' ranges: masses and lengths above zero, J above m d^2.
    ///
    /// # Errors
    /// Names the first parameter that is out of range.
    pub fn validate(&self) -> Result<(), ParameterError> {
        positive("model.mass", self.mass)?;
        positive("model.half_track", self.half_track)?;
        positive("model.wheel_radius", self.wheel_radius)?;
        not_negative("model.offset", self.offset)?;
        let rest = self.inertia - self.mass * self.offset * self.offset;
        require(
            "model.inertia",
            self.inertia,
            rest > T::ZERO,
            "above mass * offset^2, kg m^2",
        )
    }

    /// M(q), eq. 13.
    pub fn mass_matrix(&self, heading: T) -> [[T; 3]; 3] {
        let (sin, cos) = heading.sine_cosine();
        let (m, md, o) = (self.mass, self.mass * self.offset, T::ZERO);
        [
            [m, o, md * sin],
            [o, m, -md * cos],
            [md * sin, -md * cos, self.inertia],
        ]
    }

    /// C(q, q_dot), eq. 14, at a turning rate in rad/s.
    pub fn coriolis_matrix(&self, heading: T, rate: T) -> [[T; 3]; 3] {
        let (sin, cos) = heading.sine_cosine();
        let (mdw, o) = (self.mass * self.offset * rate, T::ZERO);
        let row_2 = match self.coriolis_form {
            CoriolisForm::Printed => -mdw * sin,
            CoriolisForm::Corrected => mdw * sin,
        };
        [[o, o, mdw * cos], [o, o, row_2], [o, o, o]]
    }

    /// B(q), eq. 15; columns right, left.
    pub fn input_matrix(&self, heading: T) -> [[T; 2]; 3] {
        let (sin, cos) = heading.sine_cosine();
        let (r, track) = (self.wheel_radius, self.half_track);
        [
            [cos / r, cos / r],
            [sin / r, sin / r],
            [track / r, -track / r],
        ]
    }

    /// A(q), eq. 16.
    pub fn constraint_row(&self, heading: T) -> [T; 3] {
        constraint_row(heading, self.offset)
    }

    /// lambda, eq. 17: the sideways force of the wheels, N. Exact for the printed M with the corrected C.
    pub fn constraint_force(&self, velocity: Velocity<T>) -> T {
        -self.mass * velocity.linear * velocity.angular
    }

    /// M_bar and C_bar by way of eqs. 13, 14, 18.
    pub fn reduced(&self, heading: T, rate: T) -> ReducedModel<T> {
        reduce(
            &self.mass_matrix(heading),
            &self.coriolis_matrix(heading, rate),
            &null_basis(heading, self.offset),
            &null_basis_rate(heading, rate, self.offset),
        )
    }

    /// The diagonal of M_bar: (m, J - m d^2), kg and kg m^2.
    pub fn reduced_inertia(&self) -> [T; 2] {
        [
            self.mass,
            self.inertia - self.mass * self.offset * self.offset,
        ]
    }

    /// tau_bar = B_bar tau, B_bar = S^T B = [[1, 1], [R, -R]] / r.
    pub fn body_force(&self, torque: WheelTorque<T>) -> BodyForce<T> {
        BodyForce {
            force: (torque.right + torque.left) / self.wheel_radius,
            torque: (torque.right - torque.left) * self.half_track / self.wheel_radius,
        }
    }

    /// tau = B_bar^-1 tau_bar; B_bar is square and regular, so this is its pseudo-inverse of eq. 22.
    pub fn wheel_torque(&self, body: BodyForce<T>) -> WheelTorque<T> {
        let half = self.wheel_radius * T::of(0.5);
        let turn = body.torque / self.half_track;
        WheelTorque {
            right: half * (body.force + turn),
            left: half * (body.force - turn),
        }
    }
}

/// The robot as it is: reference point on the axle, center of mass ahead of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlantModel<T> {
    /// m, kg.
    pub mass: T,
    /// I_c about the vertical through the center of mass, kg m^2.
    pub inertia: T,
    /// d: the center of mass lies this far ahead of the axle, m.
    pub center_of_mass: T,
}

impl<T: Real> PlantModel<T> {
    /// M(q) with respect to the axle center.
    pub fn mass_matrix(&self, heading: T) -> [[T; 3]; 3] {
        let (sin, cos) = heading.sine_cosine();
        let (m, md, o) = (self.mass, self.mass * self.center_of_mass, T::ZERO);
        [
            [m, o, -md * sin],
            [o, m, md * cos],
            [-md * sin, md * cos, self.inertia + md * self.center_of_mass],
        ]
    }

    /// C(q, q_dot) with respect to the axle center, at a turning rate in rad/s.
    pub fn coriolis_matrix(&self, heading: T, rate: T) -> [[T; 3]; 3] {
        let (sin, cos) = heading.sine_cosine();
        let (mdw, o) = (self.mass * self.center_of_mass * rate, T::ZERO);
        [[o, o, -mdw * cos], [o, o, -mdw * sin], [o, o, o]]
    }

    /// M_bar and C_bar by way of M, C and S.
    pub fn reduced(&self, heading: T, rate: T) -> ReducedModel<T> {
        reduce(
            &self.mass_matrix(heading),
            &self.coriolis_matrix(heading, rate),
            &null_basis(heading, T::ZERO),
            &null_basis_rate(heading, rate, T::ZERO),
        )
    }

    /// lambda: the sideways force of the wheels, N, at an acceleration.
    pub fn constraint_force(&self, velocity: Velocity<T>, acceleration: Velocity<T>) -> T {
        -self.mass
            * (velocity.linear * velocity.angular + self.center_of_mass * acceleration.angular)
    }

    /// v_dot = M_bar^-1 (tau_bar - C_bar v), in closed form.
    pub fn acceleration(&self, velocity: Velocity<T>, body: BodyForce<T>) -> Velocity<T> {
        let md = self.mass * self.center_of_mass;
        let w = velocity.angular;
        Velocity {
            linear: (body.force + md * w * w) / self.mass,
            angular: (body.torque - md * w * velocity.linear)
                / (self.inertia + md * self.center_of_mass),
        }
    }

    /// Kinetic energy, J.
    pub fn energy(&self, velocity: Velocity<T>) -> T {
        let turning = self.inertia + self.mass * self.center_of_mass * self.center_of_mass;
        T::of(0.5)
            * (self.mass * velocity.linear * velocity.linear
                + turning * velocity.angular * velocity.angular)
    }
}
