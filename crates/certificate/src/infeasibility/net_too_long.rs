use super::proof::{Proof, ProofKind};
use crate::limits::CAUTION;
use pairtrawl_model::Scene;
use pairtrawl_model::numbers::{length, most_length};

/// The separation is at least this part of d_max (claim `separation`).
const LEAST_SEPARATION: f64 = 0.1;

/// The robots at the start or end are closer together than a net of this length allows.
pub(super) fn prove(scene: &Scene, net_length: f64) -> Option<Proof> {
    let ends = [("start", scene.start), ("end", scene.end)];
    let (what, closest) = ends
        .map(|(what, pair)| (what, pair.separation()))
        .into_iter()
        .reduce(|a, b| if b.1 < a.1 { b } else { a })?;
    let least = LEAST_SEPARATION * net_length;
    let most = closest / LEAST_SEPARATION;
    (least > closest + CAUTION).then(|| Proof {
        kind: ProofKind::NetTooLong {
            net_length,
            separation: closest,
            most,
        },
        least_move: None,
        message: format!(
            "the net is too long: robots keep at least a tenth of its length apart, that is {} of {}, but their axle centers \
             at the {what} are {} apart; shorten it to at most {}, or move them apart there",
            length(least),
            length(net_length),
            length(closest),
            most_length(most)
        ),
    })
}
