//! The pair stops together and stays stopped.

use pairtrawl_control::{
    PairRobot, PairState, PairStopCause, PairSupervisor, RobotReport, StopCause, SupervisorLimits,
};

const FINE: RobotReport<f64> = RobotReport {
    tracking_error: 0.02,
    silence: 0.01,
    tension: 0.5,
    stopped: None,
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
                silence: 0.11,
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
                stopped: Some(StopCause::InvalidPose),
                ..FINE
            },
            PairStopCause::RobotStopped(StopCause::InvalidPose),
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
        for robot in [PairRobot::Left, PairRobot::Right] {
            let mut s = PairSupervisor::new(SupervisorLimits::default()).unwrap();
            assert_eq!(s.update(&FINE, &FINE), PairState::Running);
            let (a, b) = match robot {
                PairRobot::Left => (bad, FINE),
                PairRobot::Right => (FINE, bad),
            };
            assert_eq!(s.update(&a, &b), PairState::Stopped { cause, robot });
            assert_eq!(
                s.update(&FINE, &FINE),
                PairState::Stopped { cause, robot },
                "latched"
            );
            s.rearm();
            assert_eq!(s.update(&FINE, &FINE), PairState::Running);
        }
    }
}

#[test]
fn a_silent_robot_is_named_as_silent_even_when_it_has_stopped() {
    let silent = RobotReport {
        silence: 0.2,
        stopped: Some(StopCause::StalePose),
        ..FINE
    };
    let mut s = PairSupervisor::new(SupervisorLimits::default()).unwrap();
    let cause = PairStopCause::Silence;
    let robot = PairRobot::Right;
    assert_eq!(
        s.update(&FINE, &silent),
        PairState::Stopped { cause, robot }
    );
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
