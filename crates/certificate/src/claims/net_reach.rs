use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::{Point, Pose};

/// The certified bound lies at most this far above the true maximum, m.
const ACCURACY: f64 = 1e-11;
/// Splits of one step before its current bound is taken as it is (still an upper bound); never reached by steps whose
/// turn is within the limits.
const SPLITS: usize = 4096;

/// At every instant the distance between the two hitch points is at most d_max; margin in m.
///
/// The vector between the hitches is d(t) = d0 + t v - h (u(phi_l + t w_l) - u(phi_r + t w_r)) over a step, t in [0, 1].
/// On a piece of half-width r around m it stays within K r^2 / 2 of its chord, K = |d''(m)| + r h (|w_l|^3 + |w_r|^3),
/// so |d| is at most the greater of its ends plus that. Pieces whose bound exceeds the greatest distance seen by more
/// than the accuracy are halved.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let length = subject.net_length;
    if !(length.is_finite() && length > 0.0) {
        return Tightest::unusable(
            None,
            format!("the net length {length} m is not a positive number"),
        );
    }
    let (left, right) = (&subject.trajectory.left, &subject.trajectory.right);
    let mut seen = f64::NEG_INFINITY;
    let mut tightest = Tightest::new();
    for i in 0..subject.steps() {
        let hitches = Hitches {
            left: [left[i], left[i + 1]],
            right: [right[i], right[i + 1]],
            hitch: subject.scene.robot.hitch,
        };
        let (bound, t) = hitches.greatest_distance(&mut seen);
        let place = hitches.points(t).0.lerp(hitches.points(t).1, 0.5);
        tightest.consider(length - bound, i, place, || {
            format!("the hitches are up to {bound:.4} m apart, the net is {length} m long")
        });
    }
    tightest
}

/// The motion of both hitch points over a step.
struct Hitches {
    left: [Pose; 2],
    right: [Pose; 2],
    hitch: f64,
}

impl Hitches {
    fn points(&self, t: f64) -> (Point, Point) {
        let at = |[from, to]: [Pose; 2]| if t == 1.0 { to } else { from.lerp(to, t) };
        (
            at(self.left).hitch_point(self.hitch),
            at(self.right).hitch_point(self.hitch),
        )
    }

    fn distance(&self, t: f64) -> f64 {
        let (left, right) = self.points(t);
        left.distance(right)
    }

    /// How far |d| may exceed the greater of its values at the ends of a piece.
    fn sag(&self, middle: f64, half_width: f64) -> f64 {
        let rate = |[from, to]: [Pose; 2]| to.heading - from.heading;
        let heading = |[from, to]: [Pose; 2]| from.lerp(to, middle).heading;
        let (wl, wr) = (rate(self.left), rate(self.right));
        let second = (Point::unit(heading(self.left)) * (wl * wl)
            - Point::unit(heading(self.right)) * (wr * wr))
            .norm();
        let third = wl.abs().powi(3) + wr.abs().powi(3);
        0.5 * self.hitch.abs() * (second + half_width * third) * half_width * half_width
    }

    /// An upper bound of the distance over the step and an instant near its maximum. `seen` is the greatest distance
    /// met in earlier steps: pieces that cannot exceed it are not refined.
    fn greatest_distance(&self, seen: &mut f64) -> (f64, f64) {
        let mut best = (f64::NEG_INFINITY, 0.0);
        let mut pieces = vec![(0.0, self.distance(0.0), 1.0, self.distance(1.0))];
        let mut splits = 0;
        while let Some((a, at_a, b, at_b)) = pieces.pop() {
            let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
            let (ends, t) = if at_b > at_a { (at_b, b) } else { (at_a, a) };
            *seen = seen.max(ends);
            let bound = ends + self.sag(middle, half);
            if bound > *seen + ACCURACY && splits < SPLITS {
                splits += 1;
                let at_middle = self.distance(middle);
                pieces.push((a, at_a, middle, at_middle));
                pieces.push((middle, at_middle, b, at_b));
            } else if bound.is_nan() || bound > best.0 {
                best = (bound, t);
            }
        }
        best
    }
}
