//! Exact, continuous proof that a plan holds every claim.
//!
//! [`certify`] re-derives each claim of the file format from the scene and the two trajectories alone: it knows neither
//! grid nor distance field nor optimizer, so that one bug cannot make both a plan and its proof wrong. Between waypoints
//! positions and headings are linear in time, and every claim is decided for all instants, not for samples:
//!
//! - robots against obstacles and objects: exact distances of segments from polygons, discs and map cells;
//! - the swept net: convex hulls of the four points of a step against the same shapes; touching is allowed, overlap by
//!   more than 1e-9 m is not;
//! - coverage: the quadratic in time at which the line between the robots passes over an object's center;
//! - separation: the minimum of a quadratic, the maximum at the ends of a step;
//! - net reach: an upper bound by branch and bound over time, within 1e-10 m of the true maximum.
//!
//! Unusable input (NaN, coordinates beyond [`COORDINATE_LIMIT`], unequal lengths, fewer than two waypoints, a
//! malformed obstacle) makes claims fail with a detail that says why; nothing panics.

mod added;
mod claims;
mod clearance;
mod farthest;
pub mod infeasibility;
mod map_runs;
mod motion;
mod obstacles;
mod passage;
mod search;
mod subject;
mod tightest;

pub use added::{compare_time_law, net_length_claim, scene_claim};
pub use clearance::Clearance;
pub use subject::COORDINATE_LIMIT;

use pairtrawl_model::{Certificate, PairTrajectory, Scene};
use pairtrawl_reference::Reference;
use subject::Subject;

/// Bounds hold to this much unless the file format says otherwise, in the claim's own unit.
pub const TOLERANCE: f64 = 1e-9;

/// Judges two trajectories against a scene with a net of this length (d_max, m).
///
/// The claims stand in the order of the file format, from `endpoints` to `net_reach`, then `inside_area`; `scene` and
/// `net_length` concern files, see [`scene_claim`] and [`net_length_claim`]. A margin is `INFINITY` where there is
/// nothing to hold the plan against (no obstacle, no object) and `NEG_INFINITY` where the input cannot be judged.
pub fn certify(
    scene: &Scene,
    net_length: f64,
    trajectory: &PairTrajectory,
    reference: Option<&Reference>,
) -> Certificate {
    let claims = match Subject::new(scene, net_length, trajectory, reference) {
        Ok(subject) => claims::ALL
            .iter()
            .map(|claim| (claim.judge)(&subject).into_claim(claim.id, claim.tolerance))
            .collect(),
        Err(fault) => claims::ALL
            .iter()
            .map(|claim| fault.clone().into_claim(claim.id, claim.tolerance))
            .collect(),
    };
    Certificate { claims }
}
