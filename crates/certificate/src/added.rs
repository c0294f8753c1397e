use crate::limits::TOLERANCE;
use pairtrawl_model::{Claim, ClaimId, Overrides, PairTrajectory, Robot, SceneReference};
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

/// Judges the time law that a plan states (s at each waypoint) where it is another one than follows from scene and waypoints,
/// as in plans of earlier versions: what is driven is the derived one, but whoever drives by the stated times must keep the
/// robot's limits as well. The claim `speed` takes the smaller margin, and its detail says so.
pub fn judge_stated_time_law(
    speed: &mut Claim,
    robot: &Robot,
    trajectory: &PairTrajectory,
    (reference, stated): (&Reference, &[f64]),
) {
    let derived = reference.time_law();
    if derived.len() != stated.len() {
        let (times, waypoints) = (stated.len(), derived.len());
        let detail = format!("the plan's time law has {times} times for {waypoints} waypoints");
        return refuse(speed, None, detail);
    }
    // Written so that what is not a number is another time.
    let near = |(t, stated): (&f64, &f64)| (t - stated).abs() <= SAME_TIME + TOLERANCE * t.abs();
    if derived.iter().zip(stated).all(near) {
        return;
    }
    for (i, times) in stated.windows(2).enumerate() {
        let time = times[1] - times[0];
        for poses in [&trajectory.left, &trajectory.right] {
            let turning = (poses[i + 1].heading - poses[i].heading).abs();
            let driven = poses[i].position().distance(poses[i + 1].position());
            let wheel = driven + robot.half_track * turning;
            let within = wheel <= robot.v_max * time * (1.0 + TOLERANCE)
                && turning <= robot.omega_max * time * (1.0 + TOLERANCE);
            if !(within && time >= 0.0 && times[0] >= 0.0) {
                let detail = format!(
                    "by the plan's own time law step {i} takes {time:.6} s, which is too fast for a robot: the file was edited"
                );
                return refuse(speed, Some(i), detail);
            }
        }
    }
    speed.detail += "; the plan states another time law, which keeps the limits too: it was edited, or is of another version";
}

fn refuse(claim: &mut Claim, step: Option<usize>, detail: String) {
    claim.holds = false;
    claim.margin = f64::NEG_INFINITY;
    claim.step = step;
    claim.place = None;
    claim.detail = detail;
}
