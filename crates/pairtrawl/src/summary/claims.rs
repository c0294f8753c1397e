use pairtrawl_model::{Certificate, ClaimSummary};

/// The claims of a certificate with what they mean, the unit of their margin and when they are tightest; `times` says when
/// each waypoint is passed, s.
pub fn claim_summaries(certificate: &Certificate, times: &[f64]) -> Vec<ClaimSummary> {
    let claims = certificate.claims.iter();
    claims
        .map(|claim| ClaimSummary {
            claim: claim.clone(),
            meaning: claim.id.meaning(),
            unit: claim.id.unit(),
            time: claim.step.and_then(|step| times.get(step).copied()),
        })
        .collect()
}
