//! The plan that a command drives: read from a file, or made first.

use crate::details::Details;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::progress::Progress;
use pairtrawl::files::{LoadedScene, read_plan};
use pairtrawl::model::{Claim, Plan, Warning};
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

/// What is wrong with a plan that cannot be proven; `None`: every claim holds.
pub fn unproven(plan: &Plan) -> Option<Warning> {
    let claims: Vec<_> = failed(plan).map(|claim| claim.id).collect();
    (!claims.is_empty()).then_some(Warning::Unproven { claims })
}

/// Refuses a plan that cannot be proven.
pub fn refuse_unproven(plan: &Plan) -> Result<(), Failure> {
    let Some(warning) = unproven(plan) else {
        return Ok(());
    };
    let worst = failed(plan).min_by(|a, b| a.margin.total_cmp(&b.margin));
    Err(Failure {
        details: Box::new(Details {
            claim: worst.map(|claim| claim.id.name()),
            step: worst.and_then(|claim| claim.step),
            margin: worst.map(|claim| claim.margin),
            ..Details::at(worst.and_then(|claim| claim.place))
        }),
        ..Failure::new(Exit::Invalid, warning.to_string())
            .with_help("`pairtrawl check` shows where; --unproven drives it all the same")
    })
}

fn failed(plan: &Plan) -> impl Iterator<Item = &Claim> {
    plan.certificate.claims.iter().filter(|claim| !claim.holds)
}
