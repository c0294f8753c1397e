//! The plan that a command drives: read from a file, or made first.

use crate::exit::Failure;
use crate::progress::Progress;
use pairtrawl::files::{LoadedScene, read_plan};
use pairtrawl::model::Plan;
use pairtrawl::{PlanOptions, RehearsalMode};
use std::path::Path;

/// Reads a plan and judges it anew, or plans the scene when there is no file.
pub fn given_plan(loaded: &LoadedScene, file: Option<&Path>) -> Result<Plan, Failure> {
    if let Some(file) = file {
        let file = read_plan(file)?;
        return Ok(pairtrawl::judge(&loaded.scene, &loaded.reference, &file));
    }
    let options = PlanOptions {
        rehearsal: RehearsalMode::Skip,
        ..PlanOptions::default()
    };
    let mut progress = Progress::new();
    let planned = pairtrawl::plan(&loaded.scene, &loaded.reference, &options, &mut progress);
    progress.finish();
    Ok(planned?.plan)
}

/// A warning when the plan that is driven cannot be proven.
pub fn unproven(plan: &Plan) -> Option<String> {
    let failed: Vec<_> = plan
        .certificate
        .claims
        .iter()
        .filter(|claim| !claim.holds)
        .map(|claim| claim.id.name())
        .collect();
    (!failed.is_empty()).then(|| format!("the plan cannot be proven: {} fails", failed.join(", ")))
}
