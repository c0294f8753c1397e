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
/// At most this many obstacle pieces a robot or line at a waypoint: the nearest ones.
const MOST_PIECES: usize = 6;

/// What a robot keeps from at a waypoint.
#[derive(Clone, Copy, Debug)]
pub(crate) enum PointKind {
    Object(u32),
    Piece(u32),
    /// On its side of an object where the rung passes over it.
    Side(u32, HalfPlane),
    /// 0..4: left, right, lower, upper bound of the area.
    Area(u8),
}

impl PointKind {
    fn key(&self) -> (u8, u32) {
        match *self {
            Self::Object(id) => (0, id),
            Self::Piece(id) => (1, id),
            Self::Side(id, _) => (2, id),
            Self::Area(side) => (3, side.into()),
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
    pub row: Row<RUNG>,
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

    fn object_keep(&self, id: u32) -> f64 {
        self.objects[id as usize].1 + self.reserve.clearance
    }

    pub(crate) fn point_term<R>(
        &self,
        kind: &PointKind,
        with: impl Fn(&dyn Term<POINT>) -> R,
    ) -> R {
        match *kind {
            PointKind::Object(id) => with(&CenterDistance {
                center: self.objects[id as usize].0,
                keep: self.object_keep(id),
            }),
            PointKind::Piece(id) => with(&PointDistance {
                region: self.pieces.get(id),
                keep: self.robot.radius + self.reserve.clearance,
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

    pub(crate) fn rung_distance(&self, piece: u32) -> RungDistance<'_> {
        RungDistance {
            region: self.pieces.get(piece),
            keep: self.reserve.net_clearance,
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
            let stage = i as u32;
            for robot in 0..2u8 {
                let p = x.position(i, robot.into());
                let mut push = |kind: PointKind, weight: f64| {
                    let c = problem.point_term(&kind, |t| t.value(&p.into()));
                    self.points.push(PointRow {
                        stage,
                        robot,
                        kind,
                        row: Row::centered(c, weight, mu),
                    });
                };
                for id in 0..problem.objects.len() as u32 {
                    if p.distance(problem.objects[id as usize].0)
                        < problem.object_keep(id) + LOOK_AHEAD
                    {
                        push(PointKind::Object(id), weight);
                    }
                }
                near.clear();
                let reach = problem.robot.radius + problem.reserve.clearance + LOOK_AHEAD;
                for &id in problem.pieces.near(p) {
                    if !problem.pieces.get(id).may_be_near(p, p, reach) {
                        continue;
                    }
                    let c = problem.point_term(&PointKind::Piece(id), |t| t.value(&p.into()));
                    if c < LOOK_AHEAD {
                        near.push((c, id));
                    }
                }
                for &id in keep_nearest(&mut near) {
                    push(PointKind::Piece(id), weight);
                }
                for (id, &crossing) in self.crossings.iter().enumerate() {
                    if crossing == i {
                        push(
                            PointKind::Side(id as u32, side_plane(problem, x, i, id, robot)),
                            weight,
                        );
                    }
                }
                for side in 0..4 {
                    let kind = PointKind::Area(side);
                    if problem.point_term(&kind, |t| t.value(&p.into())) < LOOK_AHEAD {
                        push(kind, f64::INFINITY);
                    }
                }
            }
            near.clear();
            let rung = x.rung(i);
            let (l, r) = (x.position(i, 0), x.position(i, 1));
            let mut candidates: Vec<u32> = [l, r, l.lerp(r, 0.5)]
                .iter()
                .flat_map(|&p| problem.pieces.near(p).iter().copied())
                .collect();
            candidates.sort_unstable();
            candidates.dedup();
            for id in candidates {
                if !problem.pieces.get(id).may_be_near(
                    l,
                    r,
                    problem.reserve.net_clearance + LOOK_AHEAD,
                ) {
                    continue;
                }
                let c = problem.rung_distance(id).value(&rung);
                if c < LOOK_AHEAD {
                    near.push((c, id));
                }
            }
            for &piece in keep_nearest(&mut near) {
                let c = problem.rung_distance(piece).value(&rung);
                self.rungs.push(RungRow {
                    stage,
                    piece,
                    row: Row::centered(c, weight, mu),
                });
            }
        }
        carry_over(
            &mut self.points,
            &old_points,
            |p| (p.stage, p.robot, p.kind.key()),
            |p| &mut p.row,
        );
        carry_over(
            &mut self.rungs,
            &old_rungs,
            |r| (r.stage, 0, (0, r.piece)),
            |r| &mut r.row,
        );
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
