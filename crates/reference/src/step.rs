use crate::polynomial::Cubic;
use pairtrawl_geometry::{Point, Pose};

/// Nodes and weights of Gauss-Legendre quadrature on [0, 1], 6 points.
const NODES: [(f64, f64); 6] = [
    (0.033_765_242_898_423_99, 0.085_662_246_189_585_17),
    (0.169_395_306_766_867_76, 0.180_380_786_524_069_3),
    (0.380_690_406_958_401_55, 0.233_956_967_286_345_52),
    (0.619_309_593_041_598_4, 0.233_956_967_286_345_52),
    (0.830_604_693_233_132_2, 0.180_380_786_524_069_3),
    (0.966_234_757_101_576, 0.085_662_246_189_585_17),
];

/// The next waypoint is met to this part of the longest chord.
const MET: f64 = 2e-12;
/// A waypoint that is missed by less than this part of the longest chord is met.
const ROUNDING: f64 = 1e-11;
/// The heading strays from its cubic by at most a sixteenth of this, rad: where a short chord would need more, its direction
/// is rounding and it is not met.
const GREATEST_BUMP: f64 = 2.0;

/// One robot's way through one step of the plan, over w from 0 to 1: it rolls without slip from waypoint to waypoint.
///
/// Speed s(w) = s0 (1 - w) + s1 w + 6 a w (1 - w), m a step; heading phi(w) = cubic through both headings with rates t0 and t1,
/// plus b w^2 (1 - w)^2; position = integral of s (cos phi, sin phi). a and b make the end the next waypoint. Speed is a
/// quadratic and turning rate a cubic polynomial, so that their bounds over any stretch are exact.
#[derive(Clone, Copy, Debug)]
pub struct RollingStep {
    start: Pose,
    end: Pose,
    speed: Cubic,
    rate: Cubic,
    /// On this many equal parts the quadrature is exact to rounding: 1 where the heading changes little.
    panels: u32,
}

/// Where a robot is at a place of a step and how it moves, with derivatives by w.
#[derive(Clone, Copy, Debug)]
pub struct StepState {
    /// Where it is.
    pub pose: Pose,
    /// s, m a step.
    pub speed: f64,
    /// ds/dw.
    pub speed_slope: f64,
    /// dphi/dw, rad a step.
    pub rate: f64,
    /// d2phi/dw2.
    pub rate_slope: f64,
}

/// What holds for certain at every place of a stretch of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepBounds {
    /// Least and greatest speed s, m a step.
    pub speed: [f64; 2],
    /// Least and greatest turning rate dphi/dw, rad a step.
    pub rate: [f64; 2],
    /// Greatest magnitude of ds/dw.
    pub speed_slope: f64,
    /// Greatest magnitude of d2phi/dw2.
    pub rate_slope: f64,
    /// Greatest magnitude of d2s/dw2.
    pub speed_bend: f64,
    /// Greatest magnitude of d3phi/dw3.
    pub rate_bend: f64,
}

impl StepBounds {
    /// Greatest magnitude of the speed, m a step.
    pub fn fastest(&self) -> f64 {
        self.speed[1].max(-self.speed[0])
    }

    /// Greatest magnitude of the turning rate, rad a step.
    pub fn sharpest(&self) -> f64 {
        self.rate[1].max(-self.rate[0])
    }
}

/// How a step begins and ends.
pub(crate) struct Ends {
    /// Speeds at the waypoints before and after, m a step.
    pub speed: [f64; 2],
    /// Turning rates there, rad a step.
    pub rate: [f64; 2],
}

impl RollingStep {
    /// From a pose to a waypoint; `unit` is the trajectory's longest chord, m.
    pub(crate) fn between(start: Pose, end: Pose, ends: &Ends, unit: f64) -> Self {
        let chord = end.position() - start.position();
        let turn = end.heading - start.heading;
        let along = chord.dot(Point::unit(start.heading + 0.5 * turn));
        let mut bumps = [along - 0.5 * (ends.speed[0] + ends.speed[1]), 0.0];
        let plain = Self::with_bumps(start, turn, ends, bumps);
        let mut step = plain;
        // Newton's method for the bumps (a, b): the end lies `chord` from the start.
        for _ in 0..8 {
            let (mut miss, mut by_a, mut by_b) = (chord, Point::ZERO, Point::ZERO);
            step.integrate(1.0, |w, weight, forward| {
                let (bump, speed) = (w * (1.0 - w), step.speed.at(w));
                miss -= forward * (weight * speed);
                by_a += forward * (weight * 6.0 * bump);
                by_b += forward.perp() * (weight * speed * bump * bump);
            });
            let determinant = by_a.cross(by_b);
            if miss.norm() <= MET * unit {
                break;
            }
            bumps[0] += miss.cross(by_b) / determinant;
            bumps[1] += by_a.cross(miss) / determinant;
            // Also what is not a number is no bump.
            if !(bumps[1].abs() <= GREATEST_BUMP && bumps[0].is_finite()) {
                step = plain;
                break;
            }
            step = Self::with_bumps(start, turn, ends, bumps);
        }
        let place = step.rolled(1.0);
        let met = place.distance(end.position()) <= ROUNDING * unit;
        step.end = if met {
            end
        } else {
            Pose::at(place, end.heading)
        };
        step
    }

    fn with_bumps(start: Pose, turn: f64, ends: &Ends, [a, b]: [f64; 2]) -> Self {
        let ([s0, s1], [t0, t1]) = (ends.speed, ends.rate);
        let sum = turn.abs() + t0.abs() + t1.abs();
        Self {
            start,
            end: start,
            speed: Cubic([s0, s1 - s0 + 6.0 * a, -6.0 * a, 0.0]),
            rate: Cubic([
                t0,
                2.0 * (3.0 * turn - 2.0 * t0 - t1 + b),
                3.0 * (t0 + t1 - 2.0 * turn - 2.0 * b),
                4.0 * b,
            ]),
            panels: 1 + (2.0 * sum + 8.0 * b.abs()).min(1e3) as u32,
        }
    }

    /// Calls `part` with w, weight and forward direction for the quadrature from 0 to `end`.
    fn integrate(&self, end: f64, mut part: impl FnMut(f64, f64, Point)) {
        let width = end / f64::from(self.panels);
        for panel in 0..self.panels {
            for (node, weight) in NODES {
                let w = (f64::from(panel) + node) * width;
                part(w, weight * width, Point::unit(self.heading(w)));
            }
        }
    }

    /// The heading at w in [0, 1], continuous along the trajectory, rad.
    pub fn heading(&self, w: f64) -> f64 {
        self.start.heading + self.rate.integral(w)
    }

    /// The position after w, by quadrature, m.
    fn rolled(&self, w: f64) -> Point {
        let mut place = self.start.position();
        self.integrate(w, |v, weight, forward| {
            place += forward * (weight * self.speed.at(v));
        });
        place
    }

    /// The pose at w in [0, 1]. Both ends are exact: a waypoint that is met has the plan's own bits.
    pub fn pose(&self, w: f64) -> Pose {
        if w <= 0.0 {
            self.start
        } else if w >= 1.0 {
            self.end
        } else {
            Pose::at(self.rolled(w), self.heading(w))
        }
    }

    /// The state at w in [0, 1].
    pub fn at(&self, w: f64) -> StepState {
        StepState {
            pose: self.pose(w),
            speed: self.speed.at(w),
            speed_slope: self.speed.slope().at(w),
            rate: self.rate.at(w),
            rate_slope: self.rate.slope().at(w),
        }
    }

    /// What holds on the whole stretch from w = `stretch[0]` to `stretch[1]`.
    pub fn bounds(&self, stretch: [f64; 2]) -> StepBounds {
        let (speed_slope, rate_slope) = (self.speed.slope(), self.rate.slope());
        StepBounds {
            speed: self.speed.range(stretch),
            rate: self.rate.range(stretch),
            speed_slope: speed_slope.magnitude(stretch),
            rate_slope: rate_slope.magnitude(stretch),
            speed_bend: speed_slope.slope().magnitude(stretch),
            rate_bend: rate_slope.slope().magnitude(stretch),
        }
    }
}
