//! Plans polished to a residual.

use pairtrawl::files::{LoadedScene, read_scene};
use pairtrawl::model::{SolverStatus, Warning};
use pairtrawl::{Method, PlanOptions, Planned, RehearsalMode, plan};

fn scene(name: &str) -> LoadedScene {
    let path = format!(
        "{}/../../scenes/{name}/scene.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    read_scene(path.as_ref()).expect("the scene is good")
}

fn planned(loaded: &LoadedScene, options: PlanOptions) -> Planned {
    let options = PlanOptions {
        rehearsal: RehearsalMode::Skip,
        explore: false,
        ..options
    };
    plan(&loaded.scene, &loaded.reference, &options, &mut ()).expect("there is a plan")
}

#[test]
fn a_tolerance_bounds_the_residual_of_a_certified_plan() {
    for name in ["witness-3", "witness-9", "paper-experiment"] {
        let loaded = scene(name);
        let rough = planned(&loaded, PlanOptions::default()).plan;
        let tolerance = Some(1e-6);
        let options = PlanOptions {
            tolerance,
            ..PlanOptions::default()
        };
        let fine = planned(&loaded, options).plan;
        assert_eq!(fine.solver.status, SolverStatus::Converged, "{name}");
        assert!(fine.certificate.is_valid(), "{name}");
        let (before, after) = (rough.solver.kkt_error, fine.solver.kkt_error);
        assert!(
            before > 1e-5 && after <= 1e-6,
            "{name}: {before} to {after}"
        );
        assert!(fine.solver.iterations > rough.solver.iterations, "{name}");
        let (more, less) = (rough.cost.total(), fine.cost.total());
        assert!(
            less <= more * (1.0 + 1e-6) && less > 0.995 * more,
            "{name}: J {more} to {less}"
        );
        let unpolished = |w: &Warning| matches!(w, Warning::NotPolished { .. });
        assert!(!fine.warnings.iter().any(unpolished), "{name}");
    }
}

#[test]
fn a_plan_that_is_not_polished_as_asked_says_so() {
    let options = PlanOptions {
        tolerance: Some(1e-9),
        method: Method::Alternating,
        ..PlanOptions::default()
    };
    let plan = planned(&scene("witness-9"), options).plan;
    let said =
        |w: &Warning| matches!(w, Warning::NotPolished { tolerance, .. } if *tolerance == 1e-9);
    assert!(plan.warnings.iter().any(said), "{:?}", plan.warnings);
}
