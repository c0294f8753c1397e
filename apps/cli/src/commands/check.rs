use crate::arguments::CheckArguments;
use crate::exit::{Exit, Failure};
use crate::output::{self, Done};
use crate::summary_text::{claim_json, claim_text};
use pairtrawl::files::{read_plan, read_scene};
use pairtrawl::{Candidate, claim_summaries};
use serde_json::json;

/// `pairtrawl check`: every claim of a plan, proven again or refused.
pub fn check(arguments: &CheckArguments) -> Result<Done, Failure> {
    let loaded = read_scene(&arguments.scene)?;
    let plan = read_plan(&arguments.plan)?;
    let trajectory = plan.trajectory(&loaded.scene);
    let candidate = Candidate {
        net_length: plan.net_length,
        trajectory: &trajectory,
        scene: plan.scene.as_ref(),
        overrides: &plan.overrides,
        time_law: plan.time_law.as_deref(),
    };
    let certificate = pairtrawl::check(&loaded.scene, &loaded.reference, &candidate);
    let claims = claim_summaries(&certificate, &trajectory.times());

    let valid = certificate.is_valid();
    let failed = claims.iter().filter(|summary| !summary.claim.holds).count();
    let mut text = String::new();
    for claim in &claims {
        text.push_str(&claim_text(claim));
        text.push('\n');
    }
    text.push_str(&if valid {
        format!("valid: all {} claims hold\n", claims.len())
    } else {
        format!("INVALID: {failed} of {} claims fail\n", claims.len())
    });
    output::warnings(&mut text, &loaded.warnings);
    let object = json!({
        "command": "check",
        "valid": valid,
        "claims": claims.iter().map(claim_json).collect::<Vec<_>>(),
        "warnings": loaded.warnings,
    });
    Ok(Done {
        exit: if valid { Exit::Done } else { Exit::Invalid },
        text,
        object,
    })
}
