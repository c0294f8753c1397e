use pairtrawl_certificate::infeasibility;
use pairtrawl_certificate::{certify, judge_stated_time_law, net_length_claim, scene_claim};
use pairtrawl_model::{
    Certificate, Claim, ClaimId, LeftOut, LeftWhy, Overrides, PairTrajectory, Scene, SceneReference,
};
use pairtrawl_reference::Reference;
use std::borrow::Cow;

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
    /// When the pair passes each waypoint, s, as the plan says. It is then judged on the smooth curve that it is driven along
    /// as well; `None`: it says nothing, as plans made elsewhere, and is judged with poses linear between waypoints.
    pub time_law: Option<&'a [f64]>,
    /// The objects that it leaves where they are: nothing is claimed of them but that robots miss them.
    pub left_out: &'a [LeftOut],
}

/// The scene with the objects marked that a plan leaves where they are.
pub(crate) fn without_left<'a>(scene: &'a Scene, left_out: &[LeftOut]) -> Cow<'a, Scene> {
    match left_out.is_empty() {
        true => Cow::Borrowed(scene),
        false => Cow::Owned(scene.leaving(left_out.iter().map(|left| left.object))),
    }
}

/// What is wrong with the objects that a plan leaves: one that the scene does not have, or one that is called impossible
/// without a proof.
fn unfounded(scene: &Scene, candidate: &Candidate) -> Option<String> {
    let left_out = candidate.left_out;
    if let Some(left) = (left_out.iter()).find(|left| left.object >= scene.objects.len()) {
        let (object, count) = (left.object, scene.objects.len());
        return Some(format!(
            "the plan leaves object {object}, but the scene has only {count} objects"
        ));
    }
    if left_out.iter().all(|left| left.why != LeftWhy::Proven) {
        return None;
    }
    let net_length = candidate.overrides.net_length.unwrap_or(scene.net.length);
    // Proofs are sought for what is called proven, and for nothing else.
    let called_proven = || left_out.iter().filter(|l| l.why == LeftWhy::Proven);
    let mut whole = scene.leaving(0..scene.objects.len());
    for left in called_proven() {
        whole.objects[left.object].leave = false;
    }
    let proven = infeasibility::impossible_objects(&whole, net_length);
    let left = called_proven().find(|left| !proven.contains(&left.object))?;
    Some(format!(
        "the plan leaves object {} as proven impossible, but there is no such proof",
        left.object
    ))
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
    let whole = scene;
    let scene = &*without_left(scene, candidate.left_out);
    let net = net_length_claim(candidate.net_length, scene.net.length, candidate.overrides);
    let mut claims = vec![whose, net];
    let driven = candidate.time_law.and_then(|stated| {
        // A trajectory without a reference fails its claims for the same reason.
        let reference = Reference::of_scene(scene, candidate.trajectory).ok()?;
        Some((reference, stated))
    });
    let curve = driven.as_ref().map(|(reference, _)| reference);
    let derived = certify(scene, candidate.net_length, candidate.trajectory, curve);
    claims.extend(derived.claims);
    if let Some((reference, stated)) = &driven
        && let Some(speed) = claims.iter_mut().find(|claim| claim.id == ClaimId::Speed)
    {
        let (robot, trajectory) = (&scene.robot, candidate.trajectory);
        judge_stated_time_law(speed, robot, trajectory, (reference, stated));
    }
    if let Some(problem) = unfounded(whole, candidate)
        && let Some(covered) = (claims.iter_mut()).find(|c| c.id == ClaimId::EveryObjectCovered)
    {
        covered.holds = false;
        covered.margin = f64::NEG_INFINITY;
        covered.detail = problem;
    }
    Certificate { claims }
}
