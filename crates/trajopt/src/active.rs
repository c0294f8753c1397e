//! Which constraints are in play: the fixed ones of every step and waypoint, and those of objects and obstacles nearby,
//! which are looked up again as the trajectories move.

use crate::constraints::{CenterDistance, HalfPlane, PointDistance, RungDistance};
use crate::iterate::Iterate;
use crate::problem::Problem;
use crate::row::Row;
use crate::step::TURN_COST;
use crate::term::{Jet, PAIR, POINT, RUNG, Term};

/// Rows of the pair at one waypoint: separation above, below, net reach, abreast left, abreast right.
pub(crate) const PAIR_ROWS: usize = 5;
/// Objects and obstacles are in play up to this far beyond the distance that is kept from them, m.
const LOOK_AHEAD: f64 = 0.35;
/// Rows of the claim itself are in play up to this far, m.
const CLAIM_AHEAD: f64 = 0.15;
const CLAIM_PRICE: f64 = 30.0;
/// A chord between waypoints comes this much nearer to a corner than the waypoints, m: `max_step^2 / (8 radius)`.
pub(crate) const SAG: f64 = 1.4e-3;
/// At most this many obstacle pieces a robot or line at a waypoint: the nearest ones.
const MOST_PIECES: usize = 6;

/// How much is kept from a thing: the wished-for margin, which may give way at a price, or what the claim needs, which
/// costs far more. Without the second a squeezed robot would give up all of one distance to save another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tier {
    Margin,
    Claim,
}

impl Tier {
    /// Price of a meter, as a multiple of the elastic weight.
    fn price(self) -> f64 {
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

    const BOTH: [Self; 2] = [Self::Margin, Self::Claim];
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
    fn key(&self) -> (u8, u32) {
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
    pub robot: u8,
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
pub(crate) struct RungRow {
    pub stage: u32,
    pub piece: u32,
    pub tier: Tier,
    pub row: Row<RUNG>,
}

impl PointRow {
    fn key(&self) -> (u32, u8, (u8, u32)) {
        (self.stage, self.robot, self.kind.key())
    }
}

impl RungRow {
    fn key(&self) -> (u32, u32, u8) {
        (self.stage, self.piece, self.tier as u8)
    }
}

/// Runs a block for every row.
macro_rules! each_row {
    ($set:expr, $row:ident, $with:block) => {
        for $row in &$set.steps $with
        for item in &$set.pairs { let $row = &item.row; $with }
        for item in &$set.points { let $row = &item.row; $with }
        for item in &$set.rungs { let $row = &item.row; $with }
    };
}

/// Runs a block for every row, which it may change.
macro_rules! each_row_mut {
    ($set:expr, $row:ident, $with:block) => {
        for $row in &mut $set.steps $with
        for item in &mut $set.pairs { let $row = &mut item.row; $with }
        for item in &mut $set.points { let $row = &mut item.row; $with }
        for item in &mut $set.rungs { let $row = &mut item.row; $with }
    };
}

/// All rows.
#[derive(Clone, Debug, Default)]
pub(crate) struct ActiveSet {
    /// Five bounds a robot and step.
    pub steps: Vec<Row<1>>,
    pub pairs: Vec<PairRow>,
    pub points: Vec<PointRow>,
    pub rungs: Vec<RungRow>,
    /// Waypoint at which the rung passes over each object.
    pub crossings: Vec<usize>,
}

impl Problem {
    pub(crate) fn pair_term<R>(&self, kind: u8, with: impl Fn(&dyn Term<PAIR>) -> R) -> R {
        match kind {
            0 => with(&self.separation_above()),
            1 => with(&self.separation_below()),
            2 => with(&self.net_reach()),
            3 => with(&self.abreast(2)),
            _ => with(&self.abreast(3)),
        }
    }

    fn object_keep(&self, id: u32, tier: Tier) -> f64 {
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

    pub(crate) fn rung_distance(&self, piece: u32, tier: Tier) -> RungDistance<'_> {
        RungDistance {
            region: self.pieces.get(piece),
            keep: tier.reserve(self.reserve.net_clearance),
        }
    }
}

impl ActiveSet {
    /// The rows of a problem around an iterate, on the central path of `mu`.
    pub fn new(problem: &Problem, x: &Iterate, weight: f64, mu: f64) -> Self {
        let n = x.stages.len();
        let mut set = Self::default();
        let bounds = problem.step_bounds();
        for i in 0..n - 1 {
            for robot in 0..2 {
                let step = x.step(i, robot);
                for (kind, bound) in bounds.iter().enumerate() {
                    let weight = if kind == TURN_COST {
                        2.0 * problem.turn_weight()
                    } else {
                        f64::INFINITY
                    };
                    set.steps
                        .push(Row::centered(bound.value(&step), weight, mu));
                }
            }
        }
        for i in 0..n {
            let inner = i > 0 && i < n - 1;
            for kind in 0..PAIR_ROWS as u8 {
                if inner || (problem.net_length.is_none() && (kind == 1 || kind == 2)) {
                    let c = problem.pair_term(kind, |t| t.value(&x.pair(i)));
                    set.pairs.push(PairRow {
                        stage: i as u32,
                        kind,
                        row: Row::centered(c, weight, mu),
                    });
                }
            }
        }
        set.refresh(problem, x, weight, mu);
        set
    }

    /// Looks up again what is near, keeping the multipliers of what stays in play.
    pub fn refresh(&mut self, problem: &Problem, x: &Iterate, weight: f64, mu: f64) {
        self.refresh_crossings(problem, x);
        let old_points = std::mem::take(&mut self.points);
        let old_rungs = std::mem::take(&mut self.rungs);
        let mut near = Vec::new();
        for i in 1..x.stages.len() - 1 {
            for robot in 0..2 {
                self.look_up_point(problem, x, (i, robot), weight, mu, &mut near);
            }
            self.look_up_rung(problem, x, i, weight, mu, &mut near);
        }
        carry_over(&mut self.points, &old_points, PointRow::key, |p| &mut p.row);
        carry_over(&mut self.rungs, &old_rungs, RungRow::key, |r| &mut r.row);
    }

    fn look_up_point(
        &mut self,
        problem: &Problem,
        x: &Iterate,
        (stage, robot): (usize, u8),
        weight: f64,
        mu: f64,
        near: &mut Vec<(f64, u32)>,
    ) {
        let p = x.position(stage, robot.into());
        let value = |kind: &PointKind| problem.point_term(kind, |t| t.value(&p.into()));
        let first = self.points.len();
        let mut push = |kind: PointKind, c: f64, weight: f64| {
            let row = Row::centered(c, weight, mu);
            self.points.push(PointRow {
                stage: stage as u32,
                robot,
                kind,
                row,
            });
        };
        let mut push_tiers = |kind: &dyn Fn(Tier) -> PointKind| {
            for tier in Tier::BOTH {
                let c = value(&kind(tier));
                if tier == Tier::Margin || c < CLAIM_AHEAD {
                    push(kind(tier), c, weight * tier.price());
                }
            }
        };
        for id in 0..problem.objects.len() as u32 {
            let reach = problem.object_keep(id, Tier::Margin) + LOOK_AHEAD;
            if (p - problem.objects[id as usize].0).norm_squared() < reach * reach {
                push_tiers(&|tier| PointKind::Object(id, tier));
            }
        }
        near.clear();
        let reach = problem.robot.radius + problem.reserve.clearance + LOOK_AHEAD;
        for &id in problem.pieces.near(p) {
            if problem.pieces.get(id).may_be_near(p, p, reach) {
                let c = value(&PointKind::Piece(id, Tier::Margin));
                if c < LOOK_AHEAD {
                    near.push((c, id));
                }
            }
        }
        for &id in keep_nearest(near) {
            push_tiers(&|tier| PointKind::Piece(id, tier));
        }
        for (id, &crossing) in self.crossings.iter().enumerate() {
            if crossing == stage {
                let kind = PointKind::Side(id as u32, side_plane(problem, x, stage, id, robot));
                push(kind, value(&kind), weight);
            }
        }
        for side in 0..4 {
            let kind = PointKind::Area(side);
            let c = value(&kind);
            if c < LOOK_AHEAD {
                push(kind, c, f64::INFINITY);
            }
        }
        self.points[first..].sort_by_key(PointRow::key);
    }

    fn look_up_rung(
        &mut self,
        problem: &Problem,
        x: &Iterate,
        stage: usize,
        weight: f64,
        mu: f64,
        near: &mut Vec<(f64, u32)>,
    ) {
        near.clear();
        let rung = x.rung(stage);
        let (l, r) = (x.position(stage, 0), x.position(stage, 1));
        let mut candidates: Vec<u32> = [l, r, l.lerp(r, 0.5)]
            .iter()
            .flat_map(|&p| problem.pieces.near(p).iter().copied())
            .collect();
        candidates.sort_unstable();
        candidates.dedup();
        for id in candidates {
            let reach = problem.reserve.net_clearance + LOOK_AHEAD;
            if problem.pieces.get(id).may_be_near(l, r, reach) {
                let c = problem.rung_distance(id, Tier::Margin).value(&rung);
                if c < LOOK_AHEAD {
                    near.push((c, id));
                }
            }
        }
        for &piece in keep_nearest(near) {
            for tier in Tier::BOTH {
                let c = problem.rung_distance(piece, tier).value(&rung);
                if tier == Tier::Margin || c < CLAIM_AHEAD {
                    let row = Row::centered(c, weight * tier.price(), mu);
                    self.rungs.push(RungRow {
                        stage: stage as u32,
                        piece,
                        tier,
                        row,
                    });
                }
            }
        }
    }

    /// The waypoint at which the rung passes over each object: of those where it does, the one nearest the object along the
    /// direction of travel; else the one where it nearly does.
    fn refresh_crossings(&mut self, problem: &Problem, x: &Iterate) {
        let first = self.crossings.is_empty();
        for (id, &(object, _)) in problem.objects.iter().enumerate() {
            let n = x.stages.len();
            let window = if first {
                1..n - 1
            } else {
                let k = self.crossings[id];
                k.saturating_sub(n / 8).max(1)..(k + n / 8).min(n - 1)
            };
            let miss = |i: usize| {
                let (l, r) = (x.position(i, 0), x.position(i, 1));
                let rung = l - r;
                let length = rung.norm();
                let along = (object - r).dot(rung) / length;
                let ahead = (object - r).cross(rung).abs() / length;
                ahead + 4.0 * (-along).max(along - length).max(0.0)
            };
            let best = window
                .min_by(|&a, &b| miss(a).total_cmp(&miss(b)))
                .unwrap_or(1);
            if first {
                self.crossings.push(best);
            } else {
                self.crossings[id] = best;
            }
        }
    }
}

/// The half-plane of a robot beside an object that the rung passes over: beyond the distance that it keeps.
fn side_plane(problem: &Problem, x: &Iterate, i: usize, object: usize, robot: u8) -> HalfPlane {
    let (l, r) = (x.position(i, 0), x.position(i, 1));
    let out = (l - r) / l.distance(r) * if robot == 0 { 1.0 } else { -1.0 };
    let (center, keep) = problem.objects[object];
    HalfPlane {
        normal: out.into(),
        offset: out.dot(center) + 0.9 * keep,
    }
}

/// The ids of the nearest few, ascending.
fn keep_nearest(near: &mut Vec<(f64, u32)>) -> impl Iterator<Item = &u32> {
    near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    near.truncate(MOST_PIECES);
    near.sort_unstable_by_key(|n| n.1);
    near.iter().map(|(_, id)| id)
}

/// Copies slack, violation and multiplier of rows that were there before; both lists ascend by key.
fn carry_over<T, K: Ord, const N: usize>(
    new: &mut [T],
    old: &[T],
    key: impl Fn(&T) -> K,
    row: impl Fn(&mut T) -> &mut Row<N>,
) where
    T: Clone,
{
    let mut rest = old.iter().peekable();
    for item in new {
        let k = key(item);
        while rest.next_if(|o| key(o) < k).is_some() {}
        if let Some(o) = rest.next_if(|o| key(o) == k) {
            let c = row(item).c;
            let mut previous = o.clone();
            *row(item) = *row(&mut previous);
            let row = row(item);
            row.c = c;
            row.s = row.s.max(c + row.e);
        }
    }
}

/// Value or jet of a row's term; the compiler inlines the choice.
pub(crate) fn jet_of<const K: usize>(z: &[f64; K]) -> impl Fn(&dyn Term<K>) -> Jet<K> + '_ {
    move |t| t.jet(z)
}
