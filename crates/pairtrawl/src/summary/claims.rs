use pairtrawl_model::{Certificate, ClaimSummary};

/// Name, meaning and unit of the margin of every claim of the file format.
const MEANINGS: [(&str, &str, &str); 16] = [
    ("scene", "the plan is for this very scene", ""),
    (
        "net_length",
        "the net is as long as the scene says, unless overridden",
        "m",
    ),
    ("endpoints", "first and last poses are the scene's", "m"),
    ("step", "no step is longer than the greatest step", "m"),
    (
        "turn",
        "no heading changes by more than the greatest turn in a step",
        "rad",
    ),
    ("forward", "robots drive forward only", "m"),
    ("no_sideways_slip", "robots move along their headings", "m"),
    (
        "speed",
        "wheels and turning stay within the robot's limits",
        "m/s",
    ),
    ("abreast", "robots face across the line between them", "rad"),
    ("robot_clearance", "no robot touches an obstacle", "m"),
    ("robots_miss_objects", "no robot touches an object", "m"),
    (
        "net_encloses_no_obstacle",
        "the line between the robots sweeps over no obstacle",
        "m",
    ),
    (
        "every_object_covered",
        "the line between the robots sweeps over every object",
        "m",
    ),
    (
        "separation",
        "robots neither touch nor overstretch the net",
        "m",
    ),
    ("net_reach", "the net reaches from hitch to hitch", "m"),
    ("inside_area", "robot centers stay inside the area", "m"),
];

/// The claims of a certificate with what they mean, the unit of their margin and when they are tightest.
pub fn claim_summaries(certificate: &Certificate, step_time: f64) -> Vec<ClaimSummary> {
    let claims = certificate.claims.iter();
    claims
        .map(|claim| {
            let known = MEANINGS.iter().find(|(name, ..)| *name == claim.name);
            let (_, meaning, unit) = known.copied().unwrap_or((claim.name, "", ""));
            ClaimSummary {
                claim: claim.clone(),
                meaning,
                unit,
                time: claim.step.map(|step| step as f64 * step_time),
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::summary::tests::scene;
    use pairtrawl_model::PairTrajectory;

    #[test]
    fn every_claim_of_the_certificate_has_a_meaning() {
        let certificate = pairtrawl_certificate::certify(&scene(), 1.0, &PairTrajectory::default());
        assert!(certificate.claims.len() >= 13);
        for summary in claim_summaries(&certificate, 0.25) {
            assert!(!summary.meaning.is_empty(), "{}", summary.claim.name);
            assert!(!summary.unit.is_empty(), "{}", summary.claim.name);
        }
    }
}
