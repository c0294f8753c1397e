use crate::motion::Reading;
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::Point;
use pairtrawl_model::Side;
use pairtrawl_model::numbers::length;

/// A step may go back by this much, m: the rounding of a written plan.
const BACK: f64 = 1e-6;

/// The displacement of each step along the mid-step heading is at least -1e-6 m, and so is the speed along the smooth curve
/// at every instant, in m a step; margin in m.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let mut tightest = Tightest::new();
    for (side, i, from, to) in subject.robot_steps() {
        let middle = Point::unit(from.lerp(to, 0.5).heading);
        let along = (to.position() - from.position()).dot(middle);
        tightest.consider(along + BACK, i, from.position(), || {
            format!("{side} moves {} forward", length(along))
        });
    }
    for (reading, steps) in &subject.readings {
        let Reading::Smooth(reference) = reading else {
            continue;
        };
        for side in Side::BOTH {
            for (step, curve) in steps.iter().zip(reference.steps(side)) {
                let [slowest, _] = curve.bounds([0.0, 1.0]).speed;
                let place = step.from[side.index()].position();
                let back = reading.tolerance(BACK, subject.scene);
                tightest.consider(slowest + back, step.step, place, || {
                    let on = reading.suffix();
                    format!("{side} slows down to {} a step{on}", length(slowest))
                });
            }
        }
    }
    tightest
}
