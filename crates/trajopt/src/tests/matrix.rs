//! The condensed matrix against its quadratic form, summed term by term, and the Newton direction against the matrix.

use super::between;
use super::case::{Case, shaken};
use crate::active::slope_of;
use crate::assembly::{DUAL_REGULARIZATION, System};
use crate::iterate::STAGE;
use crate::local::Local;
use crate::newton::Newton;
use crate::row::{Condensed, Row};
use crate::state::State;
use crate::step::Step;
use crate::term::{QUAD, Term};
use pairtrawl_model::Side;

/// A direction: of every waypoint, the ends at rest, and of the net length.
struct Direction {
    stages: Vec<[f64; STAGE]>,
    length: f64,
}

impl Direction {
    fn random(random: &mut fastrand::Rng, count: usize) -> Self {
        let mut stages = vec![[0.0; STAGE]; count];
        for stage in &mut stages[1..count - 1] {
            *stage = std::array::from_fn(|_| between(random, -1.0, 1.0));
        }
        Self {
            stages,
            length: between(random, -1.0, 1.0),
        }
    }

    fn pair(&self, i: usize) -> [f64; 5] {
        let d = &self.stages[i];
        [d[0] - d[3], d[1] - d[4], d[2], d[5], self.length]
    }
}

fn assembled(case: &Case, seed: u64, mu: f64) -> (State, System) {
    let mut state = shaken(case, seed);
    let mut system = System::default();
    let lambda = state.lambda.clone();
    system.assemble(&case.problem, &state.x, &mut state.set, &lambda, mu);
    (state, system)
}

/// Stiffness of a row, slack, violation and multiplier eliminated.
pub fn sigma<const K: usize>(row: &Row<K>) -> f64 {
    let give = if row.weight.is_finite() {
        row.e / (row.weight - row.z)
    } else {
        0.0
    };
    1.0 / (row.s / row.z + give)
}

/// `sigma (gradient . direction)^2`.
fn of_row<const K: usize>(row: &Row<K>, (_, gradient): (f64, [f64; K]), local: &[f64; K]) -> f64 {
    let slope: f64 = (0..K).map(|k| gradient[k] * local[k]).sum();
    sigma(row) * slope * slope
}

/// Curvature of the frame of a step, from the step's rows: of the string under tension, and of the lateral force as far as
/// the bounds on `along` carry it.
pub fn bend(case: &Case, state: &State, lambda: &[f64], at: usize) -> (f64, f64) {
    let p = &case.made.scene.planner;
    let rows = &state.set.steps[5 * at..][..5];
    let step = Step::of(&state.x, at / 2, Side::BOTH[at % 2]);
    let tension = p.a2 * p.t1 - rows[0].z + rows[1].z;
    let taut = (tension * step.along).max(0.0);
    let most = 0.9 * ((sigma(&rows[0]) + sigma(&rows[1])) * taut).sqrt();
    (taut, lambda[at].clamp(-most, most))
}

/// The quadratic form of the condensed matrix: of the equalities, and of everything else.
fn by_hand(case: &Case, state: &State, d: &Direction) -> (f64, f64) {
    let (problem, x, set) = (&case.problem, &state.x, &state.set);
    let p = &case.made.scene.planner;
    let (mut slips, mut sum) = (0.0, 0.0);
    for w in d.stages.windows(3) {
        for v in 0..STAGE {
            let second = w[0][v] - 2.0 * w[1][v] + w[2][v];
            sum += 2.0 * p.a1 * [p.b1, p.b2, p.b3][v % 3] * second * second;
        }
    }
    for i in 0..x.stages.len() {
        let (jet, local) = (problem.expansion().convex_jet(&x.pair(i)), d.pair(i));
        for a in 0..5 {
            for b in 0..5 {
                sum += local[a] * jet.hessian[a][b] * local[b];
            }
        }
    }
    for i in 0..x.stages.len() - 1 {
        for robot in 0..2 {
            let k = 3 * robot;
            let (from, to) = (&d.stages[i][k..k + 3], &d.stages[i + 1][k..k + 3]);
            let step = Step::of(x, i, Side::BOTH[robot]);
            let (along, across, turn) = step.change(from, to);
            slips += across * across / DUAL_REGULARIZATION;
            let rows = &set.steps[5 * (2 * i + robot)..][..5];
            let sigma_along = sigma(&rows[0]) + sigma(&rows[1]);
            let sigma_turn: f64 = rows[2..].iter().map(sigma).sum();
            sum += sigma_along * along * along + sigma_turn * turn * turn;
            let (taut, lateral) = bend(case, state, &state.lambda, 2 * i + robot);
            let psi = 0.5 * (from[2] + to[2]);
            let forward = (to[0] - from[0]) * step.cos + (to[1] - from[1]) * step.sin;
            sum += taut * psi * psi - 2.0 * lateral * forward * psi;
        }
    }
    for r in &set.pairs {
        let i = r.stage as usize;
        let z = x.pair(i);
        sum += of_row(
            &r.row,
            problem.pair_term(r.kind, i, slope_of(&z)),
            &d.pair(i),
        );
    }
    for r in &set.points {
        let (i, k) = (r.stage as usize, 3 * r.robot.index());
        let z = x.point(i, r.robot);
        let local = [d.stages[i][k], d.stages[i][k + 1]];
        sum += of_row(&r.row, problem.point_term(&r.kind, slope_of(&z)), &local);
    }
    for r in &set.quads {
        let i = r.step as usize;
        let (a, b) = (&d.stages[i], &d.stages[i + 1]);
        let slope = problem.quad_distance(r.piece, r.tier).slope(&x.quad(i));
        let local = [a[0], a[1], a[3], a[4], b[0], b[1], b[3], b[4]];
        sum += of_row(&r.row, slope, &local);
    }
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
        assert!(seed < 3 || state.set.quads.len() > 100);
        for _ in 0..10 {
            let d = Direction::random(&mut random, state.x.stages.len());
            let flat = d.stages[1..d.stages.len() - 1].concat();
            let band = dot(&flat, &times(&system, &flat));
            let arrow = 2.0 * d.length * dot(&flat, &system.arrow);
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
        system.scatter_quad(step, count, &Local::of_row(&g, Condensed { sigma, force }));
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
        let product = times(&system, &newton.direction);
        let scale = system.gradient.iter().fold(1.0_f64, |m, g| m.max(g.abs()));
        for (k, p) in product.iter().enumerate() {
            let sum = p
                + shift * newton.direction[k]
                + newton.length * system.arrow[k]
                + system.gradient[k];
            assert!(sum.abs() <= 1e-7 * scale, "{sum} of {scale} in row {k}");
        }
        if free {
            let sum = dot(&system.arrow, &newton.direction)
                + (system.length.diagonal + shift) * newton.length
                + system.length.gradient;
            assert!(sum.abs() <= 1e-7 * scale, "{sum} of {scale}");
            assert!(newton.length != 0.0);
        } else {
            assert_eq!(newton.length, 0.0);
        }
    }
}
