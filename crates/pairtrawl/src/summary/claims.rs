use pairtrawl_model::{Certificate, ClaimSummary};

/// The claims of a certificate with what they mean, the unit of their margin and when they are tightest.
pub fn claim_summaries(certificate: &Certificate, step_time: f64) -> Vec<ClaimSummary> {
    let claims = certificate.claims.iter();
    claims
        .map(|claim| ClaimSummary {
            claim: claim.clone(),
            meaning: claim.id.meaning(),
            unit: claim.id.unit(),
            time: claim.step.map(|step| step as f64 * step_time),
        })
        .collect()
}
