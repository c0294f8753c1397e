//! The Lagrangian written a second time, from the formulas alone, and the assembled gradients against its differences.

use super::case::{Case, shaken};
use crate::anchor::Anchor;
use crate::constraints::half_plane::Border;
use crate::constraints::point_distance::{OffObject, OffObstacle};
use crate::constraints::quad_distance::QuadDistance;
use crate::constraints::{LineRules, PairRules, PointRules};
use crate::curvature::Curvature;
use crate::iterate::{Iterate, STAGE};
use crate::pieces::Piece;
use crate::row::Row;
use crate::rule::Rules;
use crate::state::State;
use crate::step::Step;
use crate::system::System;
use crate::term::Term;
use crate::tier::Tier;
use pairtrawl_geometry::{Convex, Hull, Point, Polygon, Pose};
use pairtrawl_model::Side;

/// What a multiplier at a waypoint belongs to.
enum Subject {
    Pair(PairRules),
    Point(Side, PointRules),
}

/// Objective minus multipliers times constraints plus multipliers times slips.
pub struct Lagrangian<'a> {
    case: &'a Case,
    /// By waypoint.
    at_stages: Vec<Vec<(Subject, f64)>>,
    /// By step and robot: of the five bounds, and of the slip.
    at_steps: Vec<([f64; 5], f64)>,
    /// By step: of what the line between the robots sweeps, pieces and tiers.
    swept: Vec<Vec<(u32, Tier, f64)>>,
}

impl<'a> Lagrangian<'a> {
    /// With the multipliers of a state; without any it is the objective.
    pub fn new(case: &'a Case, state: &State, multipliers: bool) -> Self {
        let set = &state.set;
        let mut at_stages: Vec<Vec<(Subject, f64)>> = Vec::new();
        at_stages.resize_with(state.x.stages.len(), Vec::new);
        let mut at_steps = vec![([0.0; 5], 0.0); state.lambda.len()];
        let mut swept = vec![Vec::new(); state.x.stages.len() - 1];
        if multipliers {
            for r in &set.pairs.items {
                at_stages[r.at.stage()].push((Subject::Pair(r.rule), r.row.z));
            }
            for r in &set.points.items {
                let subject = Subject::Point(r.at.robot(), r.rule);
                at_stages[r.at.stage()].push((subject, r.row.z));
            }
            for r in &set.lines.items {
                let LineRules::LineOffObstacle(rule) = r.rule;
                swept[r.at.stage()].push((rule.piece, rule.tier, r.row.z));
            }
            for (k, (bounds, slip)) in at_steps.iter_mut().enumerate() {
                *bounds = std::array::from_fn(|b| set.steps.items[5 * k + b].row.z);
                *slip = state.lambda[k];
            }
        }
        Self {
            case,
            at_stages,
            at_steps,
            swept,
        }
    }

    /// The constraint of a subject at a waypoint, `c >= 0`.
    fn constraint(&self, subject: &Subject, x: &Iterate, i: usize) -> f64 {
        let (problem, scene) = (&self.case.problem, &self.case.made.scene);
        let reserve = &problem.reserve;
        let z = &x.stages[i];
        let (l, r) = (Pose::new(z[0], z[1], z[2]), Pose::new(z[3], z[4], z[5]));
        let apart = l.position().distance(r.position());
        let abreast = |heading: f64| {
            let normal = (l.position() - r.position()).angle() - std::f64::consts::FRAC_PI_2;
            (heading - normal).cos() - (scene.planner.max_skew - reserve.skew).cos()
        };
        match *subject {
            Subject::Pair(PairRules::FarEnoughApart(_)) => {
                let share = problem.net_length.map_or(0.0, |length| 0.1 * length);
                apart - share.max(2.0 * scene.robot.radius) - reserve.separation
            }
            Subject::Pair(PairRules::CloseEnough(_)) => x.net_length - 1e-6 - apart,
            Subject::Pair(PairRules::HitchesWithinReach(_)) => {
                let (a, b) = (
                    l.hitch_point(scene.robot.hitch),
                    r.hitch_point(scene.robot.hitch),
                );
                x.net_length - reserve.net_reach - a.distance(b)
            }
            Subject::Pair(PairRules::KeepAbreast(rule)) => {
                abreast([l, r][rule.0.robot.index()].heading)
            }
            Subject::Pair(PairRules::OwnPair(_)) => unreachable!("no terms of our own"),
            Subject::Pair(PairRules::BodiesApart(_)) => unreachable!("no body"),
            Subject::Point(robot, ref kind) => {
                let p = [l, r][robot.index()].position();
                match *kind {
                    PointRules::OffObject(OffObject { object: id, tier }) => {
                        let object = scene.objects[id as usize];
                        p.distance(object.position)
                            - object.footprint_radius()
                            - scene.robot.radius
                            - self.case.kept(tier, reserve.clearance)
                    }
                    PointRules::OffObstacle(OffObstacle { piece: id, tier }) => {
                        let gap = match &self.case.pieces[id as usize] {
                            Convex::Polygon(v) => Polygon::new(v.clone()).signed_distance(p),
                            Convex::Circle { center, radius } => p.distance(*center) - radius,
                        };
                        gap - scene.robot.radius - self.case.kept(tier, reserve.clearance)
                    }
                    PointRules::BesideObject(rule) => {
                        Point::from(rule.plane.normal).dot(p) - rule.plane.offset
                    }
                    PointRules::InsideArea(rule) => match rule.0 {
                        Border::LowX => p.x - scene.area.min.x - 1e-6,
                        Border::HighX => scene.area.max.x - p.x - 1e-6,
                        Border::LowY => p.y - scene.area.min.y - 1e-6,
                        Border::HighY => scene.area.max.y - p.y - 1e-6,
                    },
                    PointRules::OwnPoint(_) => unreachable!("no terms of our own"),
                }
            }
        }
    }

    /// The constraint of a piece of an obstacle in a step, `c >= 0`.
    fn clear_of(&self, x: &Iterate, i: usize, id: u32, tier: Tier) -> f64 {
        let keep = self
            .case
            .kept(tier, self.case.problem.reserve.net_clearance);
        let convex = &self.case.pieces[id as usize];
        let corner = |k: usize, robot: Side| x.position(i + k, robot);
        let hull = Hull::of(&[
            corner(0, Side::Left),
            corner(0, Side::Right),
            corner(1, Side::Left),
            corner(1, Side::Right),
        ]);
        let gap = match convex {
            Convex::Polygon(v) => hull.gap_to_polygon(&Polygon::new(v.clone())).distance,
            Convex::Circle { center, radius } => hull.gap_to_disc(*center, *radius).distance,
        };
        if gap > 0.0 {
            return gap - keep;
        }
        // Depths of overlap have a test of their own.
        let region = &Piece::new(convex);
        QuadDistance { region, keep }.value(&x.quad(i))
    }

    /// J_e as the paper has it, with a plus sign.
    fn expansion(&self, d: f64, d_max: f64) -> f64 {
        let p = &self.case.made.scene.planner;
        let (rest, least) = (p.rest_ratio * d_max, p.min_ratio * d_max);
        p.a4 * if d < rest {
            let angle = 0.5 * std::f64::consts::PI * (rest - d) / (rest - least);
            p.kd1 * angle.tan().powi(2)
        } else {
            p.kd2 * (d - rest).powi(2) + ((d - rest) / (d - d_max)).powi(2)
        }
    }

    fn at_stage(&self, x: &Iterate, i: usize) -> f64 {
        let apart = x
            .position(i, Side::Left)
            .distance(x.position(i, Side::Right));
        self.at_stages[i]
            .iter()
            .fold(self.expansion(apart, x.net_length), |sum, (subject, z)| {
                sum - z * self.constraint(subject, x, i)
            })
    }

    fn at_step(&self, x: &Iterate, i: usize) -> f64 {
        let p = &self.case.made.scene.planner;
        let mut sum = self.swept[i].iter().fold(0.0, |sum, &(id, tier, z)| {
            sum - z * self.clear_of(x, i, id, tier)
        });
        for robot in 0..2 {
            let (a, b) = (
                &x.stages[i][3 * robot..3 * robot + 3],
                &x.stages[i + 1][3 * robot..3 * robot + 3],
            );
            let (dx, dy, turn) = (b[0] - a[0], b[1] - a[1], b[2] - a[2]);
            let middle = a[2] + 0.5 * turn;
            let along = dx * middle.cos() + dy * middle.sin();
            let across = dy * middle.cos() - dx * middle.sin();
            let bounds = [
                along,
                p.max_step - 1e-7 - along,
                p.max_turn - 1e-7 - turn,
                p.max_turn - 1e-7 + turn,
                -turn,
            ];
            let (z, lambda) = &self.at_steps[2 * i + robot];
            sum += p.a2 * (p.t1 * along - p.t2 * turn) + lambda * across;
            sum -= (0..5).map(|k| z[k] * bounds[k]).sum::<f64>();
        }
        sum
    }

    fn at_bend(&self, x: &Iterate, i: usize) -> f64 {
        if i == 0 || i + 1 >= x.stages.len() {
            return 0.0;
        }
        let p = &self.case.made.scene.planner;
        (0..STAGE)
            .map(|v| {
                let second = x.stages[i - 1][v] - 2.0 * x.stages[i][v] + x.stages[i + 1][v];
                p.a1 * [p.b1, p.b2, p.b3][v % 3] * second * second
            })
            .sum()
    }

    /// Everything that a variable of one waypoint enters.
    fn around(&self, x: &Iterate, i: usize) -> f64 {
        self.at_stage(x, i)
            + self.at_step(x, i - 1)
            + self.at_step(x, i)
            + (i - 1..=i + 1).map(|k| self.at_bend(x, k)).sum::<f64>()
    }

    /// Gradient by differences: of the inner waypoints, and of the net length.
    pub fn gradient(&self, x: &Iterate) -> (Vec<f64>, f64) {
        let mut x = x.clone();
        let mut gradient = Vec::new();
        for i in 1..x.stages.len() - 1 {
            for v in 0..STAGE {
                let at = x.stages[i][v];
                gradient.push(difference(|h| {
                    x.stages[i][v] = at + h;
                    self.around(&x, i)
                }));
                x.stages[i][v] = at;
            }
        }
        let length = x.net_length;
        let length = difference(|h| {
            x.net_length = length + h;
            (0..x.stages.len()).map(|i| self.at_stage(&x, i)).sum()
        });
        (gradient, length)
    }

    /// The constraints of a state's rows at its point, with slack, violation, multiplier and price.
    pub fn rows(case: &'a Case, state: &State) -> Vec<[f64; 5]> {
        let of = Self::new(case, state, false);
        let x = &state.x;
        let set = &state.set;
        let mut rows = Vec::new();
        let mut add = |c: f64, row: &Row| rows.push([c, row.s, row.e, row.z, row.weight]);
        for r in &set.steps.items {
            let step = Step::of(x, r.at.stage(), r.at.robot());
            let z = [step.coordinate(r.at.coordinate())];
            add(r.rule.value(&case.problem, r.at, &z), &r.row);
        }
        for r in &set.pairs.items {
            let c = of.constraint(&Subject::Pair(r.rule), x, r.at.stage());
            add(c, &r.row);
        }
        for r in &set.points.items {
            let subject = Subject::Point(r.at.robot(), r.rule);
            add(of.constraint(&subject, x, r.at.stage()), &r.row);
        }
        for r in &set.lines.items {
            let LineRules::LineOffObstacle(rule) = r.rule;
            add(of.clear_of(x, r.at.stage(), rule.piece, rule.tier), &r.row);
        }
        rows
    }
}

/// Central difference of fourth order.
fn difference(mut f: impl FnMut(f64) -> f64) -> f64 {
    const H: f64 = 3e-5;
    (8.0 * (f(H) - f(-H)) - (f(2.0 * H) - f(-2.0 * H))) / (12.0 * H)
}

#[test]
fn assembled_gradients_are_those_of_the_lagrangian() {
    for (make, difficulty, seed, free) in [
        (Case::new as fn(u8, u64, usize, bool) -> Case, 2, 1, true),
        (Case::new, 5, 2, false),
        (Case::new, 9, 3, true),
        (Case::tight, 4, 4, false),
        (Case::tight, 7, 5, true),
    ] {
        let case = make(difficulty, seed, 60, free);
        let mut state = shaken(&case, seed);
        let mut system = System::default();
        let lambda = state.lambda.clone();
        system.assemble(
            &case.problem,
            &state.x,
            &mut state.set,
            &lambda,
            (1e-2, Curvature::Convex),
        );
        for (multipliers, gradient, length) in [
            (true, &system.lagrangian, system.length.lagrangian),
            (false, &system.objective, system.length.objective),
        ] {
            let by_hand = Lagrangian::new(&case, &state, multipliers);
            let (expected, expected_length) = by_hand.gradient(&state.x);
            assert_eq!(gradient.len(), expected.len());
            let scale = expected.iter().fold(1.0_f64, |m, g| m.max(g.abs()));
            for (k, (g, e)) in gradient.iter().zip(&expected).enumerate() {
                assert!(
                    (g - e).abs() < 1e-6 * scale,
                    "variable {} of waypoint {}: {g} for {e}, multipliers {multipliers}",
                    k % STAGE,
                    k / STAGE + 1
                );
            }
            let error = (length - expected_length).abs();
            assert!(
                error < 1e-6 * (1.0 + expected_length.abs()),
                "net length: {length} for {expected_length}"
            );
        }
    }
}
