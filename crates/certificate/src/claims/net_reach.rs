use crate::farthest::greatest_distance;
use crate::search::{Bound, least};
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_model::numbers;

/// At every instant the distance between the two hitch points is at most d_max; margin in m.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let length = subject.net_length;
    if !(length.is_finite() && length > 0.0) {
        return Tightest::unusable(
            None,
            format!("the net length {length} m is not a positive number"),
        );
    }
    let hitch = subject.scene.robot.hitch;
    let mut tightest = Tightest::new();
    for (reading, steps) in &subject.readings {
        least(reading, steps, &mut tightest, |stretch, so_far| {
            let (bound, slack, place) =
                greatest_distance(reading, stretch, hitch, length - so_far)?;
            Some(Bound {
                margin: length - bound,
                slack,
                place,
                detail: move || {
                    format!(
                        "the hitches are up to {} apart, the net is {} long",
                        numbers::length(bound),
                        numbers::length(length)
                    )
                },
            })
        });
    }
    tightest
}
