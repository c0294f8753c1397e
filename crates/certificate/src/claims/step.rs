use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_model::numbers::length;

/// The distance per step is at most `max_step`; margin in m.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let mut tightest = Tightest::new();
    let limit = subject.scene.planner.max_step;
    for (side, i, from, to) in subject.robot_steps() {
        let s = from.position().distance(to.position());
        tightest.consider(limit - s, i, from.position(), || {
            format!("{side} moves {}, limit {}", length(s), length(limit))
        });
    }
    tightest
}
