use crate::files::InfeasibleFile;
use pairtrawl_certificate::infeasibility::{Refusal, verify};
use pairtrawl_certificate::scene_claim;
use pairtrawl_model::{Certificate, Claim, Scene, SceneReference};

/// The verdict on proofs that a scene has no plan.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckedProofs {
    /// The claim that they are about this scene.
    pub scene: Claim,
    /// Each proof, or why it does not hold.
    pub proofs: Vec<Result<(), Refusal>>,
}

impl CheckedProofs {
    /// True when they are about this scene, there is one, and all hold.
    pub fn is_valid(&self) -> bool {
        self.scene.holds && !self.proofs.is_empty() && self.proofs.iter().all(Result::is_ok)
    }

    /// The claim about the scene as a certificate of its own.
    pub fn scene_certificate(&self) -> Certificate {
        Certificate {
            claims: vec![self.scene.clone()],
        }
    }
}

/// Verifies proofs that a scene has no plan, without searching: each argument is followed once, on what it names, and
/// every number that it states must come out again.
pub fn check_proofs(
    scene: &Scene,
    reference: &SceneReference,
    file: &InfeasibleFile,
) -> CheckedProofs {
    let net_length = file.overrides.net_length.unwrap_or(scene.net.length);
    let waypoints = file.waypoints.or(scene.planner.waypoints);
    let named = file.scene.as_ref().unwrap_or(reference);
    let proofs = file.proofs.iter().map(|proof| {
        let (kind, least_move) = (&proof.kind, proof.least_move);
        verify(scene, net_length, waypoints, kind, least_move)
    });
    CheckedProofs {
        scene: scene_claim(reference, named),
        proofs: proofs.collect(),
    }
}
