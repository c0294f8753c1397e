//! Moving along a direction.

use super::case::{Case, shaken};
use crate::curvature::Curvature;
use crate::row::Row;
use crate::workspace::Workspace;

#[test]
fn slacks_stay_positive_however_short_the_longest_step_is() {
    // Below the shortest step length that the search tries, and far below.
    for share in [1e-5, 1e-7, 1e-10] {
        let case = Case::new(5, 1, 60, false);
        let mut state = shaken(&case, 1);
        let (lambda, mu) = (state.lambda.clone(), state.mu);
        let mut work = Workspace::default();
        work.system.assemble(
            &case.problem,
            &state.x,
            &mut state.set,
            &lambda,
            (mu, Curvature::Convex),
        );
        work.direction(&case.problem, &mut state, 0.1)
            .expect("a direction");
        // A violated hard row, which takes no slack from its constraint, and which a full step would run into at once.
        let hard = |row: &&mut Row| row.weight.is_infinite() && row.c < -1e-3;
        let row = state.set.steps.rows_mut().find(hard).expect("one");
        row.ds = -row.s / share;
        let mut longest = 1.0;
        row.limit_step(&mut longest);
        work.line_search(&case.problem, &mut state, longest);
        for row in state.set.rows_mut() {
            assert!(row.s > 0.0 && row.z > 0.0, "{share}: {row:?}");
        }
        assert!(state.merit.phi(mu).is_finite(), "{share}");
    }
}
