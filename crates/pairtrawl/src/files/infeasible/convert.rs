//! Between the file's words for proofs and the certificate's.

use super::StatedProof;
use super::file::{Argument, FileGrid, FileMove, FileProof, FileSide};
use pairtrawl_certificate::infeasibility::{GridEvidence, Move, Proof, ProofKind};
use pairtrawl_geometry::Point;
use pairtrawl_model::Side;

impl From<&Proof> for FileProof {
    fn from(proof: &Proof) -> Self {
        Self {
            argument: Argument::from(proof.kind),
            objects: proof.object().into_iter().collect(),
            text: proof.message.clone(),
            least_move: proof.least_move.map(|least| FileMove {
                to: least.to.into(),
                distance: least.distance,
            }),
        }
    }
}

impl FileProof {
    /// The proof as it is stated; the bound on `objects` when they do not fit the argument.
    pub(super) fn into_stated(self) -> Result<StatedProof, &'static str> {
        let kind = self.argument.about(&self.objects)?;
        Ok(StatedProof {
            kind,
            least_move: self.least_move.map(|least| Move {
                to: Point::from(least.to),
                distance: least.distance,
            }),
            text: self.text,
        })
    }
}

impl From<ProofKind> for Argument {
    fn from(kind: ProofKind) -> Self {
        match kind {
            ProofKind::NetTooShort { net_length, needed } => {
                Self::NetTooShort { net_length, needed }
            }
            ProofKind::NetTooLong {
                net_length,
                separation,
                most,
            } => Self::NetTooLong {
                net_length,
                separation,
                most,
            },
            ProofKind::TooFewWaypoints {
                waypoints,
                robot,
                distance,
                needed,
            } => Self::TooFewWaypoints {
                waypoints,
                robot: robot.into(),
                distance,
                needed,
            },
            ProofKind::WayCut {
                robot,
                grid,
                place,
                width,
            } => Self::WayCut {
                robot: robot.into(),
                grid: grid.into(),
                place: place.into(),
                width,
            },
            ProofKind::ObjectTooWide {
                net_length, needed, ..
            } => Self::ObjectTooWide { net_length, needed },
            ProofKind::ObjectEnclosed {
                robot, reach, grid, ..
            } => Self::ObjectEnclosed {
                robot: robot.into(),
                reach,
                grid: grid.into(),
            },
            ProofKind::ObjectAtEdge {
                foot, gap, needed, ..
            } => Self::ObjectAtEdge {
                foot: foot.into(),
                gap,
                needed,
            },
            ProofKind::ObjectPinned {
                foot, gap, needed, ..
            } => Self::ObjectPinned {
                foot: foot.into(),
                gap,
                needed,
            },
        }
    }
}

impl Argument {
    fn about(self, objects: &[usize]) -> Result<ProofKind, &'static str> {
        let one = || match objects {
            [object] => Ok(*object),
            _ => Err("a list of the one object that this kind of proof is about"),
        };
        let none = |kind| match objects {
            [] => Ok(kind),
            _ => Err("an empty list: this kind of proof is not about an object"),
        };
        match self {
            Self::NetTooShort { net_length, needed } => {
                none(ProofKind::NetTooShort { net_length, needed })
            }
            Self::NetTooLong {
                net_length,
                separation,
                most,
            } => none(ProofKind::NetTooLong {
                net_length,
                separation,
                most,
            }),
            Self::TooFewWaypoints {
                waypoints,
                robot,
                distance,
                needed,
            } => none(ProofKind::TooFewWaypoints {
                waypoints,
                robot: robot.into(),
                distance,
                needed,
            }),
            Self::WayCut {
                robot,
                grid,
                place,
                width,
            } => none(ProofKind::WayCut {
                robot: robot.into(),
                grid: grid.into(),
                place: place.into(),
                width,
            }),
            Self::ObjectTooWide { net_length, needed } => Ok(ProofKind::ObjectTooWide {
                object: one()?,
                net_length,
                needed,
            }),
            Self::ObjectEnclosed { robot, reach, grid } => Ok(ProofKind::ObjectEnclosed {
                object: one()?,
                robot: robot.into(),
                reach,
                grid: grid.into(),
            }),
            Self::ObjectAtEdge { foot, gap, needed } => Ok(ProofKind::ObjectAtEdge {
                object: one()?,
                foot: foot.into(),
                gap,
                needed,
            }),
            Self::ObjectPinned { foot, gap, needed } => Ok(ProofKind::ObjectPinned {
                object: one()?,
                foot: foot.into(),
                gap,
                needed,
            }),
        }
    }
}

impl From<GridEvidence> for FileGrid {
    fn from(grid: GridEvidence) -> Self {
        let GridEvidence {
            columns,
            rows,
            blocked,
            reached,
        } = grid;
        Self {
            columns,
            rows,
            blocked,
            reached,
        }
    }
}

impl From<FileGrid> for GridEvidence {
    fn from(grid: FileGrid) -> Self {
        let FileGrid {
            columns,
            rows,
            blocked,
            reached,
        } = grid;
        Self {
            columns,
            rows,
            blocked,
            reached,
        }
    }
}

impl From<Side> for FileSide {
    fn from(side: Side) -> Self {
        match side {
            Side::Left => Self::Left,
            Side::Right => Self::Right,
        }
    }
}

impl From<FileSide> for Side {
    fn from(side: FileSide) -> Self {
        match side {
            FileSide::Left => Self::Left,
            FileSide::Right => Self::Right,
        }
    }
}
