//! The direction found again in a part of the course, all else staying as it is.

use super::case::{Case, shaken};
use crate::curvature::Curvature;
use crate::iterate::STAGE;
use crate::state::State;
use crate::workspace::Workspace;

const SHIFT: f64 = 0.1;

/// Largest entry of `(matrix + shift) direction + gradient + arrow length` over the variables of some inner stages.
fn residual(work: &Workspace, stages: std::ops::Range<usize>) -> f64 {
    let (system, newton) = (&work.system, &work.newton);
    let order = system.gradient.len();
    ((stages.start - 1) * STAGE..(stages.end - 1) * STAGE)
        .map(|r| {
            let near = r.saturating_sub(12)..(r + 13).min(order);
            let product: f64 = near
                .map(|c| system.matrix.entry(r, c) * newton.direction.inner[c])
                .sum();
            let own = SHIFT * newton.direction.inner[r] + system.gradient[r];
            (product + own + system.arrow[r] * newton.direction.length).abs()
        })
        .fold(0.0, f64::max)
}

#[test]
fn a_part_is_solved_with_the_rest_in_its_place() {
    for (seed, free) in [(1, true), (2, false)] {
        let case = Case::tight(7, seed, 80, free);
        let mut state = shaken(&case, seed);
        let mut work = Workspace::default();
        let (problem, mu) = (&case.problem, state.mu);
        let lambda = state.lambda.clone();
        work.system.assemble(
            problem,
            &state.x,
            &mut state.set,
            &lambda,
            (mu, Curvature::Convex),
        );
        assert!(work.newton.solve(&work.system, free, SHIFT));
        let whole = work.newton.clone();
        let scale = work
            .system
            .gradient
            .iter()
            .fold(1.0_f64, |m, g| m.max(g.abs()));
        let count = state.x.stages.len();
        for part in [1..count - 1, 1..30, 25..60, count - 20..count - 1] {
            work.newton = whole.clone();
            // Something else there before: what is found does not come from it.
            let block = (part.start - 1) * STAGE..(part.end - 1) * STAGE;
            work.newton.direction.inner[block.clone()].fill(0.3);
            assert!(work.newton.solve_part(&work.system, part.clone()));
            let found = residual(&work, part.clone());
            assert!(found < 1e-6 * scale, "{found} in {part:?}");
            let outside = |k: &usize| !block.contains(k);
            for k in (0..whole.direction.inner.len()).filter(outside) {
                assert_eq!(work.newton.direction.inner[k], whole.direction.inner[k]);
            }
        }
    }
}

#[test]
fn rows_of_a_part_follow_the_direction_as_all_rows_do() {
    let case = Case::tight(6, 3, 80, true);
    let mut state = shaken(&case, 3);
    let mut work = Workspace::default();
    let lambda = state.lambda.clone();
    work.system.assemble(
        &case.problem,
        &state.x,
        &mut state.set,
        &lambda,
        (state.mu, Curvature::Convex),
    );
    assert!(work.newton.solve(&work.system, true, SHIFT));
    work.newton.recover(&mut state, None);
    // The direction changes in stages 30 to 49 alone, and with it the rows of these and of the step to them.
    for d in &mut work.newton.direction.inner[29 * STAGE..49 * STAGE] {
        *d *= -2.0;
    }
    let mut part = (work.newton.clone(), state.clone());
    part.0.recover_part(&mut part.1, None, 29..50);
    work.newton.recover(&mut state, None);
    assert_eq!(part.0.limits, work.newton.limits);
    assert_eq!(part.0.lambda, work.newton.lambda);
    let steps = |s: &mut State| -> Vec<[f64; 3]> {
        let rows = s.set.rows_mut();
        rows.map(|row| [row.ds, row.de, row.dz]).collect()
    };
    assert_eq!(steps(&mut part.1), steps(&mut state));
}
