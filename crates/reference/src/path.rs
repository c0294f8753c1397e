use crate::step::{Ends, RollingStep};
use pairtrawl_geometry::{Point, Pose};

/// A step shorter than this part of the longest chord, with a turn of less than this (rad), is a wait.
const WAIT: f64 = 2e-8;

/// What a step of the plan does: how far it goes along its mid-step heading, m, and how much it turns, rad.
#[derive(Clone, Copy)]
struct Move {
    along: f64,
    turn: f64,
    waits: bool,
}

/// The longest distance between neighboring waypoints, m.
pub(crate) fn longest_chord(poses: &[Pose]) -> f64 {
    let chords = poses.windows(2);
    chords
        .map(|w| w[0].position().distance(w[1].position()))
        .fold(0.0, f64::max)
}

/// The way of one robot through all its waypoints, speed and turning rate continuous; `unit` is the longest chord, m.
pub(crate) fn roll_through(poses: &[Pose], unit: f64) -> Vec<RollingStep> {
    let moves: Vec<Move> = poses
        .windows(2)
        .map(|w| {
            let turn = w[1].heading - w[0].heading;
            let middle = Point::unit(w[0].heading + 0.5 * turn);
            let along = (w[1].position() - w[0].position()).dot(middle);
            let waits = along.abs() <= WAIT * unit && turn.abs() <= WAIT;
            Move { along, turn, waits }
        })
        .collect();
    // Speed and turning rate at waypoint i.
    let rates_at = |i: usize| match (i.checked_sub(1).and_then(|j| moves.get(j)), moves.get(i)) {
        (Some(before), Some(after)) => between(before, after),
        (Some(only), None) | (None, Some(only)) => (only.along, only.turn),
        (None, None) => (0.0, 0.0),
    };
    let mut steps = Vec::with_capacity(moves.len());
    let mut start = poses.first().copied().unwrap_or_default();
    for i in 0..moves.len() {
        let ((s0, t0), (s1, t1)) = (rates_at(i), rates_at(i + 1));
        let ends = Ends {
            speed: [s0, s1],
            rate: [t0, t1],
        };
        let step = RollingStep::between(start, poses[i + 1], &ends, unit);
        // Where a short chord could not be met, the next step starts from where this one ends.
        start = step.pose(1.0);
        steps.push(step);
    }
    steps
}

/// Speed and turning rate between two steps. The speed is the harmonic mean, which is 0 beside a wait and never makes a robot
/// back up; the turning rate is the mean, but 0 beside a wait.
fn between(before: &Move, after: &Move) -> (f64, f64) {
    let (a, b) = (before.along, after.along);
    let speed = if a * b > 0.0 {
        2.0 * a * b / (a + b)
    } else {
        0.0
    };
    let rate = if before.waits || after.waits {
        0.0
    } else {
        0.5 * (before.turn + after.turn)
    };
    (speed, rate)
}
