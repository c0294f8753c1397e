use crate::level::Level;
use crate::random::Random;
use pairtrawl_geometry::Point;
use std::f64::consts::PI;

/// A centerline as a chain of bends, with the half separation of the pair along it.
#[derive(Clone, Debug)]
pub(crate) struct Course {
    start: Point,
    /// Heading at the start, rad.
    heading: f64,
    bends: Vec<Bend>,
    /// Arc length at which each bend begins, and the heading there.
    begins: Vec<(f64, f64)>,
    /// (arc length, half separation), increasing in arc length.
    widths: Vec<(f64, f64)>,
    /// Longest step of the outer robot, m.
    pub(crate) step: f64,
}

/// A stretch of curvature (angle / length)(1 - cos 2 pi t): it starts and ends straight, with a continuous slope of curvature.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bend {
    /// Heading change, rad; 0: straight.
    pub(crate) angle: f64,
    /// Arc length, m.
    pub(crate) length: f64,
}

/// The centerline at one arc length.
pub(crate) struct Station {
    pub(crate) heading: f64,
    pub(crate) curvature: f64,
    pub(crate) half: f64,
    pub(crate) half_slope: f64,
}

impl Course {
    pub(crate) fn new(heading: f64, bends: Vec<Bend>, widths: Vec<(f64, f64)>, step: f64) -> Self {
        let mut begins = Vec::with_capacity(bends.len());
        let (mut at, mut angle) = (0.0, heading);
        for b in &bends {
            begins.push((at, angle));
            at += b.length;
            angle += b.angle;
        }
        Self {
            start: Point::ZERO,
            heading,
            bends,
            begins,
            widths,
            step,
        }
    }

    pub(crate) fn start(&self) -> Point {
        self.start
    }

    /// Heading, curvature and width at arc length `u`; straight on behind the last bend.
    pub(crate) fn station(&self, u: f64) -> Station {
        let after = self.begins.partition_point(|b| b.0 <= u);
        let (heading, curvature) = match after.checked_sub(1) {
            None => (self.heading, 0.0),
            Some(k) => {
                let (begin, angle) = self.begins[k];
                let bend = self.bends[k];
                let t = ((u - begin) / bend.length).min(1.0);
                let turn = bend.angle * (t - libm::sin(2.0 * PI * t) / (2.0 * PI));
                (
                    angle + turn,
                    bend.angle / bend.length * (1.0 - libm::cos(2.0 * PI * t)),
                )
            }
        };
        let (half, half_slope) = self.width(u);
        Station {
            heading,
            curvature,
            half,
            half_slope,
        }
    }

    /// Half separation and its slope: quintic blends between the knots.
    fn width(&self, u: f64) -> (f64, f64) {
        let after = self.widths.partition_point(|w| w.0 <= u);
        let Some(k) = after.checked_sub(1) else {
            return (self.widths.first().map_or(0.4, |w| w.1), 0.0);
        };
        let (u0, h0) = self.widths[k];
        let Some(&(u1, h1)) = self.widths.get(k + 1) else {
            return (h0, 0.0);
        };
        let t = (u - u0) / (u1 - u0);
        let blend = t * t * t * (10.0 + t * (6.0 * t - 15.0));
        let slope = 30.0 * t * t * (1.0 - t) * (1.0 - t) / (u1 - u0);
        (h0 + (h1 - h0) * blend, (h1 - h0) * slope)
    }
}

/// Free bends: each turns away from the last one or on with it, within a bound on the heading that keeps long courses
/// from coming back to themselves.
pub(crate) fn meander(
    random: &mut Random,
    level: &Level,
    waypoints: usize,
    attempt: usize,
) -> Course {
    let step = random.between(0.042, 0.047);
    let length = waypoints as f64 * 0.05;
    let widest = 0.5 * level.separation.1;
    // Short courses may turn around, long ones keep a direction; later attempts are tamer.
    let bound = if waypoints <= 300 { 2.4 } else { 1.35 } * libm::pow(0.97, attempt as f64);

    let mut bends = vec![Bend {
        angle: 0.0,
        length: random.between(0.3, 0.8),
    }];
    let (mut at, mut turned, mut side) = (bends[0].length, 0.0f64, random.sign());
    while at < length {
        let magnitude = random.between(level.bend.0, level.bend.1).min(2.0 * bound);
        if random.chance(0.4 + 0.5 * level.fraction) {
            side = -side;
        }
        let mut angle = side * magnitude;
        if (turned + angle).abs() > bound {
            side = -side;
            angle = side * magnitude;
        }
        if (turned + angle).abs() > bound {
            angle = side * bound - turned;
        }
        // Peak curvature 2 angle / length, at most inner / half separation.
        let shortest = 2.0 * angle.abs() * widest / level.inner;
        let bend = Bend {
            angle,
            length: (shortest * random.between(1.0, 1.6)).max(0.5),
        };
        turned += angle;
        at += bend.length;
        bends.push(bend);
        let straight = random.between(0.0, 1.5 * (1.0 - level.fraction) + 0.3);
        if straight > 0.1 {
            bends.push(Bend {
                angle: 0.0,
                length: straight,
            });
            at += straight;
        }
    }
    let heading = random.between(-PI, PI);
    Course::new(heading, bends, widths(random, level, length), step)
}

/// Half separations at random knots; some at the narrowest.
pub(crate) fn widths(random: &mut Random, level: &Level, length: f64) -> Vec<(f64, f64)> {
    let (low, high) = level.separation;
    let draw = |random: &mut Random| {
        let narrow = random.chance(0.2 + 0.2 * level.fraction);
        0.5 * if narrow {
            low
        } else {
            random.between(low, high)
        }
    };
    let mut knots = vec![(0.0, draw(random))];
    let mut at = 0.0;
    while at < length {
        at += random.between(1.2, 2.4);
        knots.push((at, draw(random)));
        // A stretch of constant width, so that gates have some depth.
        if random.chance(0.5) {
            let same = knots[knots.len() - 1].1;
            at += random.between(0.3, 0.8);
            knots.push((at, same));
        }
    }
    knots
}
