use super::least_move::Move;
use pairtrawl_geometry::Point;
use pairtrawl_model::Side;
use std::fmt;

/// Why no plan can be valid, or none that gathers an object.
#[derive(Clone, Debug, PartialEq)]
pub struct Proof {
    /// Which argument it is, with its numbers: what [`verify`](super::verify()) derives again.
    pub kind: ProofKind,
    /// The proof for people: the thing, the amount, and the smallest change that would remove this obstruction.
    pub message: String,
    /// The least move of the object after which this argument says nothing against it any more; `None` when the proof is
    /// not about an object, or when no such place was found nearby.
    pub least_move: Option<Move>,
}

impl Proof {
    /// The object that cannot be swept; `None` when the proof is not about one: then there is no plan, whatever is left.
    pub fn object(&self) -> Option<usize> {
        self.kind.object()
    }
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// The kinds of proof; lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ProofKind {
    /// The net cannot span the pair at its start or end.
    NetTooShort {
        /// The net's length.
        net_length: f64,
        /// The least length that would do here.
        needed: f64,
    },
    /// The net is so long that the robots stand too close together at the start or end.
    NetTooLong {
        /// The net's length.
        net_length: f64,
        /// The distance between the axle centers where they are closest.
        separation: f64,
        /// The greatest length that would do here.
        most: f64,
    },
    /// The waypoints given do not reach from start to end.
    TooFewWaypoints {
        /// How many are given.
        waypoints: usize,
        /// Whose end is too far.
        robot: Side,
        /// How far it is from its start.
        distance: f64,
        /// The least number that might do.
        needed: usize,
    },
    /// One robot has no way from its start to its end.
    WayCut {
        /// Which robot.
        robot: Side,
        /// The grid on which no chain of cells joins them.
        grid: GridEvidence,
        /// Where the widest way is narrowest.
        place: Point,
        /// Its width there; 0 where it is closed.
        width: f64,
    },
    /// The net cannot span an object with a robot on each side.
    ObjectTooWide {
        /// Its index.
        object: usize,
        /// The net's length.
        net_length: f64,
        /// The least length that would do here.
        needed: f64,
    },
    /// The line between the robots cannot get to an object.
    ObjectEnclosed {
        /// Its index.
        object: usize,
        /// The robot that gets to no place from which its half of the line reaches the object.
        robot: Side,
        /// How long that half of the line is at most.
        reach: f64,
        /// The grid on which this is seen.
        grid: GridEvidence,
    },
    /// An object is so close to the edge of the area that the line between the robots cannot pass over it.
    ObjectAtEdge {
        /// Its index.
        object: usize,
        /// The nearest point of the edge.
        foot: Point,
        /// Distance between its footprint circle and the edge.
        gap: f64,
        /// The least distance that a robot passes.
        needed: f64,
    },
    /// An object is so close to an obstacle that the line between the robots cannot pass over it.
    ObjectPinned {
        /// Its index.
        object: usize,
        /// The nearest point of the obstacle.
        foot: Point,
        /// Distance between its footprint circle and the obstacle.
        gap: f64,
        /// The least distance that a robot passes.
        needed: f64,
    },
}

/// The grid on which a proof is seen: the area, cut into equal cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GridEvidence {
    /// Cells along x.
    pub columns: usize,
    /// Cells along y.
    pub rows: usize,
    /// Cells in which no point is a place for the robot's axle center.
    pub blocked: usize,
    /// Cells that chains of other cells join to the robot's start.
    pub reached: usize,
}

impl ProofKind {
    /// The name in files.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::NetTooShort { .. } => "net_too_short",
            Self::NetTooLong { .. } => "net_too_long",
            Self::TooFewWaypoints { .. } => "too_few_waypoints",
            Self::WayCut { .. } => "way_cut",
            Self::ObjectTooWide { .. } => "object_too_wide",
            Self::ObjectEnclosed { .. } => "object_enclosed",
            Self::ObjectAtEdge { .. } => "object_at_edge",
            Self::ObjectPinned { .. } => "object_pinned",
        }
    }

    /// The object that it is about, when it is about one.
    pub const fn object(&self) -> Option<usize> {
        match *self {
            Self::ObjectTooWide { object, .. }
            | Self::ObjectEnclosed { object, .. }
            | Self::ObjectAtEdge { object, .. }
            | Self::ObjectPinned { object, .. } => Some(object),
            Self::NetTooShort { .. }
            | Self::NetTooLong { .. }
            | Self::TooFewWaypoints { .. }
            | Self::WayCut { .. } => None,
        }
    }

    /// Its numbers by name; robots are not among them.
    pub(super) fn numbers(&self) -> Vec<(&'static str, f64)> {
        let of_grid = |grid: &GridEvidence| {
            [
                ("grid.columns", grid.columns as f64),
                ("grid.rows", grid.rows as f64),
                ("grid.blocked", grid.blocked as f64),
                ("grid.reached", grid.reached as f64),
            ]
        };
        let of_gap = |foot: Point, gap: f64, needed: f64| {
            vec![
                ("foot.x", foot.x),
                ("foot.y", foot.y),
                ("gap", gap),
                ("needed", needed),
            ]
        };
        match *self {
            Self::NetTooShort { net_length, needed } => {
                vec![("net_length", net_length), ("needed", needed)]
            }
            Self::NetTooLong {
                net_length,
                separation,
                most,
            } => vec![
                ("net_length", net_length),
                ("separation", separation),
                ("most", most),
            ],
            Self::TooFewWaypoints {
                waypoints,
                distance,
                needed,
                ..
            } => vec![
                ("waypoints", waypoints as f64),
                ("distance", distance),
                ("needed", needed as f64),
            ],
            Self::WayCut {
                ref grid,
                place,
                width,
                ..
            } => {
                let mut numbers = of_grid(grid).to_vec();
                numbers.extend([("place.x", place.x), ("place.y", place.y), ("width", width)]);
                numbers
            }
            Self::ObjectTooWide {
                net_length, needed, ..
            } => vec![("net_length", net_length), ("needed", needed)],
            Self::ObjectEnclosed {
                reach, ref grid, ..
            } => {
                let mut numbers = of_grid(grid).to_vec();
                numbers.push(("reach", reach));
                numbers
            }
            Self::ObjectAtEdge {
                foot, gap, needed, ..
            }
            | Self::ObjectPinned {
                foot, gap, needed, ..
            } => of_gap(foot, gap, needed),
        }
    }

    /// The robot that it is about, when it is about one.
    pub(super) const fn robot(&self) -> Option<Side> {
        match *self {
            Self::TooFewWaypoints { robot, .. }
            | Self::WayCut { robot, .. }
            | Self::ObjectEnclosed { robot, .. } => Some(robot),
            _ => None,
        }
    }
}
