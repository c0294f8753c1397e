use crate::motion::Reading;
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::Point;
use pairtrawl_model::numbers::speed;
use pairtrawl_model::{Robot, Side};
use pairtrawl_reference::Reference;

/// The halves of a step; on each the square of the reference's pace is linear.
const HALVES: [[f64; 2]; 2] = [[0.0, 0.5], [0.5, 1.0]];

/// Wheel speed (s + half_track |dphi|) / step_time within `v_max`, turning rate |dphi| / step_time within `omega_max`; on the
/// smooth curve both at every instant by its time law.
///
/// The margin is that of the limit with the least room relative to itself, in m/s or rad/s; the detail says which. On the
/// smooth curve it is a bound: greatest speed, turning rate and pace of each half step are taken together.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let time = subject.trajectory.step_time;
    if !(time.is_finite() && time > 0.0) {
        return Tightest::unusable(None, format!("step_time {time} s is not a positive number"));
    }
    let mut speeds = Speeds {
        robot: &subject.scene.robot,
        wheel: Tightest::new(),
        turning: Tightest::new(),
    };
    for (side, i, from, to) in subject.robot_steps() {
        let forward = from.position().distance(to.position()) / time;
        let turning = (to.heading - from.heading).abs() / time;
        speeds.consider(side, i, from.position(), [forward, turning], "");
    }
    for (reading, _) in &subject.readings {
        if let Reading::Smooth(reference) = reading {
            speeds.consider_reference(reference, reading.suffix());
        }
    }
    speeds.tighter()
}

struct Speeds<'a> {
    robot: &'a Robot,
    wheel: Tightest,
    turning: Tightest,
}

impl Speeds<'_> {
    fn consider(
        &mut self,
        side: Side,
        step: usize,
        place: Point,
        [forward, turning]: [f64; 2],
        on: &str,
    ) {
        let Robot {
            v_max, omega_max, ..
        } = *self.robot;
        let wheel = forward + self.robot.half_track * turning;
        self.wheel.consider(v_max - wheel, step, place, || {
            format!(
                "{side}, a wheel at {}, limit {}{on}",
                speed(wheel),
                speed(v_max)
            )
        });
        self.turning.consider(omega_max - turning, step, place, || {
            format!("{side} turns at {turning:.3} rad/s, limit {omega_max} rad/s{on}")
        });
    }

    fn consider_reference(&mut self, reference: &Reference, on: &str) {
        for side in Side::BOTH {
            for (i, step) in reference.steps(side).iter().enumerate() {
                for half in HALVES {
                    let (bounds, pace) = (step.bounds(half), reference.greatest_pace(i, half));
                    let rates = [bounds.fastest() * pace, bounds.sharpest() * pace];
                    self.consider(side, i, step.pose(half[0]).position(), rates, on);
                }
            }
        }
    }

    fn tighter(self) -> Tightest {
        let (wheel, turning) = (self.wheel.margin(), self.turning.margin());
        let closer = wheel / self.robot.v_max <= turning / self.robot.omega_max;
        if closer || wheel < 0.0 && turning >= 0.0 {
            self.wheel
        } else {
            self.turning
        }
    }
}
