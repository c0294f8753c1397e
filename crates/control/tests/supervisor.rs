//! The pair stops together and stays stopped.

use pairtrawl_control::{PairState, PairStopCause, PairSupervisor, RobotReport, SupervisorLimits};

const FINE: RobotReport<f64> = RobotReport {
    tracking_error: 0.02,
    silence: 0.01,
    tension: 0.5,
    stopped: false,
};

#[test]
fn each_cause_stops_the_pair_from_either_side() {
    let cases = [
        (
            RobotReport {
                tracking_error: 0.26,
                ..FINE
            },
            PairStopCause::TrackingError,
        ),
        (
            RobotReport {
                silence: 0.21,
                ..FINE
            },
            PairStopCause::Silence,
        ),
        (
            RobotReport {
                tension: 10.1,
                ..FINE
            },
            PairStopCause::Tension,
        ),
        (
            RobotReport {
                stopped: true,
                ..FINE
            },
            PairStopCause::RobotStopped,
        ),
        (
            RobotReport {
                tension: f64::NAN,
                ..FINE
            },
            PairStopCause::InvalidReport,
        ),
    ];
    for (bad, cause) in cases {
        for left in [true, false] {
            let mut s = PairSupervisor::new(SupervisorLimits::default()).unwrap();
            assert_eq!(s.update(&FINE, &FINE), PairState::Running);
            let (a, b) = if left { (bad, FINE) } else { (FINE, bad) };
            assert_eq!(s.update(&a, &b), PairState::Stopped { cause, left });
            assert_eq!(
                s.update(&FINE, &FINE),
                PairState::Stopped { cause, left },
                "latched"
            );
            s.rearm();
            assert_eq!(s.update(&FINE, &FINE), PairState::Running);
        }
    }
}

#[test]
fn limits_must_be_positive() {
    assert!(
        PairSupervisor::new(SupervisorLimits {
            silence: 0.0,
            ..SupervisorLimits::<f64>::default()
        })
        .is_err()
    );
}
