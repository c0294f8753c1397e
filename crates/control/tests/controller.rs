//! The whole controller: bounded commands whatever comes in, latched stops, f32 against f64, no allocation.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use pairtrawl_control::{
    ControllerParameters, IntegralGains, LawParameters, Mode, MracGains, Pose, Real,
    ReferenceSample, RobotController, StopCause, TorqueLimiter, Velocity, WheelTorque,
};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn laws<T: Real>() -> [LawParameters<T>; 3] {
    [
        LawParameters::ModelBased,
        LawParameters::Integral(IntegralGains::default()),
        LawParameters::Mrac(MracGains::default()),
    ]
}

fn controller<T: Real>(law: LawParameters<T>) -> RobotController<T> {
    RobotController::new(&ControllerParameters::with_law(law)).unwrap()
}

/// Numbers that break arithmetic, among ordinary ones.
fn garbage(rng: &mut ChaCha8Rng) -> f64 {
    const NASTY: [f64; 10] = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::MAX,
        f64::MIN,
        f64::MIN_POSITIVE,
        -0.0,
        1e30,
        -1e18,
        4.9e-324,
    ];
    match rng.random_range(0..4) {
        0 => NASTY[rng.random_range(0..NASTY.len())],
        1 => rng.random_range(-1e6..1e6),
        _ => rng.random_range(-1.0..1.0),
    }
}

fn commands_stay_bounded<T: Real>(seed: u64) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    for law in laws::<T>() {
        let mut c = controller(law);
        let mut last = WheelTorque::<T>::default();
        for i in 0..60_000 {
            // Mostly sane calls, so that the laws run and do not stand latched all the time.
            let sane = rng.random_range(0..50) != 0;
            let mut n = || {
                T::of(if sane {
                    rng.random_range(-0.5..0.5)
                } else {
                    garbage(&mut rng)
                })
            };
            if i % 5 == 0 {
                let pose = Pose {
                    x: n(),
                    y: n(),
                    heading: n(),
                };
                let reference = ReferenceSample {
                    pose: Pose {
                        x: n(),
                        y: n(),
                        heading: n(),
                    },
                    velocity: Velocity {
                        linear: n(),
                        angular: n(),
                    },
                    acceleration: Velocity {
                        linear: n(),
                        angular: n(),
                    },
                };
                let age = n();
                c.track(
                    &pose,
                    if sane { age.abs() * T::of(0.1) } else { age },
                    &reference,
                );
            }
            let velocity = Velocity {
                linear: n(),
                angular: n(),
            };
            let dt = if sane { T::of(0.002) } else { n() };
            let torque = c.torque(velocity, dt);
            let slack = T::of(1e-5);
            assert!(torque.is_finite(), "{torque:?}");
            assert!(
                torque.right.abs() <= T::of(3.0) && torque.left.abs() <= T::of(3.0),
                "{torque:?}"
            );
            if sane {
                let reach = T::of(60.0 * 0.002) + slack;
                assert!(
                    (torque.right - last.right).abs() <= reach
                        && (torque.left - last.left).abs() <= reach
                );
            }
            last = torque;
            if i % 97 == 0 {
                c.rearm();
            }
        }
    }
}

#[test]
fn every_command_is_finite_and_bounded() {
    commands_stay_bounded::<f64>(5);
    commands_stay_bounded::<f32>(6);
}

fn reference(t: f64) -> ReferenceSample<f64> {
    ReferenceSample {
        pose: Pose {
            x: 0.2 * t,
            y: 0.0,
            heading: 0.0,
        },
        velocity: Velocity {
            linear: 0.2,
            angular: 0.0,
        },
        acceleration: Velocity::default(),
    }
}

/// A robot on a straight line: mass 1.43 kg, inertia 0.0152 kg m^2, drag in N. Returns (controller, speed) after `seconds`.
fn drive(c: &mut RobotController<f64>, seconds: f64, drag: f64, feed: impl Fn(f64) -> bool) -> f64 {
    let (h, mut v, mut pose) = (
        0.002,
        Velocity {
            linear: 0.2,
            angular: 0.0,
        },
        Pose {
            x: 0.0,
            y: 0.01,
            heading: 0.0,
        },
    );
    for i in 0..(seconds / h) as usize {
        let t = i as f64 * h;
        if i % 5 == 0 && feed(t) {
            c.track(&pose, 0.0, &reference(t));
        }
        let torque = c.torque(v, h);
        let force = (torque.right + torque.left) / 0.033;
        let turn = (torque.right - torque.left) * 0.144 / 0.033;
        v.linear += h * (force - drag * (v.linear / 0.005).clamp(-1.0, 1.0)) / 1.43;
        v.angular += h * turn / 0.0152;
        pose.x += h * v.linear * pose.heading.cos();
        pose.y += h * v.linear * pose.heading.sin();
        pose.heading += h * v.angular;
    }
    v.linear
}

#[test]
fn drag_makes_the_printed_law_drift_and_not_the_others() {
    for (law, drifts) in laws().into_iter().zip([true, false, false]) {
        let mut c = controller(law);
        drive(&mut c, 20.0, 0.4, |_| true);
        assert_eq!(c.mode(), Mode::Running);
        let error = c.error().along.hypot(c.error().across);
        assert_eq!(error > 0.5, drifts, "{law:?}: {error} m");
        assert!(drifts || error < 0.01, "{law:?}: {error} m");
    }
}

#[test]
fn stale_poses_stop_the_robot_until_it_is_rearmed() {
    for law in laws() {
        let mut c = controller(law);
        drive(&mut c, 1.0, 0.1, |_| true);
        assert_eq!(c.mode(), Mode::Running);
        drive(&mut c, 0.18, 0.1, |_| false);
        assert_eq!(
            c.mode(),
            Mode::Running,
            "190 ms are not stale (the last pose came 10 ms before)"
        );
        let speed = drive(&mut c, 1.5, 0.1, |_| false);
        assert_eq!(c.mode(), Mode::Stopped(StopCause::StalePose));
        assert!(speed.abs() < 0.02, "{law:?}: still {speed} m/s");
        drive(&mut c, 0.5, 0.1, |_| true);
        assert_eq!(
            c.mode(),
            Mode::Stopped(StopCause::StalePose),
            "good poses must not end a latched stop"
        );
        c.rearm();
        drive(&mut c, 0.5, 0.1, |_| true);
        assert_eq!(c.mode(), Mode::Running);
    }
}

#[test]
fn bad_inputs_stop_with_their_cause() {
    let good = Pose {
        x: 0.0,
        y: 0.0,
        heading: 0.0,
    };
    let nan = Pose {
        x: f64::NAN,
        ..good
    };
    let start = || {
        let mut c = controller(LawParameters::Mrac(MracGains::default()));
        c.track(&good, 0.0, &reference(0.0));
        c
    };
    let mut c = start();
    c.track(&nan, 0.0, &reference(0.0));
    assert_eq!(c.mode(), Mode::Stopping(StopCause::InvalidPose));
    c.stop(StopCause::Supervisor);
    assert_eq!(
        c.mode(),
        Mode::Stopping(StopCause::InvalidPose),
        "the first cause stays"
    );
    let mut c = start();
    c.track(&good, 0.201, &reference(0.0));
    assert_eq!(c.mode(), Mode::Stopping(StopCause::StalePose));
    let mut c = start();
    c.track(
        &good,
        0.0,
        &ReferenceSample {
            velocity: Velocity {
                linear: f64::INFINITY,
                angular: 0.0,
            },
            ..reference(0.0)
        },
    );
    assert_eq!(c.mode(), Mode::Stopping(StopCause::InvalidReference));
    let mut c = start();
    c.torque(
        Velocity {
            linear: 0.0,
            angular: f64::NAN,
        },
        0.002,
    );
    assert_eq!(c.mode(), Mode::Stopping(StopCause::InvalidVelocity));
}

#[test]
fn a_stop_is_smooth() {
    let mut c = controller(LawParameters::Mrac(MracGains::default()));
    let h = 0.002;
    let mut v = drive(&mut c, 3.0, 0.4, |_| true);
    c.stop(StopCause::Supervisor);
    let mut hardest: f64 = 0.0;
    for _ in 0..500 {
        let torque = c.torque(
            Velocity {
                linear: v,
                angular: 0.0,
            },
            h,
        );
        let a =
            ((torque.right + torque.left) / 0.033 - 0.4 * (v / 0.005_f64).clamp(-1.0, 1.0)) / 1.43;
        hardest = hardest.max(a.abs());
        v += h * a;
        assert!(v > -0.01, "a stop must not drive back: {v}");
    }
    assert!(v.abs() < 0.01, "{v}");
    // 0.2 m/s in 0.5 s takes 0.6 m/s^2 at the steepest; twice that is still smooth.
    assert!(hardest < 1.2, "{hardest} m/s^2");
}

/// A robot that has not moved yet, or is held, stays where it is when it is told to stop.
#[test]
fn a_stop_starts_no_motion() {
    for law in laws::<f64>() {
        let mut c = controller(law);
        let good = Pose {
            x: 0.0,
            y: 0.0,
            heading: 0.0,
        };
        c.track(&good, 0.0, &reference(0.0));
        c.torque(Velocity::default(), 0.002);
        assert!(c.desired().velocity.linear > 0.1, "it was about to drive");
        c.stop(StopCause::Supervisor);
        let (h, mut v, mut way) = (0.002, 0.0, 0.0);
        for _ in 0..500 {
            let velocity = Velocity {
                linear: v,
                angular: 0.0,
            };
            let torque = c.torque(velocity, h);
            v += h * (torque.right + torque.left) / 0.033 / 1.43;
            way += h * v;
            assert!(c.commanded().linear.abs() < 1e-3, "{:?}", c.commanded());
        }
        assert!(
            way.abs() < 2e-3 && v.abs() < 1e-3,
            "{law:?}: {way} m, {v} m/s"
        );
    }
}

#[test]
fn f32_and_f64_agree() {
    for (wide, narrow) in laws::<f64>().into_iter().zip(laws::<f32>()) {
        let (mut a, mut b) = (controller(wide), controller(narrow));
        let mut worst: f64 = 0.0;
        for i in 0..10_000 {
            let t = f64::from(i) * 0.002;
            let (x, y, heading) = (
                0.2 * t + 0.01 * (3.0 * t).sin(),
                0.02 * (2.0 * t).cos(),
                0.1 * (1.5 * t).sin(),
            );
            if i % 5 == 0 {
                let r = reference(t);
                a.track(&Pose { x, y, heading }, 0.01, &r);
                let narrow = ReferenceSample {
                    pose: Pose {
                        x: r.pose.x as f32,
                        y: 0.0,
                        heading: 0.0,
                    },
                    velocity: Velocity {
                        linear: 0.2,
                        angular: 0.0,
                    },
                    acceleration: Velocity::default(),
                };
                b.track(
                    &Pose {
                        x: x as f32,
                        y: y as f32,
                        heading: heading as f32,
                    },
                    0.01,
                    &narrow,
                );
            }
            let (nu, omega) = (0.2 + 0.02 * (5.0 * t).sin(), 0.1 * (4.0 * t).cos());
            let wide = a.torque(
                Velocity {
                    linear: nu,
                    angular: omega,
                },
                0.002,
            );
            let narrow = b.torque(
                Velocity {
                    linear: nu as f32,
                    angular: omega as f32,
                },
                0.002,
            );
            worst = worst.max((wide.right - f64::from(narrow.right)).abs());
            worst = worst.max((wide.left - f64::from(narrow.left)).abs());
        }
        assert!(worst < 2e-4, "{wide:?}: torques differ by {worst} N m");
        assert_eq!(a.mode(), b.mode());
    }
}

#[test]
fn a_step_allocates_nothing() {
    for law in laws::<f64>() {
        let mut c = controller(law);
        let info = allocation_counter::measure(|| {
            drive(&mut c, 1.0, 0.2, |t| t < 0.5);
        });
        assert_eq!(info.count_total, 0, "{law:?}");
    }
}

#[test]
fn a_cut_torque_keeps_its_direction() {
    let mut limiter = TorqueLimiter::new(3.0, 1e6);
    let (torque, cut) = limiter.limit(
        WheelTorque {
            right: 12.0,
            left: -4.0,
        },
        0.002,
    );
    assert!(
        cut && (torque.right - 3.0).abs() < 1e-12 && (torque.left + 1.0).abs() < 1e-12,
        "{torque:?}"
    );
    let (torque, cut) = limiter.limit(
        WheelTorque {
            right: 1.0,
            left: 2.0,
        },
        0.002,
    );
    assert!(!cut && torque.left == 2.0);
    let (torque, cut) = TorqueLimiter::new(3.0, 60.0).limit(
        WheelTorque {
            right: 1.0,
            left: 0.0,
        },
        0.002,
    );
    assert!(cut && (torque.right - 0.12).abs() < 1e-12, "{torque:?}");
}

#[test]
fn bad_parameters_are_named() {
    let mut p = ControllerParameters::<f64>::with_law(LawParameters::ModelBased);
    p.model.wheel_radius = 0.0;
    let error = RobotController::new(&p).unwrap_err();
    assert_eq!(error.name, "model.wheel_radius");
    assert!(
        error
            .to_string()
            .contains("is 0, but it must be finite and above 0"),
        "{error}"
    );
}
