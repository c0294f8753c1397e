use super::{CAUTION, Proof, ProofKind, rounded_up};
use pairtrawl_model::Scene;

/// The net cannot span the pair at its start or end, or cannot pass over an object between the robots.
pub(super) fn prove(scene: &Scene, length: f64) -> Option<Proof> {
    let hitch = scene.robot.hitch;
    let mut worst: Option<(f64, String)> = None;
    let mut require = |needed: f64, why: String| {
        if worst.as_ref().is_none_or(|(most, _)| needed > *most) {
            worst = Some((needed, why));
        }
    };
    for (what, pair) in [("start", scene.start), ("end", scene.end)] {
        let hitches = pair
            .left
            .hitch_point(hitch)
            .distance(pair.right.hitch_point(hitch));
        require(
            hitches,
            format!("the hitch points at the {what} are {hitches:.3} m apart"),
        );
        let axles = pair.separation();
        require(
            axles,
            format!("the robots' axle centers at the {what} are {axles:.3} m apart"),
        );
    }
    let largest = scene.objects.iter().enumerate().reduce(|a, b| {
        if b.1.footprint_radius() > a.1.footprint_radius() {
            b
        } else {
            a
        }
    });
    if let Some((i, object)) = largest {
        let diameter = 2.0 * object.footprint_radius();
        let needed = diameter + 2.0 * scene.robot.radius;
        require(
            needed,
            format!(
                "a line over object {i} with a robot on each side is at least {needed:.3} m long (two robot radii and its footprint circle of {diameter:.3} m)"
            ),
        );
    }
    let (needed, why) = worst?;
    (length < needed - CAUTION).then(|| Proof {
        kind: ProofKind::NetTooShort { needed },
        message: format!(
            "the net is too short: {length} m, but {why}; lengthen it by at least {:.3} m, to {:.3} m",
            rounded_up(needed - length),
            rounded_up(needed)
        ),
    })
}
