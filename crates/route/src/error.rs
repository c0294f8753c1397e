use pairtrawl_geometry::Point;
use pairtrawl_model::numbers::place;

/// Why no route was found.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RouteError {
    /// No way for the pair leads from one stop to the next, not even with the smallest radius and margin.
    #[error(
        "no way for the pair leads from {} to {}: every passage is narrower than the pair; \
         widen it, move the object or lower planner.half_separation",
        place(*from), place(*to)
    )]
    NoPath {
        /// The stop that was reached.
        from: Point,
        /// The stop that was not.
        to: Point,
    },
    /// The search for a way from one stop to the next was given up before it had looked everywhere.
    #[error(
        "no way for the pair was found from {} to {} within {states} states of the search, which has not seen all of the \
         area: there may be one",
        place(*from), place(*to)
    )]
    SearchLimit {
        /// The stop that was reached.
        from: Point,
        /// The stop that was not.
        to: Point,
        /// States or samples that were looked at.
        states: usize,
    },
    /// The visiting order is not a permutation of the circles.
    #[error(
        "the visiting order names circle {index} {times} times; it must name each of the {circles} circles once"
    )]
    BadOrder {
        /// The circle that is missing, named twice, or does not exist.
        index: usize,
        /// How often the order names it.
        times: usize,
        /// How many circles the world has.
        circles: usize,
    },
    /// The centerline has fewer than two poses, or a pose that is not finite.
    #[error("the centerline has {poses} usable poses; the baseline needs at least 2, all finite")]
    BadCenterline {
        /// Finite poses in it.
        poses: usize,
    },
    /// Too few waypoints were asked for.
    #[error("{waypoints} waypoints were asked for; a pair of trajectories has at least 2")]
    TooFewWaypoints {
        /// The number asked for.
        waypoints: usize,
    },
}

impl RouteError {
    /// The same with its places in meters, after planning in units of `length` meters.
    #[must_use]
    pub fn in_meters(self, length: f64) -> Self {
        match self {
            Self::NoPath { from, to } => Self::NoPath {
                from: from * length,
                to: to * length,
            },
            Self::SearchLimit { from, to, states } => Self::SearchLimit {
                from: from * length,
                to: to * length,
                states,
            },
            Self::BadOrder { .. } | Self::BadCenterline { .. } | Self::TooFewWaypoints { .. } => {
                self
            }
        }
    }
}
