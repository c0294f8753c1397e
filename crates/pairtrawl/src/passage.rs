//! Where the line between the robots passes over a point.

use pairtrawl_geometry::{Point, Segment, SweptLine};
use pairtrawl_model::PairTrajectory;

/// The first step in which the line between the robots passes over a point, and when in it, in [0, 1]; poses are linear
/// between waypoints. `None`: it never does.
pub(crate) fn first_passage(pair: &PairTrajectory, point: Point) -> Option<(usize, f64)> {
    let steps = pair.left.windows(2).zip(pair.right.windows(2));
    steps.enumerate().find_map(|(step, (l, r))| {
        let line = SweptLine {
            left: Segment::new(l[0].position(), l[1].position()),
            right: Segment::new(r[0].position(), r[1].position()),
        };
        Some((step, line.coverage(point).instant?))
    })
}
