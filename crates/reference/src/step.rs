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

/// Below this chord the direction of travel means nothing and no correction of it is tried, m.
const SHORT: f64 = 1e-4;

/// One robot's way through one step of the plan, over w from 0 to 1: it rolls without slip from waypoint to waypoint.
///
/// Speed s(w) = s0 (1 - w) + s1 w + 6 a w (1 - w), m a step; heading phi(w) = cubic through both headings with rates t0 and t1,
/// plus b w^2 (1 - w)^2; position = integral of s (cos phi, sin phi). a and b make the end the next waypoint.
#[derive(Clone, Copy, Debug)]
pub(super) struct RollingStep {
    start: Pose,
    turn: f64,
    speed: [f64; 2],
    rate: [f64; 2],
    speed_bump: f64,
    heading_bump: f64,
}

/// Heading and speed at a place of a step, with derivatives by w.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepState {
    pub pose: Pose,
    pub speed: f64,
    pub speed_slope: f64,
    pub rate: f64,
    pub rate_slope: f64,
}

impl RollingStep {
    /// From a pose to a waypoint, with speeds (m a step) and turning rates (rad a step) at both ends.
    pub fn between(start: Pose, end: Pose, speed: [f64; 2], rate: [f64; 2]) -> Self {
        let chord = end.position() - start.position();
        let mut step = Self {
            start,
            turn: end.heading - start.heading,
            speed,
            rate,
            speed_bump: 0.0,
            heading_bump: 0.0,
        };
        let mid = Point::unit(start.heading + 0.5 * step.turn);
        step.speed_bump = chord.dot(mid) - 0.5 * (speed[0] + speed[1]);
        if chord.norm() > SHORT {
            step.aim(chord);
        }
        step
    }

    /// Newton's method for (a, b): the end lies `chord` from the start.
    fn aim(&mut self, chord: Point) {
        for _ in 0..8 {
            let (mut miss, mut by_a, mut by_b) = (chord, Point::ZERO, Point::ZERO);
            for (w, weight) in NODES {
                let forward = Point::unit(self.heading(w));
                let bump = w * (1.0 - w);
                miss -= forward * (weight * self.speed_at(w));
                by_a += forward * (weight * 6.0 * bump);
                by_b += forward.perp() * (weight * self.speed_at(w) * bump * bump);
            }
            if miss.norm() < 1e-13 {
                return;
            }
            let determinant = by_a.cross(by_b);
            if determinant.abs() < 1e-12 {
                return;
            }
            self.speed_bump += miss.cross(by_b) / determinant;
            // A slip of a tenth of a millimeter on a short chord must not become a wild swing of the heading.
            let change = by_a.cross(miss) / determinant;
            self.heading_bump = (self.heading_bump + change).clamp(-2.0, 2.0);
        }
    }

    fn speed_at(&self, w: f64) -> f64 {
        self.speed[0] * (1.0 - w) + self.speed[1] * w + 6.0 * self.speed_bump * w * (1.0 - w)
    }

    fn heading(&self, w: f64) -> f64 {
        let (w2, w3) = (w * w, w * w * w);
        self.start.heading
            + self.turn * (3.0 * w2 - 2.0 * w3)
            + self.rate[0] * (w3 - 2.0 * w2 + w)
            + self.rate[1] * (w3 - w2)
            + self.heading_bump * w2 * (1.0 - w) * (1.0 - w)
    }

    /// The state at w in [0, 1].
    pub fn at(&self, w: f64) -> StepState {
        let mut place = self.start.position();
        for (v, weight) in NODES {
            let v = v * w;
            place += Point::unit(self.heading(v)) * (w * weight * self.speed_at(v));
        }
        let (w2, [r0, r1]) = (w * w, self.rate);
        StepState {
            pose: Pose::at(place, self.heading(w)),
            speed: self.speed_at(w),
            speed_slope: self.speed[1] - self.speed[0] + 6.0 * self.speed_bump * (1.0 - 2.0 * w),
            rate: self.turn * 6.0 * (w - w2)
                + r0 * (3.0 * w2 - 4.0 * w + 1.0)
                + r1 * (3.0 * w2 - 2.0 * w)
                + self.heading_bump * 2.0 * w * (1.0 - w) * (1.0 - 2.0 * w),
            rate_slope: self.turn * 6.0 * (1.0 - 2.0 * w)
                + r0 * (6.0 * w - 4.0)
                + r1 * (6.0 * w - 2.0)
                + self.heading_bump * (2.0 - 12.0 * w + 12.0 * w2),
        }
    }
}

/// The way of one robot through all its waypoints, speed and turning rate continuous.
pub(super) fn roll_through(poses: &[Pose]) -> Vec<RollingStep> {
    let chords: Vec<(f64, f64)> = poses
        .windows(2)
        .map(|w| {
            let turn = w[1].heading - w[0].heading;
            let mid = Point::unit(w[0].heading + 0.5 * turn);
            ((w[1].position() - w[0].position()).dot(mid), turn)
        })
        .collect();
    // Speed at a waypoint: the harmonic mean of both steps' speeds, which is 0 beside a wait and never makes a robot back up.
    let speed_at = |i: usize| match (i.checked_sub(1).and_then(|j| chords.get(j)), chords.get(i)) {
        (Some(&(a, _)), Some(&(b, _))) if a * b > 0.0 => 2.0 * a * b / (a + b),
        (Some(_), Some(_)) => 0.0,
        (Some(&(a, _)), None) | (None, Some(&(a, _))) => a,
        (None, None) => 0.0,
    };
    // Turning rate at a waypoint: the mean, but 0 beside a wait.
    let waits = |(length, turn): (f64, f64)| length.abs() < 1e-9 && turn.abs() < 1e-9;
    let rate_at = |i: usize| match (i.checked_sub(1).and_then(|j| chords.get(j)), chords.get(i)) {
        (Some(&a), Some(&b)) if !waits(a) && !waits(b) => 0.5 * (a.1 + b.1),
        (Some(_), Some(_)) => 0.0,
        (Some(&(_, a)), None) | (None, Some(&(_, a))) => a,
        (None, None) => 0.0,
    };
    let mut steps = Vec::with_capacity(chords.len());
    let mut start = poses.first().copied().unwrap_or_default();
    for i in 0..chords.len() {
        let ends = [i, i + 1];
        let step = RollingStep::between(start, poses[i + 1], ends.map(speed_at), ends.map(rate_at));
        // Where a short chord could not be met exactly, the next step starts from where this one ends.
        start = Pose::at(step.at(1.0).pose.position(), poses[i + 1].heading);
        steps.push(step);
    }
    steps
}
