use crate::{Point, Segment};

/// The line between two points that both move linearly over a step: at t in [0, 1] it joins
/// L(t) = l0 + t (l1 - l0) and R(t) = r0 + t (r1 - r0).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweptLine {
    /// The left end at the start and at the end of the step, m.
    pub left: Segment,
    /// The right end at the start and at the end of the step, m.
    pub right: Segment,
}

/// How a swept line passes a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coverage {
    /// When the line passes over the point: the point's distance from the nearer end of the line at that instant, the
    /// best over the step's instants, m. Otherwise minus the point's distance from the four edges of the swept region
    /// (first line, last line, both tracks).
    pub margin: f64,
    /// The instant of the best passage in [0, 1]; `None` when the line does not pass over the point.
    pub instant: Option<f64>,
}

/// Below this distance a point counts as on the line at a root, m: covers the rounding of the root alone.
const ON_LINE: f64 = 1e-11;

impl SweptLine {
    /// The line between the ends at instant t in [0, 1].
    pub fn at(&self, t: f64) -> Segment {
        Segment::new(self.left.at(t), self.right.at(t))
    }

    /// Whether and how safely the line passes over a point within the step.
    ///
    /// The point is on the line's carrier when (R(t) - L(t)) x (p - L(t)) = 0, a quadratic in t.
    pub fn coverage(&self, p: Point) -> Coverage {
        let (d0, e0) = (self.right.a - self.left.a, p - self.left.a);
        let left_motion = self.left.b - self.left.a;
        let stretch = (self.right.b - self.right.a) - left_motion;
        let (a, b, c) = (
            -stretch.cross(left_motion),
            stretch.cross(e0) - d0.cross(left_motion),
            d0.cross(e0),
        );
        let mut best: Option<(f64, f64)> = None;
        for t in candidate_instants(a, b, c) {
            let line = self.at(t);
            let inside = line.a.distance(p).min(line.b.distance(p));
            if line.distance(p) <= ON_LINE && best.is_none_or(|(margin, _)| inside > margin) {
                best = Some((inside, t));
            }
        }
        if let Some((margin, t)) = best {
            return Coverage {
                margin,
                instant: Some(t),
            };
        }
        let away = [self.at(0.0), self.at(1.0), self.left, self.right]
            .iter()
            .map(|edge| edge.distance(p))
            .fold(f64::INFINITY, f64::min);
        Coverage {
            margin: -away,
            instant: None,
        }
    }
}

/// The instants in [0, 1] at which a t^2 + b t + c may vanish: its roots, its vertex (a double root that rounding may
/// hide) and both ends, each clamped.
fn candidate_instants(a: f64, b: f64, c: f64) -> impl Iterator<Item = f64> {
    let discriminant = b * b - 4.0 * a * c;
    // The stable pair q / a and c / q.
    let q = -0.5 * (b + b.signum() * discriminant.max(0.0).sqrt());
    [0.0, 1.0, q / a, c / q, -0.5 * b / a]
        .into_iter()
        .filter(|t| t.is_finite())
        .map(|t| t.clamp(0.0, 1.0))
}
