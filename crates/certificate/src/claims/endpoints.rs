use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::wrap_angle;

/// First and last poses are the scene's, to this much, m and rad.
const REACH: f64 = 1e-6;

/// Positions by distance, headings modulo 2 pi; the margin is in m or rad, whichever is tighter.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let mut tightest = Tightest::new();
    let last = subject.steps();
    let pairs = [
        ("start", 0, subject.scene.start),
        ("end", last, subject.scene.end),
    ];
    for (what, i, wanted) in pairs {
        let found = subject.trajectory.pair(i);
        for (side, found, wanted) in [
            ("left", found.left, wanted.left),
            ("right", found.right, wanted.right),
        ] {
            let place = found.position();
            let off = place.distance(wanted.position());
            tightest.consider(REACH - off, i, place, || {
                format!("{side} robot, {off:.3e} m from the scene's {what}")
            });
            let turned = wrap_angle(found.heading - wanted.heading).abs();
            tightest.consider(REACH - turned, i, place, || {
                format!("{side} robot, heading {turned:.3e} rad from the scene's {what}")
            });
        }
    }
    tightest
}
