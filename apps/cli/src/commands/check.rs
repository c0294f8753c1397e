use super::with_scene;
use crate::arguments::CheckArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::objects::ClaimObject;
use crate::output::{Done, Report};
use crate::plan_text::claim_text;
use pairtrawl::files::{LoadedScene, read_plan};
use pairtrawl::{Candidate, claim_summaries};
use schemars::JsonSchema;
use serde::Serialize;

/// The verdict on a plan.
#[derive(Serialize, JsonSchema)]
pub struct CheckReport {
    /// True when every claim holds.
    valid: bool,
    /// Every claim.
    claims: Vec<ClaimObject>,
}

/// `pairtrawl check`: every claim of a plan, proven again or refused.
pub fn check(arguments: &CheckArguments) -> Result<Done, Failure> {
    with_scene(&arguments.scene, &|loaded| check_in(loaded, arguments))
}

fn check_in(loaded: &LoadedScene, arguments: &CheckArguments) -> Result<Done, Failure> {
    let plan = read_plan(&arguments.plan)?;
    let trajectory = plan.trajectory(&loaded.scene);
    let candidate = Candidate {
        net_length: plan.net_length,
        trajectory: &trajectory,
        scene: plan.scene.as_ref(),
        overrides: &plan.overrides,
        time_law: plan.time_law.as_deref(),
        left_out: &plan.left_out,
    };
    let certificate = pairtrawl::check(&loaded.scene, &loaded.reference, &candidate);
    let mut claims = claim_summaries(&certificate, &trajectory.times());
    let about = CheckReport {
        valid: certificate.is_valid(),
        claims: claims.iter().map(ClaimObject::from).collect(),
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
    // What fails comes first.
    claims.sort_by_key(|summary| summary.claim.holds);
    for claim in &claims {
        text.push_str(&format!("  {}\n", claim_text(claim)));
    }
    Report::new("check", exit, about)
        .scene(&loaded.scene.name)
        .done(exit, text, &loaded.warnings, &[])
}
