//! Objects so close together that no robot passes between them, ever: a track that leads between two of them is led around both.

use super::band::{Asked, Limit, Visit};
use super::tracks::{Tracks, WINDOW};
use crate::terrain::{Disc, Terrain};
use pairtrawl_geometry::{Point, Pose, Segment};
use pairtrawl_model::Side;

/// Asks for more where a track leads between two objects that leave no room for a robot: to take both into the net when
/// one of them is taken there anyway, or when that is the shorter way around; else to keep off both. False when there is
/// nothing to ask for.
pub(super) fn ask_for_ways_around(
    terrain: &Terrain,
    centerline: &[Pose],
    tracks: &Tracks,
    visits: &[Visit],
    asked: &mut Asked,
) -> bool {
    let mut found = false;
    for side in Side::BOTH {
        let track = tracks.of(side);
        for k in 0..track.len() - 1 {
            let step = Segment::new(track[k], track[k + 1]);
            for [a, b] in terrain.ties_near(track[k]) {
                if step.intersects(&Segment::new(a.center, b.center)) {
                    found |=
                        Crossing { side, k, a, b }.ask(terrain, centerline, tracks, visits, asked);
                }
            }
        }
    }
    found
}

/// A track leads between two objects.
struct Crossing {
    side: Side,
    /// Index into tracks and centerline.
    k: usize,
    a: Disc,
    b: Disc,
}

impl Crossing {
    fn ask(
        &self,
        terrain: &Terrain,
        centerline: &[Pose],
        tracks: &Tracks,
        visits: &[Visit],
        asked: &mut Asked,
    ) -> bool {
        let pose = centerline[self.k];
        let outwards = pose.forward().perp() * self.side.sign();
        let offset = |p: Point| (p - pose.position()).dot(outwards);
        let (inner, outer) = if offset(self.a.center) < offset(self.b.center) {
            (self.a, self.b)
        } else {
            (self.b, self.a)
        };
        let is_visited = |object: Disc| {
            let is_it = |visit: &Visit| {
                visit.object.center == object.center && visit.index.abs_diff(self.k) <= WINDOW
            };
            visits.iter().any(is_it)
        };
        let pair = &terrain.pair;
        let keep = |object: Disc| object.radius + pair.radius + pair.clearance;
        let here = offset(tracks.of(self.side)[self.k]);
        let other = -offset(tracks.of(self.side.other())[self.k]);
        let beyond = offset(outer.center) + keep(outer);
        let within = offset(inner.center) - keep(inner);
        let has_room = |at: f64| terrain.distance(pose.position() + outwards * at) > pair.radius;
        let takes = is_visited(inner) || is_visited(outer);
        let can_take = beyond + other <= 2.0 * pair.max_half && has_room(beyond);
        let can_keep_off = within + other >= 2.0 * pair.min_half && has_room(within);
        let is_shorter = beyond - here <= here - within;
        if takes || !can_keep_off || (can_take && is_shorter) {
            let mut added = false;
            for object in [inner, outer] {
                if !is_visited(object) {
                    let index = abreast(centerline, self.k, object.center);
                    asked.visits.push(Visit { object, index });
                    added = true;
                }
            }
            added
        } else {
            let index = abreast(centerline, self.k, inner.center);
            let pose = centerline[index];
            let outwards = pose.forward().perp() * self.side.sign();
            let most = (inner.center - pose.position()).dot(outwards) - keep(inner);
            let limit = Limit {
                side: self.side,
                index,
                most,
            };
            let is_new = !asked.limits.contains(&limit);
            if is_new {
                asked.limits.push(limit);
            }
            is_new
        }
    }
}

/// The index of the centerline pose nearest to a point, near the index k.
fn abreast(centerline: &[Pose], k: usize, point: Point) -> usize {
    let window = k.saturating_sub(WINDOW)..(k + WINDOW + 1).min(centerline.len());
    let distance = |i: usize| centerline[i].position().distance(point);
    window
        .min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
        .unwrap_or(k)
}
