use super::proof::{CAUTION, Proof, ProofKind};
use pairtrawl_model::Scene;
use pairtrawl_model::numbers::{enough_length, length, place};

/// The objects over which the net cannot pass with a robot on each side.
pub(super) fn prove(scene: &Scene, net_length: f64) -> Vec<Proof> {
    let wanted = scene.objects.iter().enumerate().filter(|(_, o)| !o.leave);
    wanted
        .filter_map(|(i, object)| {
            let diameter = 2.0 * object.footprint_radius();
            let needed = diameter + 2.0 * scene.robot.radius;
            (net_length < needed - CAUTION).then(|| Proof {
                kind: ProofKind::ObjectTooWide { object: i, needed },
                message: format!(
                    "object {i} at {} cannot be swept: the net is too short: {}, but a line over this object with a robot \
                     on each side is at least {} long (two robot radii and its footprint circle of {}); lengthen it by at \
                     least {}, to {}",
                    place(object.position),
                    length(net_length),
                    length(needed),
                    length(diameter),
                    enough_length(needed - net_length),
                    enough_length(needed)
                ),
            })
        })
        .collect()
}
