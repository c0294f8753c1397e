//! Proofs that no plan can be valid, in words and numbers.
//!
//! A proof is given only where it is sound; a scene without one may still have no valid plan. The arguments are those of
//! exact driving: the tolerances of the claims (a slip of 0.1 mm in a step, 1e-6 m backward) are rounding, not a way to drive.
//!
//! 1. **The net is too short**: the hitches or axles at the start or end are farther apart than the net is long. **An object
//!    is too wide** for a net that is shorter than two robot radii plus its footprint circle, over which it must pass with
//!    a robot on each side.
//! 2. **The net is too long**: robots keep a tenth of d_max apart at every instant, and at the start or end they do not.
//! 3. **Every way is cut**: a robot's center stays in the area, at least a radius from every obstacle and every object's
//!    footprint circle. Cells of a grid in which no point keeps that distance are surely blocked (the distance is
//!    1-Lipschitz: that at the cell's center plus half the diagonal is below the radius). A continuous path visits cells
//!    that share a corner at least; where no such chain of other cells joins start and end there is no path. Nothing is
//!    assumed of the pair: staggered, it passes gaps that its width does not.
//!    Of a robot with a body the axle center keeps the radius of the largest circle around it that the body contains, and the
//!    center of the body's largest circle keeps its own: where that one has no path there is none, and the axle center gets
//!    only to places that are as near to its cells as the two centers are to each other. That center may leave the area by
//!    as much, so the grid reaches beyond it.
//! 4. **An object is enclosed**: when the line between the robots passes over it, each half of the line is a straight
//!    segment from the object to a robot, no longer than d_max - (radius + footprint radius) since the other half keeps
//!    that distance, and it enters no obstacle. The proof shows for one robot that no cell that it may reach (as in 3)
//!    is near enough and has a line of sight. A convex piece of an obstacle that hides the four corners of a cell hides
//!    the whole cell, because the shadow of a convex set is convex. Nor is there a line to a cell that no chain of cells
//!    within reach, none wholly inside an obstacle, joins to the object.
//! 5. **An object is pinned**: less than two robot radii separate its footprint circle from an obstacle, and neither the
//!    start nor the end line between the robots crosses the shortest segment between object center and obstacle. No robot
//!    path crosses that segment, for a point on it cannot keep a radius from both. (A circle of a body whose center is o off
//!    the axle center is at most o off the segment then, so with its radius r and the footprint's f, the segment is at least
//!    sqrt((f + r)^2 - o^2) + sqrt(r^2 - o^2) long.) The boundary of the swept region
//!    (start line, one path, end line, other path) hence winds equally often around its two ends: not at all, because
//!    inside the obstacle nothing is swept. Robots that drive forward and abreast sweep every point in the same sense,
//!    so a point that is passed over has a winding number other than zero: the object is not swept. Abreast has to hold
//!    with room for a step's turn, so the proof is used only while max_skew + max_turn / 2 + 2 asin(max_step /
//!    separation) is below a right angle, and only when start and end are more than one step apart. An object that
//!    reaches an obstacle through a chain of close objects needs no argument of its own: the last one is pinned. The same
//!    holds for an object that is closer to the edge of the area than a robot radius beyond its footprint circle: no robot
//!    leaves the area, which is convex, so nothing is swept outside of it either.
//!
//! The radius of a robot with a body is that of the largest circle around its axle center that one of the body's circles
//! contains: the rest of the body is left out of every argument.
//!
//! Bounds of the search (sizes of cells) grow with the robots; tolerances are those of the claims, in m.

mod carried;
mod cell;
mod enclosed;
mod free_space;
mod joined;
mod least_move;
mod narrowest;
mod net_too_long;
mod net_too_short;
mod pinned;
mod proof;
mod things;
mod too_few_waypoints;
mod too_wide;
mod verify;
mod way_cut;

use crate::limits::COORDINATE_LIMIT;
use enclosed::Verdict;
use free_space::FreeSpace;
pub use least_move::Move;
use pairtrawl_geometry::Point;
use pairtrawl_model::Scene;
pub use proof::{GridEvidence, Proof, ProofKind};
use things::Things;
pub use too_few_waypoints::too_few_waypoints;
pub use verify::{Refusal, verify};

/// Lines of sight are not looked at on cells with a diagonal below this, in units of the length scale: what is still open
/// then stays unproven.
const FINEST_VIEW: f64 = 0.03;

/// The widest way to an enclosed object and the least move that would help are found for this many of them: they take
/// longer than the proof.
const MOST_IN_WORDS: usize = 8;

/// Looks for proofs that no plan for this scene can be valid: one that is not about an object, or none, then the objects
/// that provably cannot be swept, ascending, one proof each; all of them, where none of the first kind ends the search.
/// Objects that are left need none. `net_length` (m) is the length in force; `None` leaves it to the planner. Scenes that
/// are malformed or start in collision have no proofs: they are bad input.
pub fn prove(scene: &Scene, net_length: Option<f64>) -> Vec<Proof> {
    proofs(scene, net_length, true)
}

/// The objects that provably cannot be swept, of those that are not left, ascending: those of [`prove`], in less time,
/// without words and moves.
pub fn impossible_objects(scene: &Scene, net_length: Option<f64>) -> Vec<usize> {
    let proofs = proofs(scene, net_length, false);
    proofs.iter().filter_map(Proof::object).collect()
}

fn proofs(scene: &Scene, net_length: Option<f64>, in_words: bool) -> Vec<Proof> {
    if !usable(scene, net_length) {
        return Vec::new();
    }
    let Some(mut things) = Things::new(scene) else {
        return Vec::new();
    };
    things.in_words = in_words;
    let net =
        |length| net_too_short::prove(scene, length).or_else(|| net_too_long::prove(scene, length));
    if let Some(proof) = net_length.and_then(net) {
        return vec![proof];
    }
    let mut about = vec![None; scene.objects.len()];
    let too_wide = net_length.map(|length| too_wide::prove(scene, length));
    for proof in too_wide.into_iter().flatten().chain(pinned::prove(&things)) {
        if let Some(object) = proof.object() {
            about[object].get_or_insert(proof);
        }
    }
    let way = ways(&things, net_length, &mut about);
    way.into_iter().chain(about.into_iter().flatten()).collect()
}

/// Looks on finer and finer grids for a robot whose way is cut and for objects that are enclosed, among those without a
/// proof.
fn ways(
    things: &Things<'_>,
    net_length: Option<f64>,
    about: &mut [Option<Proof>],
) -> Option<Proof> {
    let scene = things.scene;
    let mut in_words = 0;
    let wanted = |&i: &usize| !scene.objects[i].leave && about[i].is_none();
    let mut open: Vec<usize> = (0..scene.objects.len()).filter(wanted).collect();
    // Without words only objects are asked for, not whether a robot has a way.
    let only_objects = !things.in_words;
    if open.is_empty() && only_objects {
        return None;
    }
    let mut space = FreeSpace::new(things);
    loop {
        let reached = space.reach(scene)?;
        if let Some(robot) = reached.robot_without_way(&space, scene) {
            return Some(way_cut::proof(things, &space, &reached, robot));
        }
        let mut undecided = Vec::new();
        for object in open {
            match enclosed::judge(
                things,
                &space,
                &reached,
                object,
                net_length,
                things.in_words && in_words < MOST_IN_WORDS,
            ) {
                Verdict::Enclosed(proof) => {
                    about[object] = Some(proof);
                    in_words += 1;
                }
                Verdict::Reachable => {}
                Verdict::Open => undecided.push(object),
            }
        }
        open = if space.size().norm() < FINEST_VIEW * things.scale {
            Vec::new()
        } else {
            undecided
        };
        if open.is_empty() && (only_objects || reached.has_sure_way(&space, scene)) {
            return None;
        }
        space = space.refined(things)?;
    }
}

/// True when every number that the proofs rely on is finite and of a sensible size.
fn usable(scene: &Scene, net_length: Option<f64>) -> bool {
    let bounded = |p: Point| p.x.abs() <= COORDINATE_LIMIT && p.y.abs() <= COORDINATE_LIMIT;
    let (min, max) = (scene.area.min, scene.area.max);
    let pairs = [scene.start, scene.end];
    let robot = &scene.robot;
    bounded(min)
        && bounded(max)
        && min.x < max.x
        && min.y < max.y
        && pairs.iter().all(|p| {
            [p.left, p.right]
                .iter()
                .all(|r| r.is_finite() && bounded(r.position()))
        })
        && scene.objects.iter().all(|o| {
            bounded(o.position) && (0.0..=COORDINATE_LIMIT).contains(&o.footprint_radius())
        })
        && things::sure_radius(robot) > 0.0
        && robot.circles().reach() <= COORDINATE_LIMIT
        && robot.hitch.abs() <= COORDINATE_LIMIT
        && net_length.is_none_or(f64::is_finite)
}
