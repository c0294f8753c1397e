//! The baseline pair: two robots on either side of the centerline.

mod band;
mod candidates;
mod lead;
#[cfg(test)]
mod tests;
mod ties;
mod timing;
mod tracks;

use crate::centerline::itinerary::check_order;
use crate::error::RouteError;
use crate::polyline::{resample, with_headings};
use crate::terrain::Terrain;
use band::{Asked, Band};
pub use lead::with_lead;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Circle, PairTrajectory, Scene, Side};
use pairtrawl_world::World;
use tracks::{SPACING, Tracks};

/// How often a baseline is made anew with what was asked for around close objects.
const WAYS_AROUND: usize = 4;

/// The optimizer's start: N waypoints of both robots abreast on the sides of the centerline (eqs. 1 to 3, Fig. 3).
///
/// Away from circles the robots drive `half_separation` beside the centerline; at a circle the two outer ones of the four
/// candidates are taken. The band then widens where an object needs it, narrows or shifts where obstacles leave no room, is
/// blended along the way and relaxed, so that every object lies between the robots and no obstacle does.
///
/// `waypoints` is N; `None` takes `scene.planner.waypoints`, and without that `ceil(1.3 L / max_step) + 1` for the longer
/// path L, or more where turns ask for it. Waypoints are spaced so that the faster robot moves evenly: with the default N
/// neither step exceeds `max_step`. Headings follow each robot's own way and are continuous; first and last poses are the
/// scene's, the last heading up to whole turns.
///
/// # Errors
/// [`RouteError::BadCenterline`], [`RouteError::BadOrder`], [`RouteError::TooFewWaypoints`].
pub fn baseline(
    world: &World,
    scene: &Scene,
    centerline: &[Pose],
    order: &[usize],
    waypoints: Option<usize>,
) -> Result<PairTrajectory, RouteError> {
    on_terrain(
        &Terrain::new(world, scene),
        scene,
        &world.circles,
        centerline,
        order,
        waypoints,
    )
}

pub(crate) fn on_terrain(
    terrain: &Terrain,
    scene: &Scene,
    circles: &[Circle],
    centerline: &[Pose],
    order: &[usize],
    waypoints: Option<usize>,
) -> Result<PairTrajectory, RouteError> {
    check_order(order, circles.len())?;
    let poses = centerline.iter().filter(|p| p.is_finite()).count();
    if poses < 2 || poses < centerline.len() {
        return Err(RouteError::BadCenterline { poses });
    }
    if let Some(waypoints) = waypoints.or(scene.planner.waypoints).filter(|&w| w < 2) {
        return Err(RouteError::TooFewWaypoints { waypoints });
    }
    let points: Vec<Point> = centerline.iter().map(|p| p.position()).collect();
    let fine = resample(&points, SPACING);
    let fine = with_headings(
        &fine,
        centerline[0].heading,
        centerline[centerline.len() - 1].heading,
    );
    let visited: Vec<&Circle> = order.iter().map(|&i| &circles[i]).collect();
    let tracks = around_ties(terrain, scene, &fine, &visited);
    let count = waypoints
        .or(scene.planner.waypoints)
        .unwrap_or_else(|| timing::waypoint_count(&tracks, scene));
    Ok(timing::sample(&tracks, scene, count))
}

/// The relaxed tracks, led around objects that no robot passes between, as far as they can be within a few tries.
fn around_ties(
    terrain: &Terrain,
    scene: &Scene,
    centerline: &[Pose],
    circles: &[&Circle],
) -> Tracks {
    let mut asked = Asked::default();
    let mut tries = 0;
    loop {
        let band = band::band(terrain, scene, centerline, circles, &asked);
        let mut tracks = beside(centerline, scene, &band);
        tracks.relax(terrain, scene, centerline, &band);
        tries += 1;
        if tries > WAYS_AROUND
            || !ties::ask_for_ways_around(terrain, centerline, &tracks, &band.visits, &mut asked)
        {
            return tracks;
        }
    }
}

/// Both robots beside the centerline, as far from it as the band says; the robot that is ahead stands beside a later point.
fn beside(centerline: &[Pose], scene: &Scene, band: &Band) -> Tracks {
    let last = centerline.len() - 1;
    let track = |side: Side, offsets: &[f64]| -> Vec<Point> {
        let beside = |at: f64| {
            let at = at.clamp(0.0, last as f64);
            let i = (at as usize).min(last - 1);
            let pose = centerline[i].lerp(centerline[i + 1], at - i as f64);
            let offset = offsets[i] + (offsets[i + 1] - offsets[i]) * (at - i as f64);
            pose.position() + pose.forward().perp() * (side.sign() * offset)
        };
        band.lead
            .iter()
            .enumerate()
            .map(|(i, lead)| beside(i as f64 + 0.5 * side.sign() * lead / SPACING))
            .collect()
    };
    let mut tracks = Tracks {
        left: track(Side::Left, &band.left),
        right: track(Side::Right, &band.right),
    };
    tracks.left[0] = scene.start.left.position();
    tracks.right[0] = scene.start.right.position();
    tracks.left[last] = scene.end.left.position();
    tracks.right[last] = scene.end.right.position();
    tracks
}
