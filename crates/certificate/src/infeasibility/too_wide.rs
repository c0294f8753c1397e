use super::proof::{Proof, ProofKind};
use super::things::sure_radius;
use crate::limits::CAUTION;
use pairtrawl_model::Scene;
use pairtrawl_model::numbers::{enough_length, length, place};

/// The objects over which the net cannot pass with a robot on each side.
pub(super) fn prove(scene: &Scene, net_length: f64) -> impl Iterator<Item = Proof> + '_ {
    let wanted = (0..scene.objects.len()).filter(|&i| !scene.objects[i].leave);
    wanted.filter_map(move |object| about(scene, net_length, object))
}

/// The proof about one object.
pub(super) fn about(scene: &Scene, net_length: f64, object: usize) -> Option<Proof> {
    let diameter = 2.0 * scene.objects[object].footprint_radius();
    let needed = diameter + 2.0 * sure_radius(&scene.robot);
    (net_length < needed - CAUTION).then(|| Proof {
        kind: ProofKind::ObjectTooWide {
            object,
            net_length,
            needed,
        },
        least_move: None,
        message: format!(
            "object {object} at {} cannot be swept: the net is {} long, but a line over this object with a robot on each \
             side is at least {} long (two robot radii and its footprint circle of {}); lengthen it by at least {}, to {}",
            place(scene.objects[object].position),
            length(net_length),
            length(needed),
            length(diameter),
            enough_length(needed - net_length),
            enough_length(needed)
        ),
    })
}
