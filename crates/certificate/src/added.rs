use crate::TOLERANCE;
use pairtrawl_model::{Claim, ClaimId, Overrides, SceneReference};

/// The claim `scene`: the plan names this scene, by the hash of its files or, when both state it, by the hash of what the
/// files say. Hexadecimal digits compare without regard to case.
pub fn scene_claim(scene: &SceneReference, named: &SceneReference) -> Claim {
    let same_files = scene.sha256.eq_ignore_ascii_case(&named.sha256);
    let same_content = match (&scene.content_sha256, &named.content_sha256) {
        (Some(ours), Some(theirs)) => ours.eq_ignore_ascii_case(theirs),
        _ => false,
    };
    let holds = same_files || same_content;
    let detail = if same_files {
        String::new()
    } else if same_content {
        "the scene says the same as when it was planned, but the bytes of its files differ: a comment or the layout changed"
            .to_owned()
    } else {
        format!(
            "the plan is for a scene with hash '{}', this scene has '{}'",
            named.sha256, scene.sha256
        )
    };
    Claim {
        id: ClaimId::Scene,
        holds,
        margin: if holds { 0.0 } else { -1.0 },
        step: None,
        place: None,
        detail,
    }
}

/// The claim `net_length`: the plan's net is positive, and it is what the command line asked for, or else what the scene
/// says; an open length (neither, or `auto`) may be anything. The margin is minus the difference, m.
pub fn net_length_claim(plan: f64, scene: Option<f64>, overrides: &Overrides) -> Claim {
    let (wanted, source) = match overrides.net_length {
        Some(length) => (length, "the override"),
        None => (scene, "the scene"),
    };
    let (margin, detail) = match wanted {
        _ if !(plan.is_finite() && plan > 0.0) => (
            f64::NEG_INFINITY,
            format!("the net length {plan} m is not a positive number"),
        ),
        Some(length) if (plan - length).abs() <= TOLERANCE => {
            (-(plan - length).abs(), String::new())
        }
        Some(length) => {
            let margin = if length.is_finite() {
                -(plan - length).abs()
            } else {
                f64::NEG_INFINITY
            };
            (
                margin,
                format!("the plan's net is {plan} m long, {source} says {length} m"),
            )
        }
        None => (0.0, "left open".to_owned()),
    };
    Claim {
        id: ClaimId::NetLength,
        holds: margin >= -TOLERANCE,
        margin,
        step: None,
        place: None,
        detail,
    }
}
