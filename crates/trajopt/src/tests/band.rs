//! The band matrix against a dense one.

#![allow(
    clippy::needless_range_loop,
    reason = "rows and columns read as in the formulas"
)]

use super::between;
use crate::linear::BandMatrix;
use fastrand::Rng;

const BAND: usize = 12;

/// A random symmetric positive definite matrix of half-bandwidth 12, dense.
fn random_matrix(random: &mut Rng, order: usize) -> Vec<Vec<f64>> {
    // L L^T of a banded L keeps the band.
    let mut l = vec![vec![0.0; order]; order];
    for i in 0..order {
        for j in i.saturating_sub(BAND)..i {
            l[i][j] = between(random, -0.3, 0.3);
        }
        l[i][i] = between(random, 0.5, 2.0);
    }
    let entry = |i: usize, j: usize| (0..order).map(|k| l[i][k] * l[j][k]).sum();
    (0..order)
        .map(|i| (0..order).map(|j| entry(i, j)).collect())
        .collect()
}

fn banded(dense: &[Vec<f64>]) -> BandMatrix {
    let mut matrix = BandMatrix::default();
    matrix.reset(dense.len());
    for i in 0..dense.len() {
        for j in i.saturating_sub(BAND)..=i {
            // In two parts: entries add up.
            matrix.add_lower(i, j, 0.25 * dense[i][j]);
            matrix.add_lower(i, j, 0.75 * dense[i][j]);
        }
    }
    matrix
}

/// Gaussian elimination with pivoting: shares nothing with the band's factorization.
fn dense_solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        let pivot = (k..n)
            .max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))
            .unwrap();
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            for j in k..n {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let rest: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - rest) / a[k][k];
    }
    b
}

#[test]
fn solves_as_a_dense_matrix_does() {
    let mut random = Rng::with_seed(12);
    for order in [1, 2, 6, 12, 13, 14, 25, 60] {
        for shift in [0.0, 3.0] {
            let mut dense = random_matrix(&mut random, order);
            let mut matrix = BandMatrix::default();
            matrix.copy_block(&banded(&dense), 0..order, shift);
            for (i, row) in dense.iter_mut().enumerate() {
                row[i] += shift;
            }
            let b: Vec<f64> = (0..order)
                .map(|_| between(&mut random, -1.0, 1.0))
                .collect();
            let (mut x, mut twice) = (b.clone(), b.iter().map(|b| 2.0 * b).collect::<Vec<_>>());
            assert_eq!(matrix.factorize(1e-8), Ok(()));
            matrix.solve([&mut x, &mut twice]);
            for ((x, twice), y) in x.iter().zip(twice).zip(dense_solve(dense, b)) {
                assert!(
                    (x - y).abs() < 1e-10 * (1.0 + y.abs()),
                    "{x} for {y} of {order}"
                );
                assert_eq!(twice, 2.0 * x, "either right-hand side alike");
            }
        }
    }
}

#[test]
fn names_the_pivot_at_which_it_is_not_positive_definite() {
    let mut random = Rng::with_seed(13);
    for order in [1, 5, 13, 40] {
        for bad in [0, order / 2, order - 1] {
            let mut dense = random_matrix(&mut random, order);
            // Leading blocks before `bad` are untouched; that at `bad` loses its definiteness.
            dense[bad][bad] -= 1e3;
            assert_eq!(banded(&dense).factorize(1e-8), Err(bad), "order {order}");
        }
    }
    let mut matrix = BandMatrix::default();
    matrix.reset(3);
    matrix.add_lower(0, 0, 1.0);
    matrix.add_lower(1, 1, f64::NAN);
    assert_eq!(matrix.factorize(1e-8), Err(1), "not a number is no pivot");
}

#[test]
fn resetting_forgets() {
    let mut random = Rng::with_seed(14);
    let mut matrix = banded(&random_matrix(&mut random, 20));
    matrix.factorize(1e-8).expect("positive definite");
    matrix.reset(15);
    for i in 0..15 {
        matrix.add_lower(i, i, 2.0);
    }
    let mut x = vec![1.0; 15];
    matrix.factorize(1e-8).expect("twice the identity");
    matrix.solve([&mut x]);
    assert_eq!(x, vec![0.5; 15]);
}

#[test]
fn a_block_is_solved_with_all_else_in_its_place() {
    let mut random = Rng::with_seed(15);
    let order = 50;
    let dense = random_matrix(&mut random, order);
    let matrix = banded(&dense);
    let b: Vec<f64> = (0..order)
        .map(|_| between(&mut random, -1.0, 1.0))
        .collect();
    let x = dense_solve(dense, b.clone());
    for block in [0..order, 0..20, 7..31, 20..21, 33..order, 0..5, 45..order] {
        // What is outside stands at the solution, what is inside has no part in it.
        let mut outside = x.clone();
        outside[block.clone()].fill(1e3);
        let mut rhs = b[block.clone()].to_vec();
        matrix.subtract_outside(block.clone(), &outside, &mut rhs);
        let mut part = BandMatrix::default();
        part.copy_block(&matrix, block.clone(), 0.0);
        part.factorize(1e-8).expect("positive definite");
        part.solve([&mut rhs]);
        for (found, x) in rhs.iter().zip(&x[block.clone()]) {
            assert!((found - x).abs() < 1e-9, "{found} for {x} in {block:?}");
        }
    }
}
