//! Rows that would end a step early: their multipliers rise, and the system follows without being assembled again.

use super::between;
use super::case::{Case, shaken};
use super::matrix::{bend, sigma, times};
use crate::active::ActiveSet;
use crate::block::Block;
use crate::constraints::PointRules;
use crate::curvature::Curvature;
use crate::iterate::STAGE;
use crate::row::Row;
use crate::rule::Rules;
use crate::state::State;
use crate::step::Step;
use crate::system::System;
use crate::workspace::Workspace;
use pairtrawl_model::Side;
use std::collections::BTreeMap;

const MU: f64 = 1e-3;
const SHIFT: f64 = 0.1;

/// A shaken state with multipliers from far too small to about what they should be, so that many slacks shrink too fast.
fn unprepared(case: &Case, seed: u64) -> State {
    let mut state = shaken(case, seed);
    let mut random = fastrand::Rng::with_seed(seed);
    // Robots that pass beside objects seldom come near this bound by themselves.
    for item in &mut state.set.points.items {
        if let PointRules::BesideObject(rule) = &mut item.rule {
            rule.plane.offset += item.row.c - 2e-3;
            item.row = Row::centered(2e-3, item.row.weight, MU);
        }
    }
    for row in state.set.rows_mut() {
        let share = 10.0_f64.powf(between(&mut random, -3.0, 0.0));
        row.z = share * (MU / row.s).min(0.5 * row.weight);
    }
    for lambda in &mut state.lambda {
        *lambda *= 0.1;
    }
    state.mu = MU;
    state
}

/// The system of a set's rows, assembled afresh.
fn assembled(case: &Case, state: &State, lambda: &[f64]) -> System {
    let mut system = System::default();
    let mut set = state.set.clone();
    system.assemble(
        &case.problem,
        &state.x,
        &mut set,
        lambda,
        (state.mu, Curvature::Convex),
    );
    system
}

/// Greatest change of a row's stiffness, by rules and, where rows are of one robot, by robots.
fn stiffened(before: &ActiveSet, after: &ActiveSet) -> BTreeMap<String, f64> {
    fn add<R: Rules<K>, const K: usize>(
        most: &mut BTreeMap<String, f64>,
        before: &Block<R, K>,
        after: &Block<R, K>,
        names: impl Fn(&R, R::At) -> Vec<String>,
    ) {
        for (a, b) in before.items.iter().zip(&after.items) {
            let (was, is) = (&a.row, &b.row);
            assert!(is.z >= was.z && is.z < is.weight, "{was:?} to {is:?}");
            if is.z > was.z {
                for name in names(&b.rule, b.at) {
                    let entry = most.entry(name).or_default();
                    *entry = entry.max(sigma(is) - sigma(was));
                }
            }
        }
    }
    fn rule(rule: &impl std::fmt::Debug) -> String {
        let name = format!("{rule:?}");
        name.split('(').next().unwrap_or_default().to_owned()
    }
    let mut most = BTreeMap::new();
    add(&mut most, &before.steps, &after.steps, |r, _| vec![rule(r)]);
    add(&mut most, &before.pairs, &after.pairs, |r, _| vec![rule(r)]);
    add(&mut most, &before.points, &after.points, |r, at| {
        vec![rule(r), at.robot().to_string()]
    });
    add(&mut most, &before.lines, &after.lines, |r, _| vec![rule(r)]);
    most
}

/// Adds to a dense matrix what the frames of all steps bend by as a state's multipliers have it, times a factor.
fn add_bends(dense: &mut [Vec<f64>], case: &Case, state: &State, lambda: &[f64], factor: f64) {
    for at in 0..lambda.len() {
        let (taut, lateral) = bend(case, state, lambda, at);
        let (i, robot) = (at / 2, at % 2);
        let step = Step::of(&state.x, i, Side::BOTH[robot]);
        // Variables of both ends with their parts in the mid-step heading and in the way forward.
        let parts = |end: usize| {
            let sign = if end == 0 { -1.0 } else { 1.0 };
            [
                (0, 0.0, sign * step.cos),
                (1, 0.0, sign * step.sin),
                (2, 0.5, 0.0),
            ]
            .map(|(v, psi, forward)| ((i + end) * STAGE + 3 * robot + v, psi, forward))
        };
        for (v, psi_v, forward_v) in parts(0).into_iter().chain(parts(1)) {
            for (w, psi_w, forward_w) in parts(0).into_iter().chain(parts(1)) {
                // The first waypoint has no variables, and neither has the last.
                let inner = |v: usize| v.checked_sub(STAGE).filter(|v| *v < dense.len());
                if let (Some(v), Some(w)) = (inner(v), inner(w)) {
                    dense[v][w] += factor
                        * (taut * psi_v * psi_w
                            - lateral * (psi_v * forward_w + forward_v * psi_w));
                }
            }
        }
    }
}

#[test]
fn the_reinforced_system_is_that_of_the_raised_multipliers() {
    let mut kinds: BTreeMap<String, f64> = BTreeMap::new();
    for (difficulty, seed, free) in [
        (3, 1, true),
        (6, 2, false),
        (9, 3, true),
        (10, 4, false),
        (8, 5, true),
        (7, 6, false),
        (8, 7, true),
        (10, 8, false),
        (9, 9, true),
    ] {
        let case = Case::tight(difficulty, seed, 60, free);
        let mut state = unprepared(&case, seed);
        let before = state.clone();
        let mut work = Workspace::default();
        work.system.assemble(
            &case.problem,
            &state.x,
            &mut state.set,
            &before.lambda,
            (state.mu, Curvature::Convex),
        );
        let plain = work.system.clone();
        work.direction(&case.problem, &mut state, SHIFT)
            .expect("a direction");
        for (kind, change) in stiffened(&before.set, &state.set) {
            let most = kinds.entry(kind).or_default();
            *most = most.max(change);
        }
        let fresh = assembled(&case, &state, &before.lambda);
        let system = &work.system;
        let at = format!("difficulty {difficulty}, seed {seed}");
        // Slips weigh 1e9 in the matrix, which is where digits end.
        let near = |given: f64, expected: f64, what: &dyn Fn() -> String| {
            let tolerance = 1e-5 + 1e-11 * expected.abs().min(1e6);
            assert!(
                (given - expected).abs() <= tolerance,
                "{given} for {expected}: {} {at}",
                what()
            );
        };
        let mut largest = 0.0_f64;
        for (k, (g, f)) in system.gradient.iter().zip(&fresh.gradient).enumerate() {
            near(*g, *f, &|| format!("gradient[{k}]"));
            largest = largest.max((g - plain.gradient[k]).abs());
        }
        assert!(largest > 1.0, "hardly anything was reinforced: {largest}");
        for (k, (g, f)) in system.arrow.iter().zip(&fresh.arrow).enumerate() {
            near(*g, *f, &|| format!("arrow[{k}]"));
        }
        let (own, its) = (&system.length, &fresh.length);
        near(own.diagonal, its.diagonal, &|| "length's diagonal".into());
        near(own.gradient, its.gradient, &|| "length's gradient".into());
        // The frames of steps bend as before: their curvature is not found again.
        let order = system.gradient.len();
        let mut expected: Vec<Vec<f64>> = (0..order)
            .map(|v| (0..order).map(|w| fresh.matrix.entry(v, w)).collect())
            .collect();
        add_bends(&mut expected, &case, &state, &before.lambda, -1.0);
        add_bends(&mut expected, &case, &before, &before.lambda, 1.0);
        for (v, row) in expected.iter().enumerate() {
            for (w, e) in row.iter().enumerate() {
                near(system.matrix.entry(v, w), *e, &|| {
                    format!("matrix[{v}][{w}]")
                });
            }
        }
        // The objective and its gradient have no part in it.
        assert!(system.objective == plain.objective && system.lagrangian == plain.lagrangian);
    }
    // Every kind of row was raised, by far more than rounding.
    let expected = [
        "Forward",
        "StepLength",
        "TurnLimit",
        "TurnCost",
        "FarEnoughApart",
        "CloseEnough",
        "HitchesWithinReach",
        "KeepAbreast",
        "OffObject",
        "OffObstacle",
        "BesideObject",
        "InsideArea",
        "left robot",
        "right robot",
        "LineOffObstacle",
    ];
    for kind in expected {
        assert!(
            kinds.get(kind).is_some_and(|most| *most > 0.1),
            "{kind}: {kinds:?}"
        );
    }
}

#[test]
fn the_direction_is_that_of_the_reinforced_system() {
    for free in [false, true] {
        let case = Case::tight(9, 2, 60, free);
        let mut state = unprepared(&case, 2);
        let lambda = state.lambda.clone();
        let mut work = Workspace::default();
        work.system.assemble(
            &case.problem,
            &state.x,
            &mut state.set,
            &lambda,
            (MU, Curvature::Convex),
        );
        let longest = work
            .direction(&case.problem, &mut state, SHIFT)
            .expect("a direction");
        let (system, newton) = (&work.system, &work.newton);
        let scale = system.gradient.iter().fold(1.0_f64, |m, g| m.max(g.abs()));
        for (k, p) in times(system, &newton.direction.inner).iter().enumerate() {
            let sum = p
                + SHIFT * newton.direction.inner[k]
                + newton.direction.length * system.arrow[k]
                + system.gradient[k];
            assert!(sum.abs() <= 1e-7 * scale, "{sum} of {scale} in row {k}");
        }
        // Rows' steps solve their equations with the raised multipliers, and the shortest of them is what is said.
        let mut shortest = 1.0_f64;
        for row in state.set.rows_mut() {
            let terms = row.s * row.z + (row.z * row.ds).abs() + (row.s * row.dz).abs();
            let slack = row.s * row.z + row.z * row.ds + row.s * row.dz - MU;
            assert!(slack.abs() <= 1e-7 * (terms + MU), "{slack}: {row:?}");
            if row.ds < 0.0 {
                shortest = shortest.min(-0.99 * row.s / row.ds);
            }
        }
        if newton.direction.length < 0.0 {
            shortest = shortest.min(-0.5 * state.x.net_length / newton.direction.length);
        }
        assert!((longest - shortest).abs() <= 1e-12, "{longest} {shortest}");
        assert!(
            state.lambda == newton.lambda,
            "slips take the last direction's"
        );
    }
}

#[test]
fn a_frozen_robot_does_not_move_however_rows_are_reinforced() {
    for frozen in Side::BOTH {
        let mut case = Case::tight(9, 2, 60, false);
        case.problem.frozen = Some(frozen);
        let mut state = unprepared(&case, 2);
        let (before, lambda) = (state.set.clone(), state.lambda.clone());
        let mut work = Workspace::default();
        work.system.assemble(
            &case.problem,
            &state.x,
            &mut state.set,
            &lambda,
            (MU, Curvature::Convex),
        );
        work.direction(&case.problem, &mut state, SHIFT)
            .expect("a direction");
        assert!(!stiffened(&before, &state.set).is_empty());
        for (k, d) in work.newton.direction.inner.iter().enumerate() {
            let of_frozen = (k % STAGE) / 3 == frozen.index();
            assert!(!of_frozen || d.abs() < 1e-12, "{d} of variable {k}");
        }
    }
}
