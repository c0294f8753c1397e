//! Which constraints are in play: the fixed ones of every step and waypoint, and those of objects and obstacles nearby,
//! which are looked up again as the trajectories move.

use crate::constraints::{
    CenterDistance, HalfPlane, PointDistance, QuadDistance, SeparationAbove, SeparationBelow,
};
use crate::problem::{Problem, SeparationRule};
use crate::row::Row;
use crate::step::Step;
use crate::term::{PAIR, POINT, QUAD, Term};
use pairtrawl_model::Side;

/// Rows of the pair at one waypoint: separation above, below, net reach, abreast left, abreast right.
pub(crate) const PAIR_ROWS: usize = 5;
const CLAIM_PRICE: f64 = 30.0;
/// A chord between waypoints comes this much nearer to a corner than the waypoints, m: `max_step^2 / (8 radius)`.
pub(crate) const SAG: f64 = 1.4e-3;
/// A rigid separation holds to this, m.
const RIGID_TOLERANCE: f64 = 5e-3;

/// How much is kept from a thing: the wished-for margin, which may give way at a price, or what the claim needs, which
/// costs far more. Without the second a squeezed robot would give up all of one distance to save another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tier {
    Margin,
    Claim,
}

impl Tier {
    /// Price of a meter, as a multiple of the elastic weight.
    pub fn price(self) -> f64 {
        match self {
            Self::Margin => 1.0,
            Self::Claim => CLAIM_PRICE,
        }
    }

    /// Distance kept beyond the claim's bound, m.
    fn reserve(self, margin: f64) -> f64 {
        match self {
            Self::Margin => margin,
            Self::Claim => SAG.min(margin),
        }
    }

    pub const BOTH: [Self; 2] = [Self::Margin, Self::Claim];
}

/// What a robot keeps from at a waypoint.
#[derive(Clone, Copy, Debug)]
pub(crate) enum PointKind {
    /// The object and how much is kept.
    Object(u32, Tier),
    /// The obstacle piece and how much is kept.
    Piece(u32, Tier),
    /// On its side of an object where the rung passes over it.
    Side(u32, HalfPlane),
    /// 0..4: left, right, lower, upper bound of the area.
    Area(u8),
}

impl PointKind {
    pub fn key(&self) -> (u8, u32) {
        match *self {
            Self::Object(id, tier) => (tier as u8, id),
            Self::Piece(id, tier) => (2 + tier as u8, id),
            Self::Side(id, _) => (4, id),
            Self::Area(side) => (5, side.into()),
        }
    }
}

#[derive(Clone, Debug)]
pub(crate) struct PointRow {
    pub stage: u32,
    pub robot: Side,
    pub kind: PointKind,
    pub row: Row<POINT>,
}

#[derive(Clone, Debug)]
pub(crate) struct PairRow {
    pub stage: u32,
    pub kind: u8,
    pub row: Row<PAIR>,
}

#[derive(Clone, Debug)]
pub(crate) struct QuadRow {
    /// Step: from this waypoint to the next.
    pub step: u32,
    pub piece: u32,
    pub tier: Tier,
    pub row: Row<QUAD>,
}

impl PointRow {
    pub fn key(&self) -> (u32, Side, (u8, u32)) {
        (self.stage, self.robot, self.kind.key())
    }
}

impl QuadRow {
    pub fn key(&self) -> (u32, u32, u8) {
        (self.step, self.piece, self.tier as u8)
    }
}

/// Runs a block for every row.
#[cfg(test)]
macro_rules! each_row {
    ($set:expr, $row:ident, $with:block) => {
        for $row in &$set.steps $with
        for item in &$set.pairs { let $row = &item.row; $with }
        for item in &$set.points { let $row = &item.row; $with }
        for item in &$set.quads { let $row = &item.row; $with }
    };
}

/// Runs a block for every row, which it may change.
macro_rules! each_row_mut {
    ($set:expr, $row:ident, $with:block) => {
        for $row in &mut $set.steps $with
        for item in &mut $set.pairs { let $row = &mut item.row; $with }
        for item in &mut $set.points { let $row = &mut item.row; $with }
        for item in &mut $set.quads { let $row = &mut item.row; $with }
    };
}

/// All rows.
#[derive(Clone, Debug, Default)]
pub(crate) struct ActiveSet {
    /// Five bounds a robot and step.
    pub steps: Vec<Row<1>>,
    /// Every robot-step, at the iterate or at the last trial point.
    pub frames: Vec<Step>,
    pub pairs: Vec<PairRow>,
    pub points: Vec<PointRow>,
    pub quads: Vec<QuadRow>,
    /// Waypoint at which the rung passes over each object.
    pub crossings: Vec<usize>,
}

impl Problem {
    /// The term of a pair row, kinds as in [`PAIR_ROWS`].
    pub(crate) fn pair_term<R>(
        &self,
        kind: u8,
        stage: usize,
        with: impl Fn(&dyn Term<PAIR>) -> R,
    ) -> R {
        if let SeparationRule::Rigid { from, to } = self.separation
            && kind < 2
            && (from..=to).contains(&stage)
        {
            let ratio = self.planner.rest_ratio;
            return match kind {
                0 => with(&SeparationAbove {
                    lower: -RIGID_TOLERANCE,
                    ratio,
                }),
                _ => with(&SeparationBelow {
                    reserve: -RIGID_TOLERANCE,
                    ratio,
                }),
            };
        }
        match kind {
            0 => with(&self.separation_above()),
            1 => with(&self.separation_below()),
            2 => with(&self.net_reach()),
            3 => with(&self.abreast(2)),
            _ => with(&self.abreast(3)),
        }
    }

    /// True when a pair row has something to say at a waypoint: fixed poses only bound a net length that is free.
    pub(crate) fn has_pair_row(&self, kind: u8, inner: bool) -> bool {
        let bounds_length = kind == 1 || kind == 2;
        if bounds_length && self.separation == SeparationRule::Free {
            return false;
        }
        inner || (bounds_length && self.net_length.is_none())
    }

    pub(crate) fn object_keep(&self, id: u32, tier: Tier) -> f64 {
        self.objects[id as usize].1 + tier.reserve(self.reserve.clearance)
    }

    pub(crate) fn point_term<R>(
        &self,
        kind: &PointKind,
        with: impl Fn(&dyn Term<POINT>) -> R,
    ) -> R {
        match *kind {
            PointKind::Object(id, tier) => with(&CenterDistance {
                center: self.objects[id as usize].0,
                keep: self.object_keep(id, tier),
            }),
            PointKind::Piece(id, tier) => with(&PointDistance {
                region: self.pieces.get(id),
                keep: self.robot.radius + tier.reserve(self.reserve.clearance),
            }),
            PointKind::Side(_, plane) => with(&plane),
            PointKind::Area(side) => {
                let (min, max) = (self.area.min, self.area.max);
                with(&match side {
                    0 => HalfPlane {
                        normal: [1.0, 0.0],
                        offset: min.x + 1e-6,
                    },
                    1 => HalfPlane {
                        normal: [-1.0, 0.0],
                        offset: 1e-6 - max.x,
                    },
                    2 => HalfPlane {
                        normal: [0.0, 1.0],
                        offset: min.y + 1e-6,
                    },
                    _ => HalfPlane {
                        normal: [0.0, -1.0],
                        offset: 1e-6 - max.y,
                    },
                })
            }
        }
    }

    pub(crate) fn quad_distance(&self, piece: u32, tier: Tier) -> QuadDistance<'_> {
        QuadDistance {
            region: self.pieces.get(piece),
            keep: tier.reserve(self.reserve.net_clearance),
        }
    }
}

/// Value and gradient of a row's term; the compiler inlines the choice.
pub(crate) fn slope_of<const K: usize>(
    z: &[f64; K],
) -> impl Fn(&dyn Term<K>) -> (f64, [f64; K]) + '_ {
    move |t| t.slope(z)
}
