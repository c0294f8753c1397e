//! How far left and right of the centerline the robots drive.

use super::candidates::outer_candidates;
use crate::centerline::attachment::attach;
use crate::polyline::arc_lengths;
use crate::terrain::{Disc, Terrain};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Circle, Scene, Side};

/// Steepest change of an offset per length of centerline: circle borders are blended with it.
const SLOPE: f64 = 0.45;
/// Steepest change of the lead per length of centerline.
const LEAD_SLOPE: f64 = 0.6;
/// Greatest angle between the line between the robots and the centerline's normal, rad.
const MAX_STAGGER: f64 = 0.85;
/// Share of the margin that each robot gives before they go one ahead of the other.
const MARGIN_GIVEN: f64 = 0.8;
/// Step in which the room beside the centerline is measured.
const PROBE: f64 = 0.02;
/// Largest product of curvature and inner offset: at 1 the inner robot would stand still.
const INNER: f64 = 0.85;
/// Length over which the offsets go over into those of the scene's ends.
const END_BLEND: f64 = 1.0;
/// Passes of the smoothing of the offsets.
const ROUNDING: usize = 12;
/// How far along the centerline an object is looked for around the place where its circle is visited.
const WINDOW: f64 = 0.8;

/// One object with the place where the pair takes it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Visit {
    pub object: Disc,
    /// Index of the centerline pose abreast of it.
    pub index: usize,
}

/// A robot drives at most this far beside the centerline at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Limit {
    pub side: Side,
    /// Index of the centerline pose.
    pub index: usize,
    /// Greatest offset from the centerline, outwards.
    pub most: f64,
}

/// What is asked of a band beyond its circles.
#[derive(Clone, Debug, Default)]
pub(crate) struct Asked {
    /// Objects that the pair takes in passing.
    pub visits: Vec<Visit>,
    pub limits: Vec<Limit>,
}

/// Offsets of both robots from the centerline, both counted positive outwards.
pub(crate) struct Band {
    pub left: Vec<f64>,
    pub right: Vec<f64>,
    /// How far the left robot is ahead of the right one: 0 but where the pair can only pass staggered.
    pub lead: Vec<f64>,
    pub visits: Vec<Visit>,
}

/// Offsets that give every visited object its room, then keep both robots where obstacles leave room.
pub(crate) fn band(
    terrain: &Terrain,
    scene: &Scene,
    centerline: &[Pose],
    circles: &[&Circle],
    asked: &Asked,
) -> Band {
    let points: Vec<Point> = centerline.iter().map(|p| p.position()).collect();
    let s = arc_lengths(&points);
    let n = centerline.len();
    let pair = &terrain.pair;
    let centers: Vec<Point> = circles.iter().map(|c| c.center).collect();
    let at = attach(&points, &centers);
    let mut left = vec![pair.half_separation; n];
    let mut right = left.clone();
    let mut lead = vec![0.0; n];
    let mut visits = Vec::new();
    for (circle, &here) in circles.iter().zip(&at) {
        let within = |reach: f64| {
            s.partition_point(|v| *v < s[here] - reach)
                ..s.partition_point(|v| *v <= s[here] + reach)
        };
        for i in within(circle.radius + 0.1) {
            if points[i].distance(circle.center) <= circle.radius {
                let (outer_left, outer_right) =
                    outer_candidates(centerline[i], circle, pair.half_separation);
                left[i] = left[i].max(outer_left);
                right[i] = right[i].max(-outer_right);
            }
        }
        for &object in &circle.objects {
            let Some(&object) = terrain.objects.get(object) else {
                continue;
            };
            let window = circle.radius + WINDOW;
            let distance = |i: usize| points[i].distance(object.center);
            let index = within(window)
                .min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
                .unwrap_or(here);
            visits.push(Visit { object, index });
        }
    }
    visits.extend(&asked.visits);
    for &Visit { object, index } in &visits {
        let offset = (object.center - points[index]).dot(centerline[index].forward().perp());
        let keep = object.radius + pair.radius + pair.clearance;
        left[index] = left[index].max(offset + keep);
        right[index] = right[index].max(keep - offset);
    }
    rise(&s, SLOPE, &mut left);
    rise(&s, SLOPE, &mut right);
    let mut room_left = room(terrain, centerline, Side::Left, &left);
    let mut room_right = room(terrain, centerline, Side::Right, &right);
    for limit in &asked.limits {
        let room = match limit.side {
            Side::Left => &mut room_left[limit.index],
            Side::Right => &mut room_right[limit.index],
        };
        *room = room.min(limit.most);
    }
    lower(&s, &mut room_left);
    lower(&s, &mut room_right);
    for i in 0..n {
        // The outer one gives what the inner one must give up in a bend.
        let bend = curvature(centerline, &s, i);
        let wanted = left[i] + right[i];
        let inner = if bend.abs() > 1e-6 {
            INNER / bend.abs()
        } else {
            f64::INFINITY
        };
        let side = if bend > 0.0 { &mut left } else { &mut right };
        side[i] = side[i].min(inner);
        let least = wanted.min(2.0 * pair.min_half);
        let limited = (left[i].min(room_left[i]), right[i].min(room_right[i]));
        let missing = (least - limited.0 - limited.1).max(0.0);
        // What one side lacks to the least separation, the other adds where it has room; the rest is shared.
        let spare = (
            (room_left[i] - limited.0).max(0.0),
            (room_right[i] - limited.1).max(0.0),
        );
        let total = spare.0 + spare.1;
        let give = missing.min(total);
        let share = if total > 0.0 {
            (give * spare.0 / total, give * spare.1 / total)
        } else {
            (0.0, 0.0)
        };
        // Still too close: the margins give, then one robot goes ahead of the other, as far as the skew allows.
        let side_by_side = 2.0 * pair.min_half;
        let tight = missing - give;
        let narrowest = side_by_side * libm::cos(MAX_STAGGER) - limited.0 - limited.1 - give;
        let rest = (0.5 * tight)
            .min(MARGIN_GIVEN * pair.clearance)
            .max(0.5 * narrowest);
        let across = limited.0 + limited.1 + give + 2.0 * rest;
        if tight > 1e-9 && across < side_by_side {
            lead[i] = (side_by_side * side_by_side - across * across).sqrt();
        }
        left[i] = limited.0 + share.0 + rest;
        right[i] = limited.1 + share.1 + rest;
        let most = 2.0 * pair.max_half;
        let scale = (most / (left[i] + right[i])).min(1.0);
        left[i] *= scale;
        right[i] *= scale;
    }
    rise(&s, LEAD_SLOPE, &mut lead);
    for offsets in [&mut left, &mut right, &mut lead] {
        round(offsets);
    }
    for (end, separation) in [
        (0, scene.start.separation()),
        (n - 1, scene.end.separation()),
    ] {
        let half = 0.5 * separation;
        for i in 0..n {
            // Level at the end itself, so that the robots leave and arrive side by side.
            let t = 1.0 - ((s[i] - s[end]).abs() / END_BLEND).min(1.0);
            let share = t * t * (3.0 - 2.0 * t);
            left[i] += share * (half - left[i]);
            right[i] += share * (half - right[i]);
            lead[i] -= share * lead[i];
        }
    }
    Band {
        left,
        right,
        lead,
        visits,
    }
}

/// Rounds the corners that the slopes leave, over about 0.3.
fn round(v: &mut [f64]) {
    for _ in 0..ROUNDING {
        let old = v.to_vec();
        for (v, w) in v[1..].iter_mut().zip(old.windows(3)) {
            *v = 0.25 * w[0] + 0.5 * w[1] + 0.25 * w[2];
        }
    }
}

/// Signed curvature at a pose, positive to the left.
fn curvature(poses: &[Pose], s: &[f64], i: usize) -> f64 {
    let (a, b) = (i.saturating_sub(2), (i + 2).min(poses.len() - 1));
    let ds = s[b] - s[a];
    if ds > 1e-9 {
        (poses[b].heading - poses[a].heading) / ds
    } else {
        0.0
    }
}

/// Raises values beside peaks: max_j (v_j - slope |s_i - s_j|).
fn rise(s: &[f64], slope: f64, v: &mut [f64]) {
    for i in 1..v.len() {
        v[i] = v[i].max(v[i - 1] - slope * (s[i] - s[i - 1]));
    }
    for i in (0..v.len().saturating_sub(1)).rev() {
        v[i] = v[i].max(v[i + 1] - slope * (s[i + 1] - s[i]));
    }
}

/// Lowers values beside dips: min_j (v_j + SLOPE |s_i - s_j|).
fn lower(s: &[f64], v: &mut [f64]) {
    v.iter_mut().for_each(|x| *x = -*x);
    rise(s, SLOPE, v);
    v.iter_mut().for_each(|x| *x = -*x);
}

/// The farthest that a robot may drive on one side, up to what it wants and a little more; where its margin is nowhere
/// kept, where it comes nearest to keeping it.
fn room(terrain: &Terrain, centerline: &[Pose], side: Side, wanted: &[f64]) -> Vec<f64> {
    let keep = terrain.pair.radius + terrain.pair.clearance;
    let most = 2.0 * terrain.pair.max_half;
    centerline
        .iter()
        .zip(wanted)
        .map(|(pose, wanted)| {
            let normal = pose.forward().perp() * side.sign();
            let center = pose.position();
            if terrain.distance(center) > wanted + 0.3 + keep {
                return wanted + 0.3;
            }
            let mut room = None;
            let mut roomiest = (f64::NEG_INFINITY, 0.0);
            let mut offset = 0.0;
            while offset <= (wanted + 0.3).min(most) {
                let d = terrain.distance(center + normal * offset);
                if d < 0.01 {
                    break;
                }
                if d >= keep {
                    room = Some(offset);
                }
                if offset > 0.1 && d > roomiest.0 {
                    roomiest = (d, offset);
                }
                offset += PROBE;
            }
            room.unwrap_or(roomiest.1)
        })
        .collect()
}
