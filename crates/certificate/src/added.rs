use crate::TOLERANCE;
use pairtrawl_model::{Claim, ClaimId, Overrides, SceneReference};
use pairtrawl_reference::Reference;

/// A time law that is stated may differ from the one that is derived by this much, s, and by `TOLERANCE` of the time.
const SAME_TIME: f64 = 1e-6;

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

/// Refuses the claim `speed` of a plan that states another time law (s at each waypoint) than the one that follows from scene
/// and waypoints: that law is not what is driven.
pub fn compare_time_law(speed: &mut Claim, reference: &Reference, stated: &[f64]) {
    let derived = reference.time_law();
    let other = |(_, (t, stated)): &(usize, (&f64, &f64))| {
        // Also what is not a number is another time.
        let near = (*t - *stated).abs() <= SAME_TIME + TOLERANCE * t.abs();
        !near
    };
    let difference = derived.iter().zip(stated).enumerate().find(other);
    let doubt = match difference {
        Some((i, (t, stated))) => format!(
            "the plan says that waypoint {i} is passed at {stated} s, its waypoints make it {t:.6} s"
        ),
        None if derived.len() != stated.len() => format!(
            "the plan's time law has {} times for {} waypoints",
            stated.len(),
            derived.len()
        ),
        None => return,
    };
    speed.holds = false;
    speed.margin = f64::NEG_INFINITY;
    speed.step = difference.map(|(i, _)| i);
    speed.place = None;
    speed.detail = format!("{doubt}: the file was edited, or is of another version");
}
