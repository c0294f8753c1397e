use super::proof::{Proof, ProofKind};
use crate::limits::CAUTION;
use pairtrawl_model::Scene;
use pairtrawl_model::numbers::{enough_length, length};

/// The net cannot span the pair at its start or end.
pub(super) fn prove(scene: &Scene, net_length: f64) -> Option<Proof> {
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
            format!(
                "the hitch points at the {what} are {} apart",
                length(hitches)
            ),
        );
        let axles = pair.separation();
        require(
            axles,
            format!(
                "the robots' axle centers at the {what} are {} apart",
                length(axles)
            ),
        );
    }
    let (needed, why) = worst?;
    (net_length < needed - CAUTION).then(|| Proof {
        kind: ProofKind::NetTooShort { net_length, needed },
        least_move: None,
        message: format!(
            "the net is too short: {}, but {why}; lengthen it by at least {}, to {}",
            length(net_length),
            enough_length(needed - net_length),
            enough_length(needed)
        ),
    })
}
