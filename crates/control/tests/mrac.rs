//! Eqs. 25 to 30: signs by the Lyapunov function, bounds, freezing, and the stability limit of the literal split.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use pairtrawl_control::{
    CoriolisForm, Desired, InertiaSplit, MracGains, MracLaw, RobotModel, Step, Velocity,
};

/// M, a, f of a plant M X_dot = u - a X - f; heavier than L, with cross friction.
const MASS: [f64; 2] = [2.2, 0.02];
const FRICTION: [[f64; 2]; 2] = [[1.5, 0.3], [0.02, 0.05]];
const FORCE: [f64; 2] = [0.9, -0.06];

fn gains() -> MracGains<f64> {
    MracGains {
        leakage: [0.0; 3],
        state_bound: [100.0; 2],
        input_bound: [100.0; 2],
        bias_bound: [100.0; 2],
        ..MracGains::default()
    }
}

/// The controller's model, with M_k = L, so that eq. 27 adds nothing.
fn model() -> RobotModel<f64> {
    RobotModel {
        mass: 1.43,
        inertia: 0.0146,
        offset: 0.0,
        coriolis_form: CoriolisForm::Corrected,
        ..RobotModel::paper()
    }
}

fn desired(t: f64) -> Desired<f64> {
    let acceleration = Velocity {
        linear: 0.1 * (0.9 * t).cos() * 0.9,
        angular: -0.5 * 1.7 * (1.7 * t).sin(),
    };
    Desired {
        velocity: Velocity {
            linear: 0.2 + 0.1 * (0.9 * t).sin(),
            angular: 0.5 * (1.7 * t).cos(),
        },
        acceleration,
        reference_acceleration: acceleration,
    }
}

/// V = e^T P L e + sum over entries of (L/M) (Delta - Delta*)^2 / Gamma.
fn lyapunov(law: &MracLaw<f64>, g: &MracGains<f64>, x: [f64; 2], t: f64) -> f64 {
    let d = desired(t);
    let e = [x[0] - d.velocity.linear, x[1] - d.velocity.angular];
    let a = law.adapted();
    let mut v = 0.0;
    for i in 0..2 {
        let (l, k) = (g.split_inertia[i], g.feedback[i]);
        v += g.lyapunov[i] / (2.0 * k) * l * e[i] * e[i];
        let ratio = MASS[i] / l;
        for (j, friction) in FRICTION[i].iter().enumerate() {
            let own = if i == j { 1.0 } else { 0.0 };
            let state = own * (ratio - 1.0) * k - friction;
            let input = own * (ratio - 1.0);
            v += (a.state[i][j] - state).powi(2) / (g.state_rate[i] * ratio);
            v += (a.input[i][j] - input).powi(2) / (g.input_rate[i] * ratio);
        }
        v += (a.bias[i] + FORCE[i]).powi(2) / (g.bias_rate[i] * ratio);
    }
    v
}

#[test]
fn lyapunov_function_falls_along_the_adaptation() {
    let g = gains();
    let mut law = MracLaw::new(g).unwrap();
    let (h, mut x) = (2e-5, [0.0, 0.3]);
    let start = lyapunov(&law, &g, x, 0.0);
    let mut v = start;
    let (mut worst, mut dissipated) = (f64::NEG_INFINITY, 0.0);
    for i in 0..200_000 {
        let t = f64::from(i) * h;
        let velocity = Velocity::from_array(x);
        let body = law.force(
            &model(),
            &desired(t),
            0.0,
            velocity,
            Step {
                dt: h,
                saturated: false,
            },
        );
        let u = [body.force, body.torque];
        let x_m = desired(t).velocity.to_array();
        dissipated += h
            * (0..2)
                .map(|j| g.lyapunov[j] * (x[j] - x_m[j]).powi(2))
                .sum::<f64>();
        let x_old = x;
        for j in 0..2 {
            let friction = FRICTION[j][0] * x_old[0] + FRICTION[j][1] * x_old[1];
            x[j] += h * (u[j] - friction - FORCE[j]) / MASS[j];
        }
        let next = lyapunov(&law, &g, x, t + h);
        worst = worst.max((next - v) / h);
        v = next;
    }
    assert!(worst < 1e-3, "V grew at a rate of {worst}");
    let fallen = start - v;
    assert!(
        (fallen / dissipated - 1.0).abs() < 0.01,
        "V fell by {fallen}, but e^T Q e integrates to {dissipated}"
    );
}

/// Runs a law on a plant of one channel pair under a constant drag and returns the last velocity error.
fn settled_error(g: MracGains<f64>, drag: f64, saturated: bool) -> (f64, MracLaw<f64>) {
    let mut law = MracLaw::new(g).unwrap();
    let still = Desired {
        velocity: Velocity {
            linear: 0.2,
            angular: 0.0,
        },
        ..Desired::default()
    };
    let (h, mut nu) = (2e-3, 0.0);
    for _ in 0..5000 {
        let v = Velocity {
            linear: nu,
            angular: 0.0,
        };
        let body = law.force(&model(), &still, 0.0, v, Step { dt: h, saturated });
        nu += h * (body.force - drag) / 1.43;
    }
    (nu - 0.2, law)
}

#[test]
fn constant_drag_is_learned() {
    let (error, law) = settled_error(MracGains::default(), 0.8, false);
    assert!(error.abs() < 2e-3, "{error}");
    let (frozen, law_frozen) = settled_error(MracGains::default(), 0.8, true);
    assert!(
        (frozen + 0.8 / 11.4).abs() < 1e-3,
        "without adaptation the error is drag / K, not {frozen}"
    );
    assert_eq!(
        law_frozen.adapted(),
        &Default::default(),
        "adaptation must hold while torque saturates"
    );
    assert!(law.adapted().bias[0] < 0.0);
}

#[test]
fn projection_bounds_the_parameters() {
    let g = MracGains::default();
    let (_, law) = settled_error(g, 1e4, false);
    let a = law.adapted();
    for i in 0..2 {
        assert!(a.bias[i].abs() <= g.bias_bound[i]);
        for j in 0..2 {
            assert!(
                a.state[i][j].abs() <= g.state_bound[i] && a.input[i][j].abs() <= g.input_bound[i]
            );
        }
    }
    assert_eq!(a.bias[0], -g.bias_bound[0]);
}

/// Greatest turning-rate error in the last of 6 s with the literal split, J_k 0.146 on a plant of 0.0152,
/// torque delayed by `delay` s, after a push of 0.1 rad/s. Infinite when it blew up.
fn literal_error(filter_time: f64, delay: f64) -> f64 {
    let g = MracGains {
        split: InertiaSplit::Literal { filter_time },
        ..MracGains::default()
    };
    let mut law = MracLaw::new(g).unwrap();
    let nominal = RobotModel::paper();
    let (h, steps) = (2e-3, (delay / 2e-3).round() as usize);
    let mut line = vec![[0.0; 2]; steps];
    let (mut x, mut worst) = ([0.0, 0.1], 0.0_f64);
    for i in 0..3000 {
        let body = law.force(
            &nominal,
            &Desired::default(),
            0.0,
            Velocity::from_array(x),
            Step {
                dt: h,
                saturated: false,
            },
        );
        line.push([body.force, body.torque]);
        let u = line.remove(0);
        x[0] += h * u[0] / 1.43;
        x[1] += h * u[1] / 0.015_172;
        if !x[1].is_finite() || x[1].abs() > 1e3 {
            return f64::INFINITY;
        }
        if i >= 2500 {
            worst = worst.max(x[1].abs());
        }
    }
    worst
}

#[test]
fn literal_split_is_unstable_for_short_filters() {
    for filter_time in [0.02, 0.1, 0.2, 0.3] {
        assert!(
            literal_error(filter_time, 0.01) > 1.0,
            "filter of {filter_time} s"
        );
    }
    // Longer filters are stable again; so is the default split.
    for filter_time in [0.5, 1.0] {
        assert!(
            literal_error(filter_time, 0.01) < 0.1,
            "filter of {filter_time} s"
        );
    }
}

#[test]
fn bad_gains_are_named() {
    let bad = MracGains {
        feedback: [11.0, f64::NAN],
        ..MracGains::default()
    };
    assert_eq!(MracLaw::new(bad).unwrap_err().name, "mrac.feedback (K)");
    assert!(
        MracLaw::new(MracGains {
            bias_rate: [-1.0, 0.1],
            ..MracGains::default()
        })
        .is_err()
    );
}
