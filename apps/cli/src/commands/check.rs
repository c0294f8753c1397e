use super::with_scene;
use crate::arguments::CheckArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::objects::{ClaimObject, LeftOutObject};
use crate::output::{Done, Report};
use crate::plan_text::{claim_text, left_summary};
use pairtrawl::files::{Checkable, InfeasibleFile, LoadedScene, PlanFile, read_checkable};
use pairtrawl::{Candidate, claim_summaries};
use schemars::JsonSchema;
use serde::Serialize;

/// The verdict on a plan, or on proofs that there is none.
#[derive(Serialize, JsonSchema)]
pub struct CheckReport {
    /// True when every claim holds, and every proof.
    valid: bool,
    /// Every claim; of proofs only that they are about this scene.
    claims: Vec<ClaimObject>,
    /// Objects that the plan leaves where they are, ascending.
    left_out: Vec<LeftOutObject>,
    /// Every proof.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    proofs: Vec<CheckedProof>,
}

/// The verdict on a proof.
#[derive(Serialize, JsonSchema)]
struct CheckedProof {
    /// The argument.
    kind: &'static str,
    /// The objects that it is about: one, or none.
    objects: Vec<usize>,
    /// True when it holds.
    holds: bool,
    /// Why it does not; empty when it does.
    detail: String,
}

/// `pairtrawl check`: every claim of a plan, proven again or refused; or every proof that there is no plan.
pub fn check(arguments: &CheckArguments) -> Result<Done, Failure> {
    with_scene(
        &arguments.scene,
        &|loaded| match read_checkable(&arguments.plan)? {
            Checkable::Plan(plan) => check_plan(loaded, &plan),
            Checkable::Infeasible(file) => check_proofs(loaded, &file),
        },
    )
}

fn check_plan(loaded: &LoadedScene, plan: &PlanFile) -> Result<Done, Failure> {
    let trajectory = plan.trajectory(&loaded.scene);
    let candidate = Candidate::of_file(plan, &trajectory);
    let certificate = pairtrawl::check(&loaded.scene, &loaded.reference, &candidate);
    let mut claims = claim_summaries(&certificate, &trajectory.times());
    let about = CheckReport {
        valid: certificate.is_valid(),
        claims: claims.iter().map(ClaimObject::from).collect(),
        left_out: LeftOutObject::all(&plan.left_out),
        proofs: Vec::new(),
    };

    let failed = claims.iter().filter(|summary| !summary.claim.holds).count();
    let (exit, mut text) = if about.valid {
        (
            Exit::Done,
            format!("valid: all {} claims hold\n", claims.len()),
        )
    } else {
        let text = format!("INVALID: {failed} of {} claims fail\n", claims.len());
        (Exit::Invalid, text)
    };
    text.push_str(&left_summary(&plan.left_out, loaded.scene.objects.len()));
    // What fails comes first.
    claims.sort_by_key(|summary| summary.claim.holds);
    for claim in &claims {
        text.push_str(&format!("  {}\n", claim_text(claim)));
    }
    Report::new("check", exit, about)
        .scene(&loaded.scene.name)
        .done(exit, text, &loaded.warnings, &[])
}

fn check_proofs(loaded: &LoadedScene, file: &InfeasibleFile) -> Result<Done, Failure> {
    let checked = pairtrawl::check_proofs(&loaded.scene, &loaded.reference, file);
    let proofs = file.proofs.iter().zip(&checked.proofs);
    let proofs: Vec<CheckedProof> = proofs
        .map(|(stated, verdict)| CheckedProof {
            kind: stated.kind.name(),
            objects: stated.kind.object().into_iter().collect(),
            holds: verdict.is_ok(),
            detail: verdict
                .as_ref()
                .map_or_else(ToString::to_string, |()| String::new()),
        })
        .collect();
    let valid = checked.is_valid();
    let failed = proofs.iter().filter(|proof| !proof.holds).count();
    let (exit, mut text) = match (valid, failed) {
        (true, _) => (
            Exit::Done,
            format!("valid: all {} proofs hold\n", proofs.len()),
        ),
        (false, 0) => (
            Exit::Invalid,
            "INVALID: the proofs are about another scene\n".to_owned(),
        ),
        (false, _) => (
            Exit::Invalid,
            format!("INVALID: {failed} of {} proofs do not hold\n", proofs.len()),
        ),
    };
    if !checked.scene.detail.is_empty() {
        text.push_str(&format!("  {}\n", checked.scene.detail));
    }
    let mut ordered: Vec<&CheckedProof> = proofs.iter().collect();
    // What fails comes first.
    ordered.sort_by_key(|proof| proof.holds);
    for proof in ordered {
        let verdict = match proof.holds {
            true => "holds".to_owned(),
            false => format!("FAILS: {}", proof.detail),
        };
        let object = match proof.objects.first() {
            Some(object) => format!("object {object}"),
            None => "everything".to_owned(),
        };
        text.push_str(&format!("  {:<18} {object:<12} {verdict}\n", proof.kind));
    }
    let claims = claim_summaries(&checked.scene_certificate(), &[]);
    let about = CheckReport {
        valid,
        claims: claims.iter().map(ClaimObject::from).collect(),
        left_out: Vec::new(),
        proofs,
    };
    Report::new("check", exit, about)
        .scene(&loaded.scene.name)
        .done(exit, text, &loaded.warnings, &[])
}
