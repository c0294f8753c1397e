//! What is near: objects and obstacles that a robot or the line between the robots may touch soon, and where the line passes
//! over each object.

use crate::active::{ActiveSet, PAIR_ROWS, PairRow, PointKind, PointRow, QuadRow, Tier};
use crate::constraints::HalfPlane;
use crate::iterate::Iterate;
use crate::pieces::SEARCH_RADIUS;
use crate::problem::Problem;
use crate::row::Row;
use crate::step::TURN_COST;
use crate::term::Term;
use pairtrawl_model::Side;

/// Objects and obstacles are in play up to this far beyond the distance that is kept from them, m.
const LOOK_AHEAD: f64 = 0.2;
/// What the net's line sweeps: obstacles in play up to this far. Robots keep farther away themselves, so that only what is
/// nearer to the inside of the line comes so close.
const NET_AHEAD: f64 = 0.2;
/// Rows of the claim itself are in play up to this far, m.
const CLAIM_AHEAD: f64 = 0.15;
/// At most this many obstacle pieces a robot or line at a waypoint: the nearest ones.
const MOST_PIECES: usize = 6;

/// Waypoints between those that are tried first for the crossing of an object.
const STRIDE: usize = 4;
/// Waypoints by which a crossing moves at most from one look to the next.
const FARTHEST_CROSSING: usize = 100;

/// Lists that are filled anew for every waypoint.
#[derive(Default)]
struct Scratch {
    candidates: Vec<u32>,
    /// Distances and ids.
    near: Vec<(f64, u32)>,
    /// Waypoints at which the rung passes over an object, ascending, and the object.
    crossings: Vec<(usize, u32)>,
}

impl ActiveSet {
    /// The rows of a problem around an iterate, on the central path of `mu`.
    pub fn new(problem: &Problem, x: &Iterate, weight: f64, mu: f64) -> Self {
        let n = x.stages.len();
        let mut set = Self::default();
        let bounds = problem.step_bounds();
        for i in 0..n - 1 {
            for robot in Side::BOTH {
                let step = problem.step(x, i, robot);
                set.frames.push(step);
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
                if problem.has_pair_row(kind, inner) {
                    let c = problem.pair_term(kind, i, |t| t.value(&x.pair(i)));
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
        // Room for a few more rows than before: growing lists cost more than looking things up.
        let room = |rows: usize| rows + rows / 4;
        let points = Vec::with_capacity(room(self.points.len()));
        let quads = Vec::with_capacity(room(self.quads.len()));
        let old_points = std::mem::replace(&mut self.points, points);
        let old_quads = std::mem::replace(&mut self.quads, quads);
        let mut scratch = Scratch::default();
        scratch
            .crossings
            .extend(self.crossings.iter().copied().zip(0..));
        scratch.crossings.sort_unstable();
        for i in 1..x.stages.len() - 1 {
            for robot in Side::BOTH {
                self.look_up_point(problem, x, (i, robot), weight, mu, &mut scratch);
            }
        }
        for i in 0..x.stages.len() - 1 {
            self.look_up_quad(problem, x, i, weight, mu, &mut scratch);
        }
        carry_over(&mut self.points, &old_points, PointRow::key, |p| &mut p.row);
        carry_over(&mut self.quads, &old_quads, QuadRow::key, |q| &mut q.row);
    }

    fn look_up_point(
        &mut self,
        problem: &Problem,
        x: &Iterate,
        (stage, robot): (usize, Side),
        weight: f64,
        mu: f64,
        Scratch {
            near, crossings, ..
        }: &mut Scratch,
    ) {
        let p = x.position(stage, robot);
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
        for &id in problem.object_index.near(p) {
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
        let after = &crossings[crossings.partition_point(|c| c.0 < stage)..];
        for &(_, id) in after.iter().take_while(|c| c.0 == stage) {
            let plane = side_plane(problem, x, stage, id as usize, robot);
            let kind = PointKind::Side(id, plane);
            push(kind, value(&kind), weight);
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

    fn look_up_quad(
        &mut self,
        problem: &Problem,
        x: &Iterate,
        step: usize,
        weight: f64,
        mu: f64,
        Scratch {
            candidates, near, ..
        }: &mut Scratch,
    ) {
        near.clear();
        let quad = x.quad(step);
        let (l, r) = (x.position(step, Side::Left), x.position(step, Side::Right));
        let (to_l, to_r) = (
            x.position(step + 1, Side::Left),
            x.position(step + 1, Side::Right),
        );
        candidates.clear();
        let farthest = l.distance(to_l).max(r.distance(to_r));
        let reach = problem.reserve.net_clearance + NET_AHEAD + farthest;
        // Near enough to each other that what is near the line is found from one of them.
        let stretches = (l.distance(r) / SEARCH_RADIUS).ceil().max(1.0);
        for k in 0..=stretches as usize {
            let p = l.lerp(r, k as f64 / stretches);
            let may_be_near = |id: &&u32| problem.pieces.get(**id).may_be_near(l, r, reach);
            candidates.extend(problem.pieces.near(p).iter().filter(may_be_near));
        }
        candidates.sort_unstable();
        candidates.dedup();
        for &mut id in candidates {
            let c = problem.quad_distance(id, Tier::Margin).value(&quad);
            if c < NET_AHEAD {
                near.push((c, id));
            }
        }
        for &piece in keep_nearest(near) {
            for tier in Tier::BOTH {
                let c = problem.quad_distance(piece, tier).value(&quad);
                if tier == Tier::Margin || c < CLAIM_AHEAD {
                    let row = Row::centered(c, weight * tier.price(), mu);
                    self.quads.push(QuadRow {
                        step: step as u32,
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
            let miss = |i: usize| {
                let (l, r) = (x.position(i, Side::Left), x.position(i, Side::Right));
                let rung = l - r;
                let length = rung.norm();
                let along = (object - r).dot(rung) / length;
                let ahead = (object - r).cross(rung).abs() / length;
                ahead + 4.0 * (-along).max(along - length).max(0.0)
            };
            let nearest = |window: &mut dyn Iterator<Item = usize>| {
                window
                    .min_by(|&a, &b| miss(a).total_cmp(&miss(b)))
                    .unwrap_or(1)
            };
            let around =
                |k: usize, reach: usize| k.saturating_sub(reach).max(1)..(k + reach + 1).min(n - 1);
            if first {
                let coarse = nearest(&mut (1..n - 1).step_by(STRIDE));
                self.crossings.push(nearest(&mut around(coarse, STRIDE)));
            } else {
                let reach = (n / 8).min(FARTHEST_CROSSING);
                self.crossings[id] = nearest(&mut around(self.crossings[id], reach));
            }
        }
    }
}

/// The half-plane of a robot beside an object that the rung passes over: beyond the distance that it keeps.
fn side_plane(problem: &Problem, x: &Iterate, i: usize, object: usize, robot: Side) -> HalfPlane {
    let (l, r) = (x.position(i, Side::Left), x.position(i, Side::Right));
    let out = (l - r) / l.distance(r) * robot.sign();
    let (center, keep) = problem.objects[object];
    HalfPlane {
        normal: out.into(),
        offset: out.dot(center) + 0.9 * keep,
    }
}

/// The ids of the nearest few, ascending.
fn keep_nearest(near: &mut Vec<(f64, u32)>) -> impl Iterator<Item = &u32> {
    if near.len() > MOST_PIECES {
        near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        near.truncate(MOST_PIECES);
    }
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
