//! Eqs. 23 and 24: the Lyapunov function never increases, and the derivative in closed form is right.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use pairtrawl_control::{
    Pose, ReferenceSample, TrackingError, TrackingForm, TrackingGains, Velocity, desired_velocity,
    pose_rate,
};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const FORMS: [(TrackingForm, f64); 3] = [
    (TrackingForm::HeadingAlways, 3.0),
    (TrackingForm::Printed, 8.0),
    (TrackingForm::Usual, 12.0),
];

fn gains(form: TrackingForm, heading: f64, offset: f64) -> TrackingGains<f64> {
    TrackingGains {
        form,
        heading,
        offset,
        ..TrackingGains::default()
    }
}

/// A reference velocity with nu_r >= 0 that stands still now and then.
fn reference_velocity(t: f64, phase: f64) -> Velocity<f64> {
    Velocity {
        linear: (0.15 * (1.0 + 1.6 * (0.7 * t + phase).sin())).max(0.0),
        angular: 0.8 * (1.1 * t + phase).cos(),
    }
}

type State = [f64; 6];

/// Robot and reference poses (points `offset` ahead of the axle) under the exact kinematics and the tracking law.
fn rate(gains: &TrackingGains<f64>, s: State, t: f64, phase: f64) -> State {
    let pose = Pose {
        x: s[0],
        y: s[1],
        heading: s[2],
    };
    let target = Pose {
        x: s[3],
        y: s[4],
        heading: s[5],
    };
    let reference = ReferenceSample {
        pose: target,
        velocity: reference_velocity(t, phase),
        ..Default::default()
    };
    let error = TrackingError::between(&pose, &target, gains.offset);
    let v = desired_velocity(gains, &error, &reference, Velocity::default()).velocity;
    let (a, b) = (
        pose_rate(s[2], v, gains.offset),
        pose_rate(s[5], reference.velocity, gains.offset),
    );
    [a[0], a[1], a[2], b[0], b[1], b[2]]
}

fn lyapunov(gains: &TrackingGains<f64>, s: State) -> f64 {
    let pose = Pose {
        x: s[0],
        y: s[1],
        heading: s[2],
    };
    TrackingError::between(
        &pose,
        &Pose {
            x: s[3],
            y: s[4],
            heading: s[5],
        },
        gains.offset,
    )
    .lyapunov(gains)
}

fn rk4(gains: &TrackingGains<f64>, s: State, t: f64, phase: f64, h: f64) -> State {
    let add = |k: State, f: f64| std::array::from_fn(|i| s[i] + f * k[i]);
    let k1 = rate(gains, s, t, phase);
    let k2 = rate(gains, add(k1, h / 2.0), t + h / 2.0, phase);
    let k3 = rate(gains, add(k2, h / 2.0), t + h / 2.0, phase);
    let k4 = rate(gains, add(k3, h), t + h, phase);
    std::array::from_fn(|i| s[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
}

/// Greatest increase of V in a step, and V at the start and the end of 4 s, from a random error.
fn worst_increase(gains: &TrackingGains<f64>, rng: &mut ChaCha8Rng) -> (f64, f64, f64) {
    let mut s: State = [
        rng.random_range(-1.0..1.0),
        rng.random_range(-1.0..1.0),
        rng.random_range(-3.1..3.1),
        0.0,
        0.0,
        rng.random_range(-3.1..3.1),
    ];
    let (phase, h) = (rng.random_range(0.0..6.0), 2e-3);
    let start = lyapunov(gains, s);
    let (mut v, mut worst) = (start, f64::NEG_INFINITY);
    for i in 0..2000 {
        s = rk4(gains, s, f64::from(i) * h, phase, h);
        let next = lyapunov(gains, s);
        worst = worst.max(next - v);
        v = next;
    }
    (worst, start, v)
}

#[test]
fn lyapunov_function_never_increases() {
    for (form, k3) in FORMS {
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        let gains = gains(form, k3, 0.0);
        for run in 0..1000 {
            let (worst, start, end) = worst_increase(&gains, &mut rng);
            assert!(worst < 1e-9, "{form:?}, run {run}: V grew by {worst}");
            assert!(end <= start);
        }
    }
}

#[test]
fn lyapunov_function_never_increases_with_the_printed_offset() {
    let mut rng = ChaCha8Rng::seed_from_u64(12);
    let gains = gains(TrackingForm::Printed, 8.0, 0.02);
    for run in 0..100 {
        let (worst, ..) = worst_increase(&gains, &mut rng);
        assert!(worst < 1e-9, "run {run}: V grew by {worst}");
    }
}

#[test]
fn only_the_default_form_turns_a_standing_robot() {
    for (form, k3) in FORMS {
        let error = TrackingError::between(
            &Pose {
                x: 0.0,
                y: 0.0,
                heading: 0.0,
            },
            &Pose {
                x: 0.0,
                y: 0.0,
                heading: 0.5,
            },
            0.0,
        );
        let v = desired_velocity(
            &gains(form, k3, 0.0),
            &error,
            &ReferenceSample::default(),
            Velocity::default(),
        );
        assert_eq!(
            v.velocity.angular > 0.0,
            form == TrackingForm::HeadingAlways
        );
    }
}

/// Errors in the world frame, as eq. 24 prints them, diverge for a robot that drives along -x.
#[test]
fn errors_in_the_world_frame_do_not_converge() {
    let drive = |world: bool| {
        let (gains, h) = (TrackingGains::<f64>::default(), 5e-3);
        let mut pose = Pose {
            x: -0.1,
            y: 0.05,
            heading: std::f64::consts::PI,
        };
        for i in 0..2000 {
            let target = Pose {
                x: -0.2 * f64::from(i) * h,
                y: 0.0,
                heading: std::f64::consts::PI,
            };
            let velocity = Velocity {
                linear: 0.2,
                angular: 0.0,
            };
            let reference = ReferenceSample {
                pose: target,
                velocity,
                ..Default::default()
            };
            let mut error = TrackingError::between(&pose, &target, 0.0);
            if world {
                error = TrackingError {
                    along: target.x - pose.x,
                    across: target.y - pose.y,
                    ..error
                };
            }
            let v = desired_velocity(&gains, &error, &reference, Velocity::default()).velocity;
            let r = pose_rate(pose.heading, v, 0.0);
            pose = Pose {
                x: pose.x + h * r[0],
                y: pose.y + h * r[1],
                heading: pose.heading + h * r[2],
            };
        }
        (pose.x + 2.0 * 1.0).hypot(pose.y)
    };
    assert!(drive(false) < 0.01, "{}", drive(false));
    assert!(drive(true) > 1.0, "{}", drive(true));
}

#[test]
fn derivative_of_the_desired_velocity_is_right() {
    let mut rng = ChaCha8Rng::seed_from_u64(13);
    for (form, k3) in FORMS {
        let gains = gains(form, k3, 0.0);
        for _ in 0..200 {
            let mut r = |bound: f64| rng.random_range(-bound..bound);
            let pose = Pose {
                x: r(1.0),
                y: r(1.0),
                heading: r(3.0),
            };
            let v = Velocity {
                linear: r(0.4),
                angular: r(1.0),
            };
            let reference = ReferenceSample {
                pose: Pose {
                    x: r(1.0),
                    y: r(1.0),
                    heading: r(3.0),
                },
                velocity: Velocity {
                    linear: r(0.4),
                    angular: r(1.0),
                },
                acceleration: Velocity {
                    linear: r(0.4),
                    angular: r(1.0),
                },
            };
            // Both move for a short time at their velocities; v_d is differenced from outside.
            let at = |t: f64| {
                let moved = |p: &Pose<f64>, v: Velocity<f64>| {
                    let turn = v.angular * t;
                    let mid = p.heading + 0.5 * turn;
                    Pose {
                        x: p.x + v.linear * t * mid.cos(),
                        y: p.y + v.linear * t * mid.sin(),
                        heading: p.heading + turn,
                    }
                };
                let moved_reference = ReferenceSample {
                    pose: moved(&reference.pose, reference.velocity),
                    velocity: Velocity {
                        linear: reference.velocity.linear + reference.acceleration.linear * t,
                        angular: reference.velocity.angular + reference.acceleration.angular * t,
                    },
                    acceleration: reference.acceleration,
                };
                let error = TrackingError::between(&moved(&pose, v), &moved_reference.pose, 0.0);
                desired_velocity(&gains, &error, &moved_reference, v)
            };
            let h = 1e-5;
            let (ahead, behind, now) = (at(h).velocity, at(-h).velocity, at(0.0).acceleration);
            let linear = (ahead.linear - behind.linear) / (2.0 * h);
            let angular = (ahead.angular - behind.angular) / (2.0 * h);
            assert!(
                (linear - now.linear).abs() < 1e-6,
                "{form:?}: {linear} {}",
                now.linear
            );
            assert!(
                (angular - now.angular).abs() < 1e-5,
                "{form:?}: {angular} {}",
                now.angular
            );
        }
    }
}
