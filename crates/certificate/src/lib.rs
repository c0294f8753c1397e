//! Exact, continuous proof that a plan holds every claim.
//!
//! [`certify`] re-derives each claim of the file format from the scene and the two trajectories alone: it knows neither
//! grid nor distance field nor optimizer, so that one bug cannot make both a plan and its proof wrong. A plan is read in two
//! ways: with positions and headings linear in time between waypoints, and, when it is driven along its
//! [`Reference`], as the smooth curve of that. Every claim is decided for all instants of both, not for samples; its margin is
//! the smaller one, and its detail says when that is the smooth curve's.
//!
//! Over a stretch of a step each robot stays within a known distance of even motion between its ends: none on the linear
//! reading, an eighth of the greatest |p''| on the smooth curve, whose speed and turning rate are polynomials with exact
//! bounds. Stretches whose bound is below the least margin so far are halved until it is close. With even motion:
//!
//! - robots against obstacles and objects: exact distances of segments from polygons, discs and map cells, for the center of
//!   every circle of a body, which strays from even motion by what turning adds as well;
//! - robots against each other: the nearest point to the origin of the segment that the vector between two centers traces;
//! - the swept net: convex hulls of the four points of a stretch against the same shapes; touching is allowed, overlap by
//!   more than 1e-9 m is not;
//! - coverage: the quadratic in time at which the line between the robots passes over an object's center; on the smooth
//!   curve an instant that is enclosed by a change of sign;
//! - separation: the minimum of a quadratic; its greatest, like the net's reach, by the second derivative of the squared
//!   distance;
//! - abreast: the angles at both ends, and how far headings and the line between the robots may turn meanwhile;
//! - speed: greatest speed, turning rate and pace of each half step.
//!
//! Linear bounds lie within 1e-11 of the true margin, those of the smooth curve within 1e-7 where the claim holds (m, rad);
//! the speed on the smooth curve is taken together over half steps, which overstates it a little.
//!
//! Unusable input (NaN, coordinates beyond [`COORDINATE_LIMIT`], unequal lengths, fewer than two waypoints, a
//! malformed obstacle) makes claims fail with a detail that says why; nothing panics.

mod added;
mod claims;
mod clearance;
mod farthest;
pub mod infeasibility;
mod limits;
mod map_runs;
mod motion;
mod obstacles;
mod passage;
mod search;
mod subject;
mod tightest;

pub use added::{judge_stated_time_law, net_length_claim, scene_claim};
pub use clearance::Clearance;
pub use limits::{COORDINATE_LIMIT, TOLERANCE};

use pairtrawl_model::{Certificate, PairTrajectory, Scene};
use pairtrawl_reference::Reference;
use subject::Subject;

/// Judges two trajectories against a scene with a net of this length (d_max, m): with poses linear between waypoints, and on
/// the smooth curve as well when the pair drives along a reference of these trajectories.
///
/// The claims stand in the order of the file format, from `endpoints` to `net_reach`, then `inside_area`, and `robots_apart` for robots with a body; `scene` and
/// `net_length` concern files, see [`scene_claim`] and [`net_length_claim`]. A margin is `INFINITY` where there is
/// nothing to hold the plan against (no obstacle, no object) and `NEG_INFINITY` where the input cannot be judged.
pub fn certify(
    scene: &Scene,
    net_length: f64,
    trajectory: &PairTrajectory,
    reference: Option<&Reference>,
) -> Certificate {
    let claims = match Subject::new(scene, net_length, trajectory, reference) {
        Ok(subject) => claims::of(&scene.robot)
            .map(|claim| (claim.judge)(&subject).into_claim(claim.id, claim.tolerance))
            .collect(),
        Err(fault) => claims::of(&scene.robot)
            .map(|claim| fault.clone().into_claim(claim.id, claim.tolerance))
            .collect(),
    };
    Certificate { claims }
}
