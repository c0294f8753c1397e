//! One clock for both tracks: waypoints spaced so that neither robot outruns its step or its turn.

use super::tracks::{SPACING, Tracks};
use crate::polyline::near_angle;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{PairTrajectory, Scene, default_step_time};

/// Waypoints over the least number in which the longer path can be driven.
const RESERVE: f64 = 1.3;
/// A step shorter than this part of the greatest one hardly has a direction: that abreast decides the heading then.
const STANDING: f64 = 5.0;
/// A segment of a track shorter than this part of the usual spacing has no direction.
const TOO_SHORT: f64 = 0.04;

/// N when it is not given: `ceil(1.3 longest / max_step) + 1`, and no fewer than the clock of the tighter robot needs.
pub(crate) fn waypoint_count(tracks: &Tracks, scene: &Scene) -> usize {
    let length = |t: &[Point]| t.windows(2).map(|w| w[0].distance(w[1])).sum::<f64>();
    let longest = length(&tracks.left).max(length(&tracks.right));
    let needed = clock(tracks, scene).last().copied().unwrap_or(0.0);
    let step = scene.planner.max_step;
    ((RESERVE * longest / step)
        .ceil()
        .max((1.02 * needed).ceil()) as usize
        + 1)
    .max(8)
}

/// Time at every index in steps: the longer way of the two, or the sharper turn, at full rate.
fn clock(tracks: &Tracks, scene: &Scene) -> Vec<f64> {
    let n = tracks.left.len();
    let turn = |t: &[Point], i: usize| {
        if i == 0 || i + 2 >= n {
            return 0.0;
        }
        let (a, b) = (t[i + 1] - t[i], t[i + 2] - t[i + 1]);
        let (before, after) = (t[i] - t[i - 1], a);
        // Half of the turns at both ends of the segment; what is all but standing has no direction.
        let angle = |u: Point, v: Point| {
            if u.norm().min(v.norm()) < TOO_SHORT * SPACING {
                0.0
            } else {
                libm::atan2(u.cross(v), u.dot(v)).abs()
            }
        };
        0.5 * (angle(before, after) + angle(a, b))
    };
    let mut time = vec![0.0; n];
    for i in 0..n - 1 {
        let step = tracks.left[i]
            .distance(tracks.left[i + 1])
            .max(tracks.right[i].distance(tracks.right[i + 1]));
        let angle = turn(&tracks.left, i).max(turn(&tracks.right, i));
        let steps = (step / scene.planner.max_step).max(angle / scene.planner.max_turn);
        time[i + 1] = time[i] + steps.max(1e-6);
    }
    time
}

/// Samples both tracks at `count` instants, evenly on the clock, and adds headings.
pub(crate) fn sample(tracks: &Tracks, scene: &Scene, count: usize) -> PairTrajectory {
    let time = clock(tracks, scene);
    let n = time.len();
    let total = time[n - 1];
    let mut left = Vec::with_capacity(count);
    let mut right = Vec::with_capacity(count);
    let mut segment = 0;
    for k in 0..count {
        let at = total * k as f64 / (count - 1) as f64;
        while segment + 2 < n && time[segment + 1] < at {
            segment += 1;
        }
        let t = ((at - time[segment]) / (time[segment + 1] - time[segment])).clamp(0.0, 1.0);
        left.push(tracks.left[segment].lerp(tracks.left[segment + 1], t));
        right.push(tracks.right[segment].lerp(tracks.right[segment + 1], t));
    }
    let standing = scene.planner.max_step / STANDING;
    let abreast = abreast(&left, &right, scene.start.left.heading);
    let poses = |points: &[Point], start: Pose, end: Pose| {
        with_headings(
            points,
            &abreast,
            scene.planner.max_skew,
            standing,
            start,
            end,
        )
    };
    PairTrajectory {
        left: poses(&left, scene.start.left, scene.end.left),
        right: poses(&right, scene.start.right, scene.end.right),
        step_time: default_step_time(&scene.robot, &scene.planner),
    }
}

/// The heading of robots that drive abreast, at every instant; continuous from near `first` on.
fn abreast(left: &[Point], right: &[Point], first: f64) -> Vec<f64> {
    let mut heading = first;
    (left.iter().zip(right))
        .map(|(l, r)| {
            heading = near_angle((-(*l - *r).perp()).angle(), heading);
            heading
        })
        .collect()
}

/// Headings along the chords, within `max_skew` of those that are abreast, so that neither robot turns round more often
/// than the pair; the scene's own poses at both ends.
fn with_headings(
    points: &[Point],
    abreast: &[f64],
    max_skew: f64,
    standing: f64,
    start: Pose,
    end: Pose,
) -> Vec<Pose> {
    let n = points.len();
    let mut poses = Vec::with_capacity(n);
    let first = near_angle(start.heading, abreast[0]);
    poses.push(Pose::at(start.position(), first));
    for i in 1..n - 1 {
        let along = Point::unit(abreast[i]) * standing;
        let direction = (points[i + 1] - points[i - 1]) * 0.5 + along;
        let skew = near_angle(direction.angle(), abreast[i]) - abreast[i];
        let heading = abreast[i] + skew.clamp(-max_skew, max_skew);
        poses.push(Pose::at(points[i], heading));
    }
    let last = near_angle(end.heading, abreast[n - 1]);
    poses.push(Pose::at(end.position(), last));
    poses
}
