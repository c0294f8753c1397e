use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::wrap_angle;
use pairtrawl_model::Side;
use pairtrawl_model::numbers::{angle, length};

/// First and last poses are the scene's, to this much, m and rad; on the smooth curve of a large machine to as much of its size.
const REACH: f64 = 1e-6;

/// Positions by distance, headings modulo 2 pi; the margin is in m or rad, whichever is tighter.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let mut tightest = Tightest::new();
    let last = subject.steps();
    let ends = [
        ("start", 0, 0, 0.0, subject.scene.start),
        ("end", last, last - 1, 1.0, subject.scene.end),
    ];
    for (reading, _) in &subject.readings {
        for (what, i, step, w, wanted) in ends {
            for side in Side::BOTH {
                let found = reading.pose(side, step, w);
                let wanted = [wanted.left, wanted.right][side.index()];
                let (place, on) = (found.position(), reading.suffix());
                let off = place.distance(wanted.position());
                let reach = reading.tolerance(REACH, subject.scene);
                tightest.consider(reach - off, i, place, || {
                    format!("{side}, {} from the scene's {what}{on}", length(off))
                });
                let turned = wrap_angle(found.heading - wanted.heading).abs();
                tightest.consider(REACH - turned, i, place, || {
                    format!(
                        "{side}, heading {} from the scene's {what}{on}",
                        angle(turned)
                    )
                });
            }
        }
    }
    tightest
}
