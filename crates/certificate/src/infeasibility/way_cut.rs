use super::free_space::{FreeSpace, Reached, Run};
use super::narrowest::narrowest;
use super::proof::{Proof, ProofKind};
use super::things::Things;

/// Words for a robot whose start and end no chain of cells joins.
pub(super) fn proof(things: &Things<'_>, space: &FreeSpace, reached: &Reached, run: Run) -> Proof {
    let [start, end] = things.ends_of_largest(run.side);
    let narrowest = narrowest(things, start, end, None);
    Proof {
        kind: ProofKind::WayCut {
            robot: run.side,
            grid: space.evidence(&reached.may[run.side.index()]),
            place: narrowest.place,
            width: narrowest.width,
        },
        least_move: None,
        message: format!(
            "every way of the {} from start to end is cut by gaps below two robot radii; on the widest way, {}",
            run.name, narrowest.words
        ),
    }
}
