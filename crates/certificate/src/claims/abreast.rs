use crate::motion::Stretch;
use crate::search::{Bound, least};
use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::{Point, Pose, Segment, wrap_angle};
use pairtrawl_model::numbers::angle;
use pairtrawl_model::{PairPose, Side};

/// Each heading is within `max_skew` of the vector from the right to the left robot turned by -90 degrees: at every waypoint
/// but the first and last, and for a plan that is driven by its reference at every instant between the second waypoint and
/// the last but one; margin in rad.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let mut tightest = Tightest::new();
    let limit = subject.scene.planner.max_skew;
    let last = subject.steps();
    for i in 1..last {
        let pair = subject.trajectory.pair(i);
        if pair.separation() == 0.0 {
            return Tightest::unusable(
                Some(i),
                "the robots are at the same point: no line between them",
            );
        }
        for side in Side::BOTH {
            let pose = [pair.left, pair.right][side.index()];
            let skew = skew(pose, [pair.left, pair.right]).abs();
            tightest.consider(limit - skew, i, pose.position(), || {
                words(side, skew, limit)
            });
        }
    }
    if !subject.is_driven() {
        return tightest;
    }
    for (reading, steps) in &subject.readings {
        for side in Side::BOTH {
            let between = steps.get(1..last - 1).unwrap_or_default();
            least(reading, between, &mut tightest, |stretch, _| {
                let (skew, slack) = greatest_skew(stretch, side);
                Some(Bound {
                    margin: limit - skew,
                    slack,
                    place: stretch.from[side.index()].position(),
                    detail: move || words(side, skew, limit),
                })
            });
        }
    }
    tightest
}

fn words(side: Side, skew: f64, limit: f64) -> String {
    format!(
        "{} robot is skewed by {}, limit {}",
        side.name(),
        angle(skew),
        angle(limit)
    )
}

/// The angle of a heading against the normal of the line between two robots, rad.
fn skew(pose: Pose, [left, right]: [Pose; 2]) -> f64 {
    wrap_angle(pose.heading - PairPose { left, right }.normal_heading())
}

/// A bound of the greatest skew over a stretch, and how much above the greatest at its ends it is.
///
/// The skew is a heading minus the angle of the vector D between the robots. The heading strays from even turning by a known
/// amount. Were D even between D0 and D1, the second derivative of its angle would be at most |D1 - D0|^2 / |D|^2, which makes
/// an eighth of that; D strays from evenness by at most the bows of both robots, which turns it by at most
/// asin(bows / |D|).
fn greatest_skew(stretch: &Stretch, side: Side) -> (f64, f64) {
    let ends = [stretch.from, stretch.to].map(|pair| skew(pair[side.index()], pair).abs());
    let [l0, l1, r1, r0] = stretch.corners();
    let between = Segment::new(l0 - r0, l1 - r1);
    let nearest = between.distance(Point::ZERO);
    let bows = stretch.bow(Side::Left) + stretch.bow(Side::Right);
    let slack = if nearest > bows {
        let turn = between.length() / nearest;
        stretch.heading_bow(side) + turn * turn / 8.0 + libm::asin(bows / nearest)
    } else {
        std::f64::consts::PI
    };
    (ends[0].max(ends[1]) + slack, slack)
}
