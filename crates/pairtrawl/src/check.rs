use pairtrawl_certificate::{certify, net_length_claim, scene_claim};
use pairtrawl_model::{
    Certificate, Claim, ClaimId, Overrides, PairTrajectory, Scene, SceneReference,
};

/// What a certificate is about: the part of a plan that `check` needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate<'a> {
    /// d_max, m.
    pub net_length: f64,
    /// What the robots drive.
    pub trajectory: &'a PairTrajectory,
    /// Which scene it says that it is for; `None`: it does not say.
    pub scene: Option<&'a SceneReference>,
    /// What was changed against the scene.
    pub overrides: &'a Overrides,
}

/// Proves a plan from its scene and its two trajectories alone: every claim of the file format, `scene` and `net_length`
/// first. Nothing else that the plan says is believed.
pub fn check(scene: &Scene, reference: &SceneReference, candidate: &Candidate) -> Certificate {
    let whose = match candidate.scene {
        Some(named) => scene_claim(reference, named),
        None => Claim {
            id: ClaimId::Scene,
            holds: true,
            margin: 0.0,
            step: None,
            place: None,
            detail: "the plan names no scene: it is judged against this one".to_owned(),
        },
    };
    let net = net_length_claim(candidate.net_length, scene.net.length, candidate.overrides);
    let mut claims = vec![whose, net];
    claims.extend(certify(scene, candidate.net_length, candidate.trajectory).claims);
    Certificate { claims }
}
