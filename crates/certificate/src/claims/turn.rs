use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_model::numbers::angle;

/// The heading change per step is at most `max_turn`, headings being continuous; margin in rad.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let mut tightest = Tightest::new();
    let limit = subject.scene.planner.max_turn;
    for (side, i, from, to) in subject.robot_steps() {
        let turn = (to.heading - from.heading).abs();
        tightest.consider(limit - turn, i, from.position(), || {
            format!("{side} turns {}, limit {}", angle(turn), angle(limit))
        });
    }
    tightest
}
