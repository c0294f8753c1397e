use crate::subject::Subject;
use crate::tightest::Tightest;

/// Wheel speed (s + half_track |dphi|) / step_time within `v_max`, turning rate |dphi| / step_time within `omega_max`.
///
/// The margin is that of the limit with the least room relative to itself, in m/s or rad/s; the detail says which.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let time = subject.trajectory.step_time;
    if !(time.is_finite() && time > 0.0) {
        return Tightest::unusable(None, format!("step_time {time} s is not a positive number"));
    }
    let robot = &subject.scene.robot;
    let (mut wheel, mut rate) = (Tightest::new(), Tightest::new());
    for (side, i, from, to) in subject.robot_steps() {
        let place = from.position();
        let turn = (to.heading - from.heading).abs();
        let v = (place.distance(to.position()) + robot.half_track * turn) / time;
        let omega = turn / time;
        wheel.consider(robot.v_max - v, i, place, || {
            format!("{side}, a wheel at {v:.4} m/s, limit {} m/s", robot.v_max)
        });
        rate.consider(robot.omega_max - omega, i, place, || {
            format!(
                "{side} turns at {omega:.4} rad/s, limit {} rad/s",
                robot.omega_max
            )
        });
    }
    if wheel.margin() / robot.v_max <= rate.margin() / robot.omega_max
        || wheel.margin() < 0.0 && rate.margin() >= 0.0
    {
        wheel
    } else {
        rate
    }
}
