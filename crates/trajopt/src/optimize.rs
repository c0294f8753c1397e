use crate::active::{PointKind, SAG, Tier};
use crate::interior_point::{Residuals, Settings, State, Workspace, solve};
use crate::iterate::Iterate;
use crate::problem::Problem;
use pairtrawl_geometry::Point;
use pairtrawl_model::{PairTrajectory, SolverStatus};

/// What the optimizer returns. Whether the trajectories are a valid plan is for the certificate to say.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Both trajectories; `step_time` is that of the start.
    pub trajectory: PairTrajectory,
    /// d_max, m.
    pub net_length: f64,
    /// How it ended.
    pub status: SolverStatus,
    /// Interior-point iterations.
    pub iterations: usize,
    /// Scaled optimality residuals.
    pub residuals: Residuals,
    /// Constraints that could not be met, worst first.
    pub violations: Vec<Violation>,
    /// Wished-for margins that had to give way, one entry for each robot and thing, at the tightest waypoint.
    pub shrunk_margins: Vec<ShrunkMargin>,
}

/// A constraint that the returned trajectories do not meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// The claim that it stands for.
    pub claim: &'static str,
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
    pub claim: &'static str,
    /// Waypoint.
    pub step: usize,
    /// What is left of the margin, m.
    pub left: f64,
    /// Where, m.
    pub place: Point,
}

/// Violations that do not vanish at this cost a meter are not for want of a price.
const GREATEST_ELASTIC_WEIGHT: f64 = 1e6;
const ELASTIC_WEIGHT_INCREASE: f64 = 20.0;
/// Violations of which this share is left at the next price are there to stay.
const STUBBORN_SHARE: f64 = 0.8;

/// Optimizes from a start, until solved or out of iterations.
pub fn optimize(problem: &Problem, start: &PairTrajectory, settings: &Settings) -> Solution {
    optimize_watched(problem, start, settings, &mut |_, _| true)
}

/// As [`optimize`]; `go_on(iterations, residuals)` is asked before every iteration and may stop it (status `TimeLimit`).
pub fn optimize_watched(
    problem: &Problem,
    start: &PairTrajectory,
    settings: &Settings,
    go_on: &mut dyn FnMut(usize, &Residuals) -> bool,
) -> Solution {
    let net_length = problem
        .net_length
        .unwrap_or_else(|| first_net_length(problem, start));
    optimize_from(problem, start, net_length, settings, go_on)
}

/// As [`optimize_watched`], from a given net length when that is free.
pub fn optimize_from(
    problem: &Problem,
    start: &PairTrajectory,
    net_length: f64,
    settings: &Settings,
    go_on: &mut dyn FnMut(usize, &Residuals) -> bool,
) -> Solution {
    let mut x = Iterate::from_trajectory(start, net_length);
    fix_ends(problem, &mut x);
    let mut settings = *settings;
    let mut state = State::new(problem, x, &settings);
    let mut work = Workspace::default();
    let mut go_on = |s: &State| go_on(s.iterations, &s.residuals);
    let mut status = solve(problem, &mut state, &settings, &mut work, &mut go_on);
    let (mut violations, mut shrunk_margins) = shortfalls(problem, &state);
    // Violations may only have been too cheap; those that a far higher price does not lessen are not.
    while status == SolverStatus::Converged
        && !violations.is_empty()
        && settings.elastic_weight < GREATEST_ELASTIC_WEIGHT
    {
        let before = total(&violations);
        settings.elastic_weight *= ELASTIC_WEIGHT_INCREASE;
        let iterations = state.iterations;
        state = State::new(problem, state.x, &settings);
        state.iterations = iterations;
        status = solve(problem, &mut state, &settings, &mut work, &mut go_on);
        (violations, shrunk_margins) = shortfalls(problem, &state);
        if total(&violations) > STUBBORN_SHARE * before {
            break;
        }
    }
    if status == SolverStatus::Converged && !violations.is_empty() {
        status = SolverStatus::LocallyInfeasible;
    }
    Solution {
        trajectory: state.x.to_trajectory(start.step_time),
        net_length: state.x.net_length,
        status,
        iterations: state.iterations,
        residuals: state.residuals,
        violations,
        shrunk_margins,
    }
}

/// Sum of all violations, m and rad.
fn total(violations: &[Violation]) -> f64 {
    violations.iter().map(|v| v.amount).sum()
}

/// A net in which the start's mean separation is at rest, and which holds the widest pair.
pub(crate) fn first_net_length(problem: &Problem, start: &PairTrajectory) -> f64 {
    let separations = (0..start.len()).map(|i| start.pair(i).separation());
    let (mut sum, mut widest) = (0.0, 0.0_f64);
    for d in separations {
        sum += d;
        widest = widest.max(d);
    }
    (sum / start.len() as f64 / problem.planner.rest_ratio).max(1.2 * widest)
}

/// The ends are the scene's; headings keep the turn count of the start.
fn fix_ends(problem: &Problem, x: &mut Iterate) {
    let last = x.stages.len() - 1;
    for (i, pair) in [(0, &problem.start), (last, &problem.end)] {
        for (k, pose) in [(0, pair.left), (3, pair.right)] {
            let turns = ((x.stages[i][k + 2] - pose.heading) / std::f64::consts::TAU).round();
            x.stages[i][k] = pose.x;
            x.stages[i][k + 1] = pose.y;
            x.stages[i][k + 2] = pose.heading + turns * std::f64::consts::TAU;
        }
    }
}

/// Claims that rows stand for fail when a row gives way by more than its margin.
fn shortfalls(problem: &Problem, state: &State) -> (Vec<Violation>, Vec<ShrunkMargin>) {
    const NOISE: f64 = 1e-5;
    let mut violations = Vec::new();
    let mut margins: Vec<ShrunkMargin> = Vec::new();
    let mut judge = |claim: &'static str,
                     step: usize,
                     subject: Option<usize>,
                     place: Point,
                     c: f64,
                     margin: f64| {
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
            .position(stage, 0)
            .lerp(state.x.position(stage, 1), 0.5);
        let (claim, margin) = match pair.kind {
            0 => ("separation", reserve.separation),
            1 => ("separation", 0.0),
            2 => ("net_reach", reserve.net_reach),
            _ => ("abreast", reserve.skew),
        };
        judge(claim, stage, None, place, pair.row.c, margin);
    }
    for point in &state.set.points {
        let stage = point.stage as usize;
        let (claim, subject, margin) = match point.kind {
            PointKind::Object(id, tier) => (
                "robots_miss_objects",
                Some(id as usize),
                slack(tier, reserve.clearance),
            ),
            PointKind::Piece(id, tier) => (
                "robot_clearance",
                Some(id as usize),
                slack(tier, reserve.clearance),
            ),
            // A side is a help; the claim is what matters.
            PointKind::Side(..) => continue,
            PointKind::Area(_) => ("inside_area", None, 0.0),
        };
        judge(
            claim,
            stage,
            subject,
            state.x.position(stage, point.robot.into()),
            point.row.c,
            margin,
        );
    }
    for rung in &state.set.rungs {
        let stage = rung.stage as usize;
        let place = state
            .x
            .position(stage, 0)
            .lerp(state.x.position(stage, 1), 0.5);
        let margin = slack(rung.tier, reserve.net_clearance);
        judge(
            "net_encloses_no_obstacle",
            stage,
            Some(rung.piece as usize),
            place,
            rung.row.c,
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
