//! The condensed matrix against its quadratic form, summed term by term, and the Newton direction against the matrix.

use super::between;
use super::lagrangian::{Case, shaken};
use crate::active::jet_of;
use crate::assembly::{DUAL_REGULARIZATION, System};
use crate::interior_point::State;
use crate::iterate::STAGE;
use crate::newton::Newton;
use crate::row::Row;
use crate::term::{Jet, Term};

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

/// `sigma (gradient . direction)^2`.
fn of_row<const K: usize>(row: &Row<K>, jet: &Jet<K>, local: &[f64; K]) -> f64 {
    let slope: f64 = (0..K).map(|k| jet.gradient[k] * local[k]).sum();
    row.sigma() * slope * slope
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
            let step = x.step(i, robot);
            let (along, across, turn) = step.change(from, to);
            slips += across * across / DUAL_REGULARIZATION;
            let rows = &set.steps[5 * (2 * i + robot)..][..5];
            let sigma_along = rows[0].sigma() + rows[1].sigma();
            let sigma_turn = rows[2].sigma() + rows[3].sigma() + rows[4].sigma();
            sum += sigma_along * along * along + sigma_turn * turn * turn;
            // The string under tension, and the lateral force as far as the bounds on `along` carry it.
            let tension = p.a2 * p.t1 - rows[0].z + rows[1].z;
            let taut = (tension * step.along).max(0.0);
            let most = 0.9 * (sigma_along * taut).sqrt();
            let lateral = state.lambda[2 * i + robot].clamp(-most, most);
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
            &problem.pair_term(r.kind, i, jet_of(&z)),
            &d.pair(i),
        );
    }
    for r in &set.points {
        let (i, k) = (r.stage as usize, 3 * r.robot as usize);
        let z = x.point(i, r.robot.into());
        let local = [d.stages[i][k], d.stages[i][k + 1]];
        sum += of_row(&r.row, &problem.point_term(&r.kind, jet_of(&z)), &local);
    }
    for r in &set.rungs {
        let v = &d.stages[r.stage as usize];
        let jet = problem
            .rung_distance(r.piece, r.tier)
            .jet(&x.rung(r.stage as usize));
        sum += of_row(&r.row, &jet, &[v[0], v[1], v[3], v[4]]);
    }
    (slips, sum)
}

/// The band times a vector of the inner stages.
fn times(system: &System, v: &[f64]) -> Vec<f64> {
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
    for (difficulty, seed) in [(3, 1), (9, 2)] {
        let case = Case::new(difficulty, seed, 60, true);
        let (state, system) = assembled(&case, seed, 1e-2);
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
