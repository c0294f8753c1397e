//! Ways around the places where attempts got stuck: the next centerline keeps away from them, and another way is found where
//! there is one. Such a place is a passage that looks wide enough for the pair and is not, or a knot of the baseline.

use crate::not_found::NotFound;
use crate::prepare::Prepared;
use pairtrawl_geometry::Point;
use pairtrawl_model::{Claim, ClaimId, Plan};
use pairtrawl_world::ClosedPlace;

/// Detours that are tried, at most.
pub(crate) const DETOURS: usize = 8;

// Lengths are in units of the length scale.
/// Radius of a closed place.
const RADIUS: f64 = 0.3;
/// An attempt that is stuck within a closed place makes it wider by this factor.
const WIDER: f64 = 1.5;
/// Nothing is closed so near to the start or the end.
const ENDS: f64 = 0.8;
/// A closed place reaches this share of the way to the nearest object that is to be gathered, and is not made where that is less than [`LEAST`].
const SHARE: f64 = 0.6;
const LEAST: f64 = 0.1;

/// The same scene with the place closed to the route where the claim that fails by most fails; `None` when it cannot be closed.
pub(crate) fn closing_where_stuck<'a>(
    prepared: &Prepared<'a>,
    refused: &NotFound,
) -> Option<Prepared<'a>> {
    let place = place_of(refused.missing.claim()?, refused.best.as_ref()?)?;
    let mut rest = prepared.clone();
    close(&mut rest, place * (1.0 / prepared.scales.length)).then_some(rest)
}

/// Where an attempt is stuck, m: the robot that is too near to something, or the middle of the pair.
fn place_of(claim: &Claim, best: &Plan) -> Option<Point> {
    match claim.id {
        ClaimId::RobotClearance | ClaimId::RobotsMissObjects => claim.place,
        ClaimId::NetEnclosesNoObstacle
        | ClaimId::Separation
        | ClaimId::RobotsApart
        | ClaimId::NetReach
        | ClaimId::Abreast
        | ClaimId::Step
        | ClaimId::Turn
        | ClaimId::Forward
        | ClaimId::NoSidewaysSlip
        | ClaimId::Speed
        | ClaimId::InsideArea => {
            let step = claim.step.filter(|&step| step < best.trajectory.len())?;
            Some(best.trajectory.pair(step).midpoint())
        }
        ClaimId::Scene | ClaimId::NetLength | ClaimId::Endpoints | ClaimId::EveryObjectCovered => {
            None
        }
    }
}

/// Closes a place, in units of the length scale, or makes the closed place there wider. False when it cannot be closed.
fn close(rest: &mut Prepared, center: Point) -> bool {
    let scene = &rest.scaled;
    let ends = [scene.start.midpoint(), scene.end.midpoint()];
    if ends.iter().any(|end| end.distance(center) < ENDS) {
        return false;
    }
    let wanted = scene.objects.iter().filter(|object| !object.leave);
    let most = wanted
        .map(|object| SHARE * object.position.distance(center))
        .fold(f64::INFINITY, f64::min);
    let closed = &mut rest.world.closed;
    let here = (closed.iter_mut()).find(|place| place.center.distance(center) < place.radius);
    match here {
        Some(place) => {
            let wider = (WIDER * place.radius).min(most);
            let grows = wider > place.radius;
            place.radius = wider.max(place.radius);
            grows
        }
        None => {
            let radius = RADIUS.min(most);
            if radius > LEAST {
                closed.push(ClosedPlace { center, radius });
            }
            radius > LEAST
        }
    }
}
