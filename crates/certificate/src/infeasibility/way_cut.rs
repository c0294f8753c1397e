use super::free_space::Run;
use super::narrowest::narrowest;
use super::proof::{Proof, ProofKind};
use super::things::Things;

/// Words for a robot whose start and end no chain of cells joins.
pub(super) fn proof(things: &Things<'_>, run: Run) -> Proof {
    let narrowest = narrowest(things, run.start, run.end, None);
    Proof {
        kind: ProofKind::WayCut {
            place: narrowest.place,
            width: narrowest.width,
        },
        message: format!(
            "every way of the {} from start to end is cut by gaps below two robot radii; on the widest way, {}",
            run.name, narrowest.words
        ),
    }
}
