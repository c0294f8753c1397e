//! Residuals of solved problems, recomputed outside the solver from the point and its multipliers.

use super::case::Case;
use super::lagrangian::Lagrangian;
use crate::interior_point::solve;
use crate::settings::Settings;
use crate::state::State;
use crate::step::Step;
use crate::workspace::Workspace;
use pairtrawl_model::Side;
use pairtrawl_model::SolverStatus;

fn run(case: &Case, settings: &Settings) -> (State, SolverStatus) {
    let mut state = State::new(&case.problem, case.start(), settings);
    let mut work = Workspace::default();
    let mut go_on = |_: &State| true;
    let status = solve(&case.problem, &mut state, settings, &mut work, &mut go_on);
    (state, status)
}

/// Largest entry of the Lagrangian's gradient, as a share of the largest of the objective's.
fn stationarity(case: &Case, state: &State) -> f64 {
    let largest = |g: &[f64]| g.iter().fold(0.0_f64, |m, g| m.max(g.abs()));
    let (gradient, length) = Lagrangian::new(case, state, true).gradient(&state.x);
    let (objective, _) = Lagrangian::new(case, state, false).gradient(&state.x);
    let mut error = largest(&gradient);
    if case.problem.net_length.is_none() {
        error = error.max(length.abs());
    }
    error / largest(&objective).max(1.0)
}

fn close(a: f64, b: f64, absolute: f64) -> bool {
    (a - b).abs() <= absolute + 1e-5 * a.abs().max(b.abs())
}

#[test]
fn residuals_are_what_the_solver_says() {
    for (difficulty, seed, free) in [
        (1, 1, false),
        (4, 2, true),
        (7, 3, false),
        (7, 4, true),
        (10, 5, true),
    ] {
        let case = Case::new(difficulty, seed, 120, free);
        let settings = Settings::default();
        let (state, status) = run(&case, &settings);
        let said = state.residuals;
        assert_eq!(status, SolverStatus::Converged, "{said:?}");
        let at = format!("difficulty {difficulty}, seed {seed}: {said:?}");

        let found = stationarity(&case, &state);
        assert!(close(found, said.dual, 1e-6), "stationarity {found}, {at}");

        let (mut primal, mut gap) = (0.0_f64, 0.0);
        for [c, s, e, z, weight] in Lagrangian::rows(&case, &state) {
            assert!(s > 0.0 && z > 0.0 && e >= 0.0 && z < weight, "{at}");
            primal = primal.max((c - s + e).abs());
            gap += s * z
                + if weight.is_finite() {
                    e * (weight - z)
                } else {
                    0.0
                };
        }
        for i in 0..state.x.stages.len() - 1 {
            for robot in Side::BOTH {
                primal = primal.max(Step::of(&state.x, i, robot).across.abs());
            }
        }
        assert!(
            close(primal, said.primal, 1e-9),
            "feasibility {primal}, {at}"
        );
        assert!(close(gap, said.gap, 1e-9), "gap {gap}, {at}");
        assert!(primal <= settings.feasibility_tolerance, "{at}");
        let bound = settings.relative_gap * state.merit.cost;
        assert!(gap <= bound, "{gap} above {bound}, {at}");
    }
}

/// The greatest of dual residual, violation, and gap as a share of the cost, from the formulas alone.
fn relative_residual(case: &Case, state: &State) -> f64 {
    let mut gap = 0.0;
    let mut greatest = stationarity(case, state);
    for [c, s, e, z, weight] in Lagrangian::rows(case, state) {
        assert!(s > 0.0 && z > 0.0 && e >= 0.0 && z < weight);
        greatest = greatest.max((c - s + e).abs());
        gap += s * z;
        if weight.is_finite() {
            gap += e * (weight - z);
        }
    }
    greatest.max(gap / state.merit.cost)
}

#[test]
fn polishing_leaves_the_residual_that_was_asked_for() {
    for (difficulty, seed, free) in [(1, 1, true), (4, 2, false), (7, 4, true), (9, 3, true)] {
        let case = Case::new(difficulty, seed, 100, free);
        let (solved, _) = run(&case, &Settings::default());
        let settings = Settings {
            tolerance: 1e-6,
            ..Settings::default()
        };
        let (polished, status) = run(&case, &settings);
        let at = format!("difficulty {difficulty}, seed {seed}");
        assert_eq!(status, SolverStatus::Converged, "{at}");
        let (before, after) = (
            relative_residual(&case, &solved),
            relative_residual(&case, &polished),
        );
        // A little more for rounding in the differences that the gradient is found by.
        assert!(before > 5e-5 && after < 4e-6, "{before} to {after}, {at}");
        assert!(polished.relative_residual() <= 1e-6, "{at}");
        let (more, less) = (solved.merit.cost, polished.merit.cost);
        assert!(less < more * (1.0 + 1e-6), "J {more} to {less}, {at}");
        let most = solved.iterations + 150;
        assert!(polished.iterations <= most, "{at}");
    }
}

#[test]
fn a_residual_out_of_reach_leaves_the_solved_problem() {
    let case = Case::new(4, 2, 60, false);
    let settings = Settings {
        tolerance: 1e-18,
        ..Settings::default()
    };
    let ((solved, _), (polished, status)) =
        (run(&case, &Settings::default()), run(&case, &settings));
    assert_eq!(status, SolverStatus::Converged);
    assert_eq!(polished.x.stages, solved.x.stages);
    assert_eq!(polished.relative_residual(), solved.relative_residual());
}

#[test]
fn tight_tolerances_lead_to_a_stationary_point() {
    let settings = Settings {
        relative_gap: 1e-7,
        max_iterations: 150,
        relative_decrease: 1e-11,
        ..Settings::default()
    };
    for (difficulty, seed, free) in [(1, 1, true), (4, 2, false), (7, 4, true)] {
        let case = Case::new(difficulty, seed, 100, free);
        // Whether or not rounding lets it promise as little as that.
        let (state, _) = run(&case, &settings);
        let found = stationarity(&case, &state);
        assert!(found < 5e-4, "difficulty {difficulty}: {found}");
    }
}
