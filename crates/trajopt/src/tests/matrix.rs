//! The condensed matrix against its quadratic form, summed term by term, and the Newton direction against the matrix.

use super::between;
use super::case::{Case, shaken};
use crate::anchor::{Anchor, LineAt};
use crate::assembly::DUAL_REGULARIZATION;
use crate::block::Block;
use crate::costs::expansion::Expansion;
use crate::curvature::Curvature;
use crate::iterate::{Direction, STAGE};
use crate::local::Local;
use crate::newton::Newton;
use crate::row::{Condensed, Row};
use crate::rule::Rules;
use crate::state::State;
use crate::step::Step;
use crate::system::System;
use crate::term::{QUAD, Term};
use pairtrawl_model::Side;

fn random_direction(random: &mut fastrand::Rng, count: usize) -> Direction {
    Direction {
        inner: (0..(count - 2) * STAGE)
            .map(|_| between(random, -1.0, 1.0))
            .collect(),
        length: between(random, -1.0, 1.0),
    }
}

/// Change of the pair's local coordinates at a waypoint.
fn pair_of(d: &Direction, i: usize) -> [f64; 5] {
    let stage = d.stage(i);
    [
        stage[0] - stage[3],
        stage[1] - stage[4],
        stage[2],
        stage[5],
        d.length,
    ]
}

fn assembled(case: &Case, seed: u64, mu: f64) -> (State, System) {
    let mut state = shaken(case, seed);
    let mut system = System::default();
    let lambda = state.lambda.clone();
    system.assemble(
        &case.problem,
        &state.x,
        &mut state.set,
        &lambda,
        (mu, Curvature::Convex),
    );
    (state, system)
}

/// Stiffness of a row, slack, violation and multiplier eliminated.
pub fn sigma(row: &Row) -> f64 {
    let give = if row.weight.is_finite() {
        row.e / (row.weight - row.z)
    } else {
        0.0
    };
    1.0 / (row.s / row.z + give)
}

/// The five rows of a robot-step.
fn bounds_of_step(state: &State, at: usize) -> Vec<&Row> {
    let items = &state.set.steps.items[5 * at..][..5];
    items.iter().map(|item| &item.row).collect()
}

/// Sum of `sigma (gradient . direction)^2` over rows, with the local coordinates of a direction at a waypoint.
fn of_rows<R: Rules<K>, const K: usize>(
    block: &Block<R, K>,
    case: &Case,
    state: &State,
    local: impl Fn(R::At) -> [f64; K],
) -> f64 {
    let of_row = |item: &crate::block::Item<R, K>| {
        let z = item.at.coordinates(&state.x, &state.set.frames);
        let (_, gradient) = item.rule.slope(&case.problem, item.at, &z);
        let local = local(item.at);
        let slope: f64 = (0..K).map(|k| gradient[k] * local[k]).sum();
        sigma(&item.row) * slope * slope
    };
    block.items.iter().map(of_row).sum()
}

/// Curvature of the frame of a step, from the step's rows: of the string under tension, and of the lateral force as far as
/// the bounds on `along` carry it.
pub fn bend(case: &Case, state: &State, lambda: &[f64], at: usize) -> (f64, f64) {
    let p = &case.made.scene.planner;
    let rows = bounds_of_step(state, at);
    let step = Step::of(&state.x, at / 2, Side::BOTH[at % 2]);
    let tension = p.a2 * p.t1 - rows[0].z + rows[1].z;
    let taut = (tension * step.along).max(0.0);
    let most = 0.9 * ((sigma(rows[0]) + sigma(rows[1])) * taut).sqrt();
    (taut, lambda[at].clamp(-most, most))
}

/// The quadratic form of the condensed matrix: of the equalities, and of everything else.
fn by_hand(case: &Case, state: &State, d: &Direction) -> (f64, f64) {
    let (problem, x, set) = (&case.problem, &state.x, &state.set);
    let p = &case.made.scene.planner;
    let (mut slips, mut sum) = (0.0, 0.0);
    let stages: Vec<_> = (0..x.stages.len()).map(|i| d.stage(i)).collect();
    for w in stages.windows(3) {
        for v in 0..STAGE {
            let second = w[0][v] - 2.0 * w[1][v] + w[2][v];
            sum += 2.0 * p.a1 * [p.b1, p.b2, p.b3][v % 3] * second * second;
        }
    }
    for i in 0..x.stages.len() {
        let (jet, local) = (Expansion::of(problem).convex_jet(&x.pair(i)), pair_of(d, i));
        for a in 0..5 {
            for b in 0..5 {
                sum += local[a] * jet.hessian[a][b] * local[b];
            }
        }
    }
    for i in 0..x.stages.len() - 1 {
        for robot in 0..2 {
            let k = 3 * robot;
            let (from, to) = (&stages[i][k..k + 3], &stages[i + 1][k..k + 3]);
            let step = Step::of(x, i, Side::BOTH[robot]);
            let (along, across, turn) = step.change(from, to);
            slips += across * across / DUAL_REGULARIZATION;
            let rows = bounds_of_step(state, 2 * i + robot);
            let sigma_along = sigma(rows[0]) + sigma(rows[1]);
            let sigma_turn: f64 = rows[2..].iter().map(|row| sigma(row)).sum();
            sum += sigma_along * along * along + sigma_turn * turn * turn;
            let (taut, lateral) = bend(case, state, &state.lambda, 2 * i + robot);
            let psi = 0.5 * (from[2] + to[2]);
            let forward = (to[0] - from[0]) * step.cos + (to[1] - from[1]) * step.sin;
            sum += taut * psi * psi - 2.0 * lateral * forward * psi;
        }
    }
    sum += of_rows(&set.pairs, case, state, |at| pair_of(d, at.stage()));
    sum += of_rows(&set.points, case, state, |at| {
        let (stage, k) = (d.stage(at.stage()), 3 * at.robot().index());
        [stage[k], stage[k + 1]]
    });
    sum += of_rows(&set.lines, case, state, |at| {
        let (a, b) = (d.stage(at.stage()), d.stage(at.stage() + 1));
        [a[0], a[1], a[3], a[4], b[0], b[1], b[3], b[4]]
    });
    (slips, sum)
}

/// The band times a vector of the inner stages.
pub fn times(system: &System, v: &[f64]) -> Vec<f64> {
    (0..v.len())
        .map(|i| (0..v.len()).map(|j| system.matrix.entry(i, j) * v[j]).sum())
        .collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[test]
fn the_condensed_matrix_is_the_sum_of_its_terms() {
    let mut random = fastrand::Rng::with_seed(24);
    for (case, seed) in [
        (Case::new(3, 1, 60, true), 1),
        (Case::new(9, 2, 60, true), 2),
        (Case::tight(6, 3, 60, true), 3),
    ] {
        let (state, system) = assembled(&case, seed, 1e-2);
        assert!(seed < 3 || state.set.lines.items.len() > 100);
        for _ in 0..10 {
            let d = random_direction(&mut random, state.x.stages.len());
            let flat = &d.inner;
            let band = dot(flat, &times(&system, flat));
            let arrow = 2.0 * d.length * dot(flat, &system.arrow);
            let form = band + arrow + d.length * d.length * system.length.diagonal;
            let (slips, rest) = by_hand(&case, &state, &d);
            let error = (form - slips - rest).abs();
            assert!(
                error <= 1e-13 * slips + 1e-9 * rest.abs(),
                "{form} for {slips} and {rest}"
            );
        }
    }
}

#[test]
fn a_swept_hull_couples_both_waypoints() {
    let mut random = fastrand::Rng::with_seed(30);
    let count = 6;
    let order = (count - 2) * STAGE;
    for step in 0..count - 1 {
        let g: [f64; QUAD] = std::array::from_fn(|_| between(&mut random, -1.0, 1.0));
        let (sigma, force) = (2.5, -0.7);
        let mut system = System {
            gradient: vec![0.0; order],
            lagrangian: vec![0.0; order],
            objective: vec![0.0; order],
            ..System::default()
        };
        system.matrix.reset(order);
        let local = Local::of_row(&g, Condensed { sigma, force });
        LineAt(step as u32).scatter(&local, &[], &mut system);
        // Left and right robot at one waypoint, then at the next; the first and the last waypoint have no variables.
        let mut whole = vec![0.0; count * STAGE];
        for (k, v) in [0, 1, 3, 4, 6, 7, 9, 10].into_iter().enumerate() {
            whole[step * STAGE + v] = g[k];
        }
        let inner = &whole[STAGE..count * STAGE - STAGE];
        for i in 0..order {
            assert_eq!(system.gradient[i], -force * inner[i]);
            for j in 0..order {
                let (given, expected) = (system.matrix.entry(i, j), sigma * inner[i] * inner[j]);
                assert!((given - expected).abs() < 1e-14, "step {step}: {i}, {j}");
            }
        }
    }
}

#[test]
fn the_newton_direction_solves_the_condensed_system() {
    for free in [false, true] {
        let case = Case::new(6, 3, 60, free);
        let (_, system) = assembled(&case, 3, 1e-2);
        let mut newton = Newton::default();
        let shift = 0.1;
        assert!(newton.solve(&system, free, shift));
        let product = times(&system, &newton.direction.inner);
        let scale = system.gradient.iter().fold(1.0_f64, |m, g| m.max(g.abs()));
        for (k, p) in product.iter().enumerate() {
            let sum = p
                + shift * newton.direction.inner[k]
                + newton.direction.length * system.arrow[k]
                + system.gradient[k];
            assert!(sum.abs() <= 1e-7 * scale, "{sum} of {scale} in row {k}");
        }
        if free {
            let sum = dot(&system.arrow, &newton.direction.inner)
                + (system.length.diagonal + shift) * newton.direction.length
                + system.length.gradient;
            assert!(sum.abs() <= 1e-7 * scale, "{sum} of {scale}");
            assert!(newton.direction.length != 0.0);
        } else {
            assert_eq!(newton.direction.length, 0.0);
        }
    }
}
