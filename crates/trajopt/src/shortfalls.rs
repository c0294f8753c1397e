//! What a point falls short of: claims that are not met, and margins that gave way.

use crate::active::{PointKind, SAG, Tier};
use crate::problem::Problem;
use crate::state::State;
use pairtrawl_geometry::Point;
use pairtrawl_model::{ClaimId, Side};

/// A constraint that the returned trajectories do not meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// The claim that it stands for.
    pub claim: ClaimId,
    /// Waypoint or step.
    pub step: usize,
    /// By how much, m or rad.
    pub amount: f64,
    /// Index of the object, or of the obstacle piece.
    pub subject: Option<usize>,
    /// Where, m.
    pub place: Point,
}

/// A margin that shrank below the wish.
#[derive(Clone, Debug, PartialEq)]
pub struct ShrunkMargin {
    /// `robot_clearance`, `robots_miss_objects` or `net_encloses_no_obstacle`.
    pub claim: ClaimId,
    /// Waypoint.
    pub step: usize,
    /// What is left of the margin, m.
    pub left: f64,
    /// Where, m.
    pub place: Point,
}

/// Claims that rows stand for fail when a row gives way by more than its margin.
pub(crate) fn shortfalls(problem: &Problem, state: &State) -> (Vec<Violation>, Vec<ShrunkMargin>) {
    const NOISE: f64 = 1e-5;
    let mut violations = Vec::new();
    let mut margins: Vec<ShrunkMargin> = Vec::new();
    let mut judge =
        |claim: ClaimId, step: usize, subject: Option<usize>, place: Point, c: f64, margin: f64| {
            if c < -margin - NOISE {
                violations.push(Violation {
                    claim,
                    step,
                    amount: -c - margin,
                    subject,
                    place,
                });
            } else if c < -1e-3 && margin > 1e-3 {
                let left = margin + c;
                match margins
                    .iter_mut()
                    .find(|m| m.claim == claim && m.place.distance(place) < 1.0)
                {
                    Some(m) if m.left <= left => {}
                    Some(m) => {
                        *m = ShrunkMargin {
                            claim,
                            step,
                            left,
                            place,
                        }
                    }
                    None => margins.push(ShrunkMargin {
                        claim,
                        step,
                        left,
                        place,
                    }),
                }
            }
        };
    let reserve = &problem.reserve;
    for pair in &state.set.pairs {
        let stage = pair.stage as usize;
        let place = state
            .x
            .position(stage, Side::Left)
            .lerp(state.x.position(stage, Side::Right), 0.5);
        let (claim, margin) = match pair.kind {
            0 => (ClaimId::Separation, reserve.separation),
            1 => (ClaimId::Separation, 0.0),
            2 => (ClaimId::NetReach, reserve.net_reach),
            _ => (ClaimId::Abreast, reserve.skew),
        };
        judge(claim, stage, None, place, pair.row.c, margin);
    }
    for point in &state.set.points {
        let stage = point.stage as usize;
        let (claim, subject, margin) = match point.kind {
            PointKind::Object(id, tier) => (
                ClaimId::RobotsMissObjects,
                Some(id as usize),
                slack(tier, reserve.clearance),
            ),
            PointKind::Piece(id, tier) => (
                ClaimId::RobotClearance,
                Some(id as usize),
                slack(tier, reserve.clearance),
            ),
            // A side is a help; the claim is what matters.
            PointKind::Side(..) => continue,
            PointKind::Area(_) => (ClaimId::InsideArea, None, 0.0),
        };
        judge(
            claim,
            stage,
            subject,
            state.x.position(stage, point.robot),
            point.row.c,
            margin,
        );
    }
    for quad in &state.set.quads {
        let stage = quad.step as usize;
        let place = state
            .x
            .position(stage, Side::Left)
            .lerp(state.x.position(stage, Side::Right), 0.5);
        let margin = slack(quad.tier, reserve.net_clearance);
        judge(
            ClaimId::NetEnclosesNoObstacle,
            stage,
            Some(quad.piece as usize),
            place,
            quad.row.c,
            margin,
        );
    }
    violations.sort_by(|a, b| b.amount.total_cmp(&a.amount));
    // Both rows of a thing, that of its margin and that of its claim, tell the same.
    violations.dedup_by(|b, a| {
        (a.claim, a.step, a.subject, a.place) == (b.claim, b.step, b.subject, b.place)
    });
    (violations, margins)
}

/// How far a row may fall below zero before its claim fails, m.
fn slack(tier: Tier, margin: f64) -> f64 {
    match tier {
        Tier::Margin => margin,
        Tier::Claim => SAG.min(margin),
    }
}
