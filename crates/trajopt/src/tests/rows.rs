//! One inequality of the interior point, and the sum of logarithms.

use super::between;
use crate::merit::{LogarithmSum, Merit};
use crate::row::Row;
use fastrand::Rng;

fn close(a: f64, b: f64, relative: f64) -> bool {
    (a - b).abs() <= relative * (1e-300 + a.abs().max(b.abs()))
}

#[test]
fn centered_rows_lie_on_the_central_path() {
    for c in [-2.0, -0.1, -1e-6, 0.0, 1e-9, 1e-3, 0.4, 30.0] {
        for weight in [20.0, 3e3, 1e6] {
            for mu in [1.0, 1e-3, 1e-6] {
                let row = Row::centered(c, weight, mu);
                let at = format!("c {c}, weight {weight}, mu {mu}: {row:?}");
                assert!(
                    row.s > 0.0 && row.e > 0.0 && row.z > 0.0 && row.y() > 0.0,
                    "{at}"
                );
                assert!(close(row.s * row.z, mu, 1e-9), "s z: {at}");
                // y is a difference: what it lost in digits is no concern of the row.
                let digits = 1e-9 + 1e-15 * weight / row.y();
                assert!(close(row.e * row.y(), mu, digits), "e y: {at}");
                assert!(row.residual().abs() <= 1e-12 * (1.0 + c.abs()), "{at}");
            }
        }
    }
}

#[test]
fn hard_rows_are_centered_where_they_can_be() {
    let feasible = Row::centered(0.3, f64::INFINITY, 1e-2);
    assert_eq!((feasible.s, feasible.e), (0.3, 0.0));
    assert!(close(feasible.s * feasible.z, 1e-2, 1e-12) && feasible.residual() == 0.0);
    // A violated hard row keeps a positive slack and a residual that shows it.
    let violated = Row::centered(-0.2, f64::INFINITY, 1e-2);
    assert!(violated.s > 0.0 && violated.e == 0.0 && violated.z > 0.0);
    assert!(close(violated.s * violated.z, 1e-2, 1e-12));
    assert!(violated.residual() < -0.2);
}

/// A row off the central path.
fn random_row(random: &mut Rng, weight: f64) -> Row {
    let mut row = Row::centered(between(random, -0.3, 0.3), weight, 1e-2);
    row.s *= between(random, 0.3, 3.0);
    if weight.is_finite() {
        row.e *= between(random, 0.3, 3.0);
        row.z = between(random, 0.05, 0.95) * weight;
    } else {
        row.z *= between(random, 0.3, 3.0);
    }
    row
}

#[test]
fn recovered_steps_solve_the_linearized_equations() {
    let mut random = Rng::with_seed(15);
    for weight in [20.0, 3e3, f64::INFINITY] {
        for _ in 0..200 {
            let mut row = random_row(&mut random, weight);
            let (mu, dc) = (1e-3, between(&mut random, -0.1, 0.1));
            // Far from where the slack says that the constraint is, as after a look at a bend.
            row.c += between(&mut random, -1e-2, 1e-2);
            let residual = row.c - row.s + row.e;
            row.condense(mu);
            row.recover(mu, dc);
            let zero = |value: f64, scale: f64, what: &str| {
                assert!(value.abs() <= 1e-10 * scale, "{what} {value}: {row:?}");
            };
            let (s, z, e) = (row.s, row.z, row.e);
            let slack = s * z + z * row.ds + s * row.dz - mu;
            zero(
                slack,
                s * z + (z * row.ds).abs() + (s * row.dz).abs(),
                "s z = mu",
            );
            if weight.is_finite() {
                let y = row.y();
                let elastic = e * y + y * row.de - e * row.dz - mu;
                zero(
                    elastic,
                    e * y + (y * row.de).abs() + (e * row.dz).abs(),
                    "e y = mu",
                );
            } else {
                assert_eq!(row.de, 0.0);
            }
            let sum = residual + dc - row.ds + row.de;
            zero(sum, 1e-3 + row.ds.abs() + row.de.abs(), "c - s + e = 0");
        }
    }
}

#[test]
fn steps_of_a_dear_violation_keep_the_digits_of_its_slack() {
    // A claim that cannot be met, at the highest price: the slack is ten digits smaller than the violation, and what is lost of
    // it in a difference would end every step at once.
    for weight in [3e3, 1.8e6, 3.6e7] {
        for c in [-0.4, -1e-2] {
            let mut row = Row::centered(c, weight, 1e-3);
            for (mu, dc) in [(1e-4, 0.0), (1e-4, 3e-5), (1e-3, -1e-4)] {
                row.condense(mu);
                row.recover(mu, dc);
                let slack = row.s * row.z + row.z * row.ds + row.s * row.dz;
                assert!(close(slack, mu, 1e-6), "{slack} for {mu}: {row:?}");
                let sum = row.residual() + dc - row.ds + row.de;
                assert!(sum.abs() <= 1e-12, "{sum}: {row:?}");
                let mut longest = 1.0;
                row.limit_step(&mut longest);
                assert!(longest == 1.0, "{longest}: {row:?}");
            }
        }
    }
}

#[test]
fn the_condensed_row_is_the_newton_system_with_its_unknowns_eliminated() {
    // With dc = g dx, the row adds -(z + dz) g to the stationarity: -force g + sigma g g dx.
    let mut random = Rng::with_seed(16);
    for weight in [20.0, f64::INFINITY] {
        let mut row = random_row(&mut random, weight);
        let condensed = row.condense(1e-3);
        let give = if weight.is_finite() {
            row.e / (weight - row.z)
        } else {
            0.0
        };
        let sigma = 1.0 / (row.s / row.z + give);
        assert!(close(condensed.sigma, sigma, 1e-12));
        for dc in [-0.1, 0.0, 0.07] {
            row.recover(1e-3, dc);
            let eliminated = condensed.force - condensed.sigma * dc;
            assert!(close(row.z + row.dz, eliminated, 1e-12));
        }
    }
}

#[test]
fn steps_stay_inside() {
    let mut random = Rng::with_seed(17);
    for weight in [20.0, f64::INFINITY] {
        let (mut limited, mut held_back) = (0, 0);
        for _ in 0..300 {
            let mut row = random_row(&mut random, weight);
            let change = between(&mut random, -2.0, 2.0);
            row.condense(1e-4);
            row.recover(1e-4, change);
            let mut longest = 1.0;
            row.limit_step(&mut longest);
            assert!(longest > 0.0 && longest <= 1.0);
            let share = (row.s + longest * row.ds) / row.s;
            assert!(share >= 0.01 - 1e-9, "{share} of {row:?}");
            if longest < 1.0 {
                limited += 1;
                assert!(share <= 0.01 + 1e-9, "{share} of {row:?}");
            }
            // Nothing loses more than 99 % of what it has; the multiplier goes as far as it may on its own.
            let before = row;
            row.c += longest * change;
            row.advance(longest);
            let mut pairs = vec![(before.s, row.s), (before.z, row.z)];
            if weight.is_finite() {
                pairs.extend([(before.e, row.e), (before.y(), row.y())]);
            }
            for (before, after) in &pairs {
                assert!(*after >= (0.01 - 1e-9) * before, "{before} to {after}");
            }
            let full = before.z + before.dz;
            if !close(row.z, full, 1e-12) {
                held_back += 1;
                let least = |p: &(f64, f64)| close(p.1, 0.01 * p.0, 1e-6);
                assert!(pairs[1..].iter().any(least), "{pairs:?}");
            }
        }
        assert!(limited > 25, "only {limited} steps were limited");
        assert!(held_back > 25, "only {held_back} multipliers held back");
    }
}

#[test]
fn stepped_rows_give_back_slack_that_they_do_not_need() {
    let mut row = Row::centered(0.1, 20.0, 1e-3);
    (row.ds, row.de, row.dz) = (0.02, 0.001, 0.5);
    let (s, e) = row.stepped(0.5, 0.4);
    assert!(close(e, row.e + 0.0005, 1e-12) && close(s, 0.4 + e, 1e-12));
    let (s, _) = row.stepped(0.5, -1.0);
    assert!(close(s, row.s + 0.01, 1e-12), "but never more than that");
    let (z, expected) = (row.z, row.s + 0.01);
    row.c = -1.0;
    row.advance(0.5);
    assert_eq!((row.c, row.s, row.z), (-1.0, expected, z + 0.5));
}

#[test]
fn barrier_slope_is_that_of_the_barrier() {
    let mut random = Rng::with_seed(18);
    for weight in [20.0, f64::INFINITY] {
        let mut row = random_row(&mut random, weight);
        row.condense(1e-3);
        row.recover(1e-3, 0.03);
        let (mu, h) = (1e-2, 1e-6);
        let barrier = |t: f64| {
            let mut merit = Merit::default();
            row.add_to(&mut merit, row.s + t * row.ds, row.e + t * row.de);
            merit.phi(mu)
        };
        let found = (barrier(h) - barrier(-h)) / (2.0 * h);
        assert!(
            close(row.barrier_slope(mu), found, 1e-5),
            "{} {found}",
            row.barrier_slope(mu)
        );
    }
}

#[test]
fn rows_presumed_met_are_positive_and_hardly_violated() {
    for c in [-0.2, -1e-9, 0.0, 1e-7, 1e-3, 0.4, 30.0] {
        for weight in [20.0, 3e3, 1e6, f64::INFINITY] {
            for mu in [1.0, 1e-3, 1e-6] {
                let mut row = Row::centered(c, weight, 1.0);
                row.presume_met(mu);
                let at = format!("c {c}, weight {weight}, mu {mu}: {row:?}");
                assert!(row.s > 0.0 && row.z > 0.0 && row.y() > 0.0, "{at}");
                assert_eq!(row.e > 0.0, weight.is_finite(), "{at}");
                // Met constraints keep their slack and lie on the central path; violated ones show it as a residual.
                if c >= 1e-3 {
                    assert!(row.s == c, "{at}");
                }
                if mu / row.s <= 0.5 * weight {
                    assert!(close(row.s * row.z, mu, 1e-12), "{at}");
                }
                if weight.is_finite() {
                    assert!(close(row.e * (weight - row.z), mu, 1e-9), "{at}");
                    assert!(row.e <= 2.0 * mu / weight * (1.0 + 1e-12), "{at}");
                }
                let residual = row.residual() - row.e;
                assert!(residual <= 0.0 && residual >= c.min(0.0) - 1e-4, "{at}");
            }
        }
    }
}

#[test]
fn reinforced_rows_say_what_they_add() {
    let mut random = Rng::with_seed(29);
    for weight in [20.0, 3e3, f64::INFINITY] {
        let (mut raised, mut at_limit) = (0, 0);
        for _ in 0..600 {
            let (mu, limit) = (1e-4, 0.7);
            let mut row = random_row(&mut random, weight);
            // Multipliers that are small yet, as of bounds that were far away.
            row.z *= 10.0_f64.powf(between(&mut random, -4.0, 0.0));
            let before = row.condense(mu);
            row.recover(mu, between(&mut random, -2.0, 2.0));
            let mut own = 1.0;
            row.limit_step(&mut own);
            let was = row;
            let added = row.reinforce(mu, limit);
            let same = |a: &Row, b: &Row| {
                (a.s, a.e, a.c, a.ds, a.de, a.dz) == (b.s, b.e, b.c, b.ds, b.de, b.dz)
            };
            assert!(same(&row, &was), "only the multiplier changes");
            let Some(added) = added else {
                assert!(own >= limit || was.dz <= 0.0, "{own}: {was:?}");
                assert_eq!(row.z, was.z);
                continue;
            };
            raised += 1;
            assert!(own < limit, "{own}: {was:?}");
            assert!(row.z > was.z && row.z < weight, "{was:?} to {row:?}");
            // As far as one step at least, but for what keeps it below the weight.
            let full = was.z + was.dz;
            let most = was.z + 0.99 * was.y();
            assert!(row.z >= full.min(most) * (1.0 - 1e-12), "{was:?} {row:?}");
            if weight.is_finite() && close(row.z, most, 1e-12) {
                at_limit += 1;
            }
            let now = row.z;
            let after = row.condense(mu);
            assert_eq!(row.z, now);
            let (sigma, force) = (after.sigma - before.sigma, after.force - before.force);
            assert!((added.sigma - sigma).abs() <= 1e-12 * (before.sigma + after.sigma));
            let scale = before.force.abs() + after.force.abs();
            assert!((added.force - force).abs() <= 1e-12 * scale);
            // A bound stiffens, but where its violation gives way.
            let gave = was.weight.is_finite() && row.e / row.y() > 0.5 * was.s / was.z;
            assert!(gave || after.sigma > before.sigma, "{was:?} to {row:?}");
            // What it remembers is the raised state: the next direction solves the equations with the new multiplier.
            let mut again = row;
            again.recover(mu, 0.01);
            let slack = row.s * row.z + row.z * again.ds + row.s * again.dz - mu;
            let terms = row.s * row.z + (row.z * again.ds).abs() + (row.s * again.dz).abs();
            // The slack's step is a small sum of larger numbers.
            let lost = 1e-14 * row.z * (row.c.abs() + row.e);
            assert!(slack.abs() <= 1e-9 * terms + lost, "{slack}: {again:?}");
        }
        assert!(raised > 100, "only {raised} of 600 raised");
        assert!(
            weight.is_infinite() || at_limit > 5,
            "only {at_limit} at the weight"
        );
    }
}

#[test]
fn logarithms_add_up() {
    let mut random = Rng::with_seed(19);
    let mut sum = LogarithmSum::default();
    let mut plain = 0.0;
    assert_eq!(sum.sum(), 0.0);
    for _ in 0..5000 {
        // Products run out of either end of the range of numbers, now and then at once.
        let value = 10.0_f64.powf(between(&mut random, -180.0, 150.0));
        sum.push(value);
        plain += value.ln();
    }
    assert!(close(sum.sum(), plain, 1e-11), "{} {plain}", sum.sum());
    for bad in [0.0, -1.0, f64::NAN] {
        let mut sum = LogarithmSum::default();
        sum.push(bad);
        assert!(!sum.sum().is_finite(), "{bad}");
    }
}
