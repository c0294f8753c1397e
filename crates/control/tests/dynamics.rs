//! Eqs. 12 to 21: constraint, skew symmetry, energy balance, and where the printed forms fail.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use pairtrawl_control::{
    BodyForce, CoriolisForm, PlantModel, RobotModel, Velocity, WheelTorque, constraint_row,
    null_basis, null_basis_rate, pose_rate,
};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const PLANT: PlantModel<f64> = PlantModel {
    mass: 1.43,
    inertia: 0.0146,
    center_of_mass: 0.020,
};

fn printed() -> RobotModel<f64> {
    RobotModel {
        coriolis_form: CoriolisForm::Printed,
        ..RobotModel::paper()
    }
}

#[test]
fn constraint_annihilates_basis() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    for _ in 0..1000 {
        let (phi, d) = (rng.random_range(-10.0..10.0), rng.random_range(-0.3..0.3));
        let (a, s) = (constraint_row(phi, d), null_basis(phi, d));
        let product = |j: usize| a.iter().zip(s).map(|(a, row)| a * row[j]).sum::<f64>();
        assert!(
            product(0).abs() < 1e-15 && product(1).abs() < 1e-15,
            "A S at {phi}, {d}"
        );
        let v = Velocity {
            linear: rng.random_range(-1.0..1.0),
            angular: rng.random_range(-3.0..3.0),
        };
        let rate = pose_rate(phi, v, d);
        assert!((0..3).map(|i| a[i] * rate[i]).sum::<f64>().abs() < 1e-15);
    }
}

#[test]
fn basis_rate_is_the_derivative() {
    let (phi, w, d, h) = (0.7_f64, 1.3, 0.02, 1e-6);
    let (ahead, behind) = (null_basis(phi + w * h, d), null_basis(phi - w * h, d));
    let rate = null_basis_rate(phi, w, d);
    for i in 0..3 {
        for j in 0..2 {
            assert!((rate[i][j] - (ahead[i][j] - behind[i][j]) / (2.0 * h)).abs() < 1e-9);
        }
    }
}

/// Solves eq. 12 with its constraint for (x_ddot, y_ddot, phi_ddot, lambda) by elimination.
fn constrained_acceleration(
    m: [[f64; 3]; 3],
    c: [[f64; 3]; 3],
    a: [f64; 3],
    a_rate: [f64; 3],
    q_rate: [f64; 3],
    drive: [f64; 3],
) -> [f64; 4] {
    let mut rows = [[0.0; 5]; 4];
    for i in 0..3 {
        let coriolis: f64 = (0..3).map(|j| c[i][j] * q_rate[j]).sum();
        rows[i] = [m[i][0], m[i][1], m[i][2], a[i], drive[i] - coriolis];
    }
    rows[3] = [
        a[0],
        a[1],
        a[2],
        0.0,
        -(0..3).map(|j| a_rate[j] * q_rate[j]).sum::<f64>(),
    ];
    for k in 0..4 {
        let pivot = (k..4)
            .max_by(|&i, &j| rows[i][k].abs().total_cmp(&rows[j][k].abs()))
            .unwrap();
        rows.swap(k, pivot);
        for i in 0..4 {
            if i != k {
                let f = rows[i][k] / rows[k][k];
                let row_k = rows[k];
                rows[i].iter_mut().zip(row_k).for_each(|(x, y)| *x -= f * y);
            }
        }
    }
    [0, 1, 2, 3].map(|k| rows[k][4] / rows[k][k])
}

#[test]
fn reduction_and_multiplier_agree_with_the_full_equations() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let model = RobotModel::<f64>::paper();
    for _ in 0..200 {
        let phi: f64 = rng.random_range(-4.0..4.0);
        let v = Velocity {
            linear: rng.random_range(-1.0..1.0),
            angular: rng.random_range(-3.0..3.0),
        };
        let torque = WheelTorque {
            right: rng.random_range(-0.3..0.3),
            left: rng.random_range(-0.3..0.3),
        };
        let body = model.body_force(torque);
        let (sin, cos) = phi.sin_cos();

        // The plant, reference point on the axle.
        let full = constrained_acceleration(
            PLANT.mass_matrix(phi),
            PLANT.coriolis_matrix(phi, v.angular),
            constraint_row(phi, 0.0),
            [-v.angular * cos, -v.angular * sin, 0.0],
            pose_rate(phi, v, 0.0),
            [body.force * cos, body.force * sin, body.torque],
        );
        let reduced = PLANT.acceleration(v, body);
        assert!((full[2] - reduced.angular).abs() < 1e-10);
        assert!((full[0] * cos + full[1] * sin - reduced.linear).abs() < 1e-10);
        assert!((full[3] - PLANT.constraint_force(v, reduced)).abs() < 1e-10);

        // The printed matrices with row 2 of C corrected: eq. 17 is exact, and C_bar = 0.
        let b = model.input_matrix(phi);
        let full = constrained_acceleration(
            model.mass_matrix(phi),
            model.coriolis_matrix(phi, v.angular),
            model.constraint_row(phi),
            [-v.angular * cos, -v.angular * sin, 0.0],
            pose_rate(phi, v, model.offset),
            b.map(|row| row[0] * torque.right + row[1] * torque.left),
        );
        assert!((full[3] - model.constraint_force(v)).abs() < 1e-10);
        let [m0, m1] = model.reduced_inertia();
        assert!((full[2] - body.torque / m1).abs() < 1e-9);
        // The point d ahead of the axle also feels the centripetal -d omega^2 along the heading.
        let nu_rate = full[0] * cos + full[1] * sin + model.offset * v.angular * v.angular;
        assert!((nu_rate - body.force / m0).abs() < 1e-9, "{nu_rate}");
    }
}

#[test]
fn reduced_matrices_have_their_closed_form() {
    for phi in [-2.0, 0.3, 1.9] {
        let w = 1.7;
        let plant = PLANT.reduced(phi, w);
        let (m, d) = (PLANT.mass, PLANT.center_of_mass);
        close(plant.inertia, [[m, 0.0], [0.0, PLANT.inertia + m * d * d]]);
        close(plant.coriolis, [[0.0, -m * d * w], [m * d * w, 0.0]]);
        let nominal = RobotModel::<f64>::paper();
        close(
            nominal.reduced(phi, w).inertia,
            [[m, 0.0], [0.0, nominal.inertia - m * d * d]],
        );
        close(nominal.reduced(phi, w).coriolis, [[0.0; 2]; 2]);
        // docs/paper.md, row 15: m d w [[0, cos 2 phi - 1], [0, -d sin 2 phi]] in the printed form.
        let (sin_2, cos_2) = (2.0 * phi).sin_cos();
        let bar = printed().reduced(phi, w).coriolis;
        close(
            bar,
            [
                [0.0, m * d * w * (cos_2 - 1.0)],
                [0.0, -m * d * w * d * sin_2],
            ],
        );
    }
}

fn close(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) {
    for i in 0..2 {
        for j in 0..2 {
            assert!((a[i][j] - b[i][j]).abs() < 1e-14, "{a:?} is not {b:?}");
        }
    }
}

/// Greatest |x^T (M_bar_dot - 2 C_bar) x| over unit vectors; M_bar is constant here.
fn skewness(c: [[f64; 2]; 2]) -> f64 {
    c[0][0]
        .abs()
        .max(c[1][1].abs())
        .max((c[0][1] + c[1][0]).abs())
}

#[test]
fn skew_symmetry_holds_for_the_plant_and_fails_as_printed() {
    let headings: Vec<f64> = (0..64).map(|i| f64::from(i) * 0.1).collect();
    let worst = |f: &dyn Fn(f64) -> [[f64; 2]; 2]| {
        headings.iter().map(|&p| skewness(f(p))).fold(0.0, f64::max)
    };
    assert!(worst(&|p| PLANT.reduced(p, 1.5).coriolis) < 1e-14);
    assert!(worst(&|p| RobotModel::<f64>::paper().reduced(p, 1.5).coriolis) < 1e-14);
    assert!(worst(&|p| printed().reduced(p, 1.5).coriolis) > 0.05);
}

/// Kinetic energy gained without any torque over 5 s of RK4.
fn energy_gain(coriolis: impl Fn(f64, f64) -> [[f64; 2]; 2], inertia: [f64; 2]) -> f64 {
    let rate = |s: [f64; 3]| {
        let c = coriolis(s[0], s[2]);
        [
            s[2],
            -(c[0][0] * s[1] + c[0][1] * s[2]) / inertia[0],
            -(c[1][0] * s[1] + c[1][1] * s[2]) / inertia[1],
        ]
    };
    let energy = |s: [f64; 3]| 0.5 * (inertia[0] * s[1] * s[1] + inertia[1] * s[2] * s[2]);
    let mut s = [0.4, 0.3, 1.5];
    let before = energy(s);
    let h = 1e-3;
    for _ in 0..5000 {
        let add = |k: [f64; 3], f: f64| [s[0] + f * k[0], s[1] + f * k[1], s[2] + f * k[2]];
        let k1 = rate(s);
        let k2 = rate(add(k1, h / 2.0));
        let k3 = rate(add(k2, h / 2.0));
        let k4 = rate(add(k3, h));
        for i in 0..3 {
            s[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
        }
    }
    (energy(s) - before) / before
}

#[test]
fn energy_balance_holds_for_the_plant_and_fails_as_printed() {
    let (m, d) = (PLANT.mass, PLANT.center_of_mass);
    let gain = energy_gain(
        |p, w| PLANT.reduced(p, w).coriolis,
        [m, PLANT.inertia + m * d * d],
    );
    assert!(gain.abs() < 1e-9, "{gain}");
    let nominal = RobotModel::<f64>::paper();
    let gain = energy_gain(
        |p, w| printed().reduced(p, w).coriolis,
        nominal.reduced_inertia(),
    );
    assert!(
        gain.abs() > 1e-2,
        "the printed C is said not to conserve energy, gain {gain}"
    );
}

#[test]
fn power_of_the_wheels_is_the_energy_gained() {
    let (v, body) = (
        Velocity {
            linear: 0.2,
            angular: -0.9,
        },
        BodyForce {
            force: 0.7,
            torque: -0.03,
        },
    );
    let (a, h) = (PLANT.acceleration(v, body), 1e-6);
    let at = |t: f64| Velocity {
        linear: v.linear + a.linear * t,
        angular: v.angular + a.angular * t,
    };
    let power = (PLANT.energy(at(h)) - PLANT.energy(at(-h))) / (2.0 * h);
    assert!((power - (body.force * v.linear + body.torque * v.angular)).abs() < 1e-9);
}

#[test]
fn wheel_torques_invert_body_force() {
    let model = RobotModel::<f64>::paper();
    let body = BodyForce {
        force: 1.3,
        torque: -0.2,
    };
    let back = model.body_force(model.wheel_torque(body));
    assert!((back.force - body.force).abs() < 1e-12 && (back.torque - body.torque).abs() < 1e-12);
    // Torque order of docs/paper.md, row 16: the right wheel alone turns the robot to the left.
    assert!(
        model
            .body_force(WheelTorque {
                right: 1.0,
                left: 0.0
            })
            .torque
            > 0.0
    );
}
