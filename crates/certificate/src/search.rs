use crate::motion::{Reading, Stretch};
use crate::tightest::Tightest;
use pairtrawl_geometry::Point;

/// What is known of a claim's margin over a stretch.
pub(crate) struct Bound<F> {
    /// The margin is nowhere less.
    pub(crate) margin: f64,
    /// The least margin is at most this much more; 0 when the bound is attained.
    pub(crate) slack: f64,
    /// Where it is tight.
    pub(crate) place: Point,
    /// Says what it is about, for people.
    pub(crate) detail: F,
}

/// A bound this close is taken as it is.
const FINE: f64 = 1e-11;
/// On the smooth curve this is close enough where the claim holds: for a margin that people read.
const COARSE: f64 = 1e-7;
/// Splits of one step before its bounds are taken as they are (they still are bounds); never reached by steps whose turn
/// is within the limits.
const SPLITS: usize = 4096;

/// Finds the least margin over steps by branch and bound.
///
/// `bound` gives the bound over a stretch, or `None` where it cannot be below the margin that it is passed. Stretches whose
/// bound is below the least margin so far are halved until their bound is close, the more promising half first.
pub(crate) fn least<F: FnOnce() -> String>(
    reading: &Reading<'_>,
    steps: &[Stretch],
    tightest: &mut Tightest,
    bound: impl Fn(&Stretch, f64) -> Option<Bound<F>>,
) {
    for step in steps {
        if let Some(found) = bound(step, tightest.margin()) {
            let mut search = Search {
                reading,
                tightest,
                bound: &bound,
                splits: 0,
            };
            search.refine(step, found);
        }
    }
}

struct Search<'a, 'b, B> {
    reading: &'a Reading<'b>,
    tightest: &'a mut Tightest,
    bound: &'a B,
    splits: usize,
}

impl<F: FnOnce() -> String, B: Fn(&Stretch, f64) -> Option<Bound<F>>> Search<'_, '_, B> {
    fn refine(&mut self, stretch: &Stretch, found: Bound<F>) {
        if found.margin >= self.tightest.margin() {
            return;
        }
        let close = match self.reading {
            Reading::Smooth(_) if found.margin >= 0.0 => COARSE,
            _ => FINE,
        };
        // What is not a number is not refined: it is the worst of all.
        if found.slack <= close || found.margin.is_nan() || self.splits == SPLITS {
            let words = || (found.detail)() + self.reading.suffix();
            let (margin, step) = (found.margin, stretch.step);
            return self.tightest.consider(margin, step, found.place, words);
        }
        self.splits += 1;
        let halves = self.reading.halves(stretch);
        let so_far = self.tightest.margin();
        let [first, second] = halves.each_ref().map(|half| (self.bound)(half, so_far));
        let margin = |b: &Option<Bound<F>>| b.as_ref().map_or(f64::INFINITY, |b| b.margin);
        let order = if margin(&second) < margin(&first) {
            [(&halves[1], second), (&halves[0], first)]
        } else {
            [(&halves[0], first), (&halves[1], second)]
        };
        for (half, found) in order {
            if let Some(found) = found {
                self.refine(half, found);
            }
        }
    }
}
