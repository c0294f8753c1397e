//! Shortest paths of bounded curvature between two poses (Dubins 1957); words as in Shkel and Lumelsky (2001).

use pairtrawl_geometry::{Point, Pose};
use std::f64::consts::TAU;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Turn {
    Left,
    Straight,
    Right,
}

use Turn::{Left, Right, Straight};

const WORDS: [[Turn; 3]; 6] = [
    [Left, Straight, Left],
    [Right, Straight, Right],
    [Left, Straight, Right],
    [Right, Straight, Left],
    [Right, Left, Right],
    [Left, Right, Left],
];

/// The shortest path from one pose to another with a given turning radius.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dubins {
    start: Pose,
    radius: f64,
    word: [Turn; 3],
    /// Lengths of the three pieces in radii.
    pieces: [f64; 3],
}

impl Dubins {
    pub fn new(start: Pose, goal: Pose, radius: f64) -> Self {
        let d = goal.position() - start.position();
        let distance = d.norm() / radius;
        let theta = if distance > 1e-12 { d.angle() } else { 0.0 };
        let a = modulo(start.heading - theta);
        let b = modulo(goal.heading - theta);
        let mut best = Self {
            start,
            radius,
            word: WORDS[0],
            pieces: [f64::INFINITY; 3],
        };
        for word in WORDS {
            if let Some(pieces) = solve(word, a, b, distance)
                && pieces.iter().sum::<f64>() < best.pieces.iter().sum::<f64>()
            {
                best.word = word;
                best.pieces = pieces;
            }
        }
        best
    }

    /// Its length.
    pub fn length(&self) -> f64 {
        self.radius * self.pieces.iter().sum::<f64>()
    }

    /// The pose after a length `s`; the heading is continuous along the path.
    pub fn at(&self, s: f64) -> Pose {
        let mut rest = s / self.radius;
        let mut pose = self.start;
        for (turn, piece) in self.word.into_iter().zip(self.pieces) {
            let t = rest.clamp(0.0, piece);
            pose = advance(pose, turn, t, self.radius);
            rest -= t;
        }
        pose
    }

    /// Poses from start to goal, evenly spaced, at most `spacing` apart.
    pub fn sample(&self, spacing: f64) -> Vec<Pose> {
        let length = self.length();
        let n = (length / spacing).ceil().max(1.0) as usize;
        (0..=n)
            .map(|i| self.at(length * i as f64 / n as f64))
            .collect()
    }
}

/// The pose after turning by `t` radians, or going straight by `t` radii.
fn advance(pose: Pose, turn: Turn, t: f64, radius: f64) -> Pose {
    let curvature = match turn {
        Left => 1.0,
        Straight => {
            return Pose::at(
                pose.position() + pose.forward() * (t * radius),
                pose.heading,
            );
        }
        Right => -1.0,
    };
    let heading = pose.heading + curvature * t;
    let shift = Point::new(
        libm::sin(heading) - libm::sin(pose.heading),
        libm::cos(pose.heading) - libm::cos(heading),
    );
    Pose::at(pose.position() + shift * (curvature * radius), heading)
}

fn modulo(angle: f64) -> f64 {
    let m = angle.rem_euclid(TAU);
    // A turn of nearly 2 pi is a turn by nothing with a rounding error.
    if TAU - m < 1e-9 { 0.0 } else { m }
}

/// Pieces of a word for unit radius from (0, 0, a) to (d, 0, b).
fn solve(word: [Turn; 3], a: f64, b: f64, d: f64) -> Option<[f64; 3]> {
    let (sa, ca) = libm::sincos(a);
    let (sb, cb) = libm::sincos(b);
    let cab = libm::cos(a - b);
    match word {
        [Left, Straight, Left] => {
            let p = root(2.0 + d * d - 2.0 * cab + 2.0 * d * (sa - sb))?;
            let t = libm::atan2(cb - ca, d + sa - sb);
            Some([modulo(t - a), p, modulo(b - t)])
        }
        [Right, Straight, Right] => {
            let p = root(2.0 + d * d - 2.0 * cab + 2.0 * d * (sb - sa))?;
            let t = libm::atan2(ca - cb, d - sa + sb);
            Some([modulo(a - t), p, modulo(t - b)])
        }
        [Left, Straight, Right] => {
            let p = root(-2.0 + d * d + 2.0 * cab + 2.0 * d * (sa + sb))?;
            let t = libm::atan2(-ca - cb, d + sa + sb) - libm::atan2(-2.0, p);
            Some([modulo(t - a), p, modulo(t - b)])
        }
        [Right, Straight, Left] => {
            let p = root(-2.0 + d * d + 2.0 * cab - 2.0 * d * (sa + sb))?;
            let t = libm::atan2(ca + cb, d - sa - sb) - libm::atan2(2.0, p);
            Some([modulo(a - t), p, modulo(b - t)])
        }
        [Right, Left, Right] => {
            let c = (6.0 - d * d + 2.0 * cab + 2.0 * d * (sa - sb)) / 8.0;
            let p = modulo(TAU - libm::acos(cosine(c)?));
            let t = modulo(a - libm::atan2(ca - cb, d - sa + sb) + 0.5 * p);
            Some([t, p, modulo(a - b - t + p)])
        }
        _ => {
            let c = (6.0 - d * d + 2.0 * cab + 2.0 * d * (sb - sa)) / 8.0;
            let p = modulo(TAU - libm::acos(cosine(c)?));
            let t = modulo(-a - libm::atan2(ca - cb, d + sa - sb) + 0.5 * p);
            Some([t, p, modulo(b - a - t + p)])
        }
    }
}

fn root(square: f64) -> Option<f64> {
    // A tangent of length zero may come out as a small negative square.
    (square > -1e-9).then(|| square.max(0.0).sqrt())
}

fn cosine(c: f64) -> Option<f64> {
    (c.abs() <= 1.0).then_some(c)
}

#[cfg(test)]
mod tests {
    use super::*;
    use pairtrawl_geometry::wrap_angle;

    #[test]
    fn paths_reach_their_goal_with_bounded_curvature_and_are_never_shorter_than_straight() {
        let mut seed = 1u64;
        let mut random = move || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 33) as f64 / (1u64 << 31) as f64
        };
        for _ in 0..2000 {
            let mut pose = || Pose::new(3.0 * random(), 3.0 * random(), 8.0 * random() - 4.0);
            let (start, goal) = (pose(), pose());
            let path = Dubins::new(start, goal, 0.6);
            let end = path.at(path.length());
            assert!(
                end.position().distance(goal.position()) < 1e-6,
                "{path:?} {goal:?}"
            );
            assert!(wrap_angle(end.heading - goal.heading).abs() < 1e-6);
            assert!(path.length() >= start.position().distance(goal.position()) - 1e-9);
            let samples = path.sample(0.05);
            for w in samples.windows(2) {
                assert!((w[1].heading - w[0].heading).abs() <= 0.05 / 0.6 + 1e-9);
            }
        }
    }

    #[test]
    fn known_paths() {
        let straight = Dubins::new(Pose::new(0.0, 0.0, 0.0), Pose::new(2.0, 0.0, 0.0), 0.5);
        assert!((straight.length() - 2.0).abs() < 1e-9);
        let reversal = Dubins::new(
            Pose::new(0.0, 0.0, 0.0),
            Pose::new(0.0, 1.0, std::f64::consts::PI),
            0.5,
        );
        assert!((reversal.length() - 0.5 * std::f64::consts::PI).abs() < 1e-9);
    }
}
