/// Why a world could not be built.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum WorldError {
    /// The occupancy grid would have more cells than [`crate::MAX_CELLS`].
    #[error(
        "the occupancy grid would need {cells:.3e} cells ({width} m x {height} m at {resolution} m), the bound is {bound}: \
         choose a coarser resolution or a smaller area"
    )]
    TooManyCells {
        /// Cells needed.
        cells: f64,
        /// Width of the grid, m.
        width: f64,
        /// Height of the grid, m.
        height: f64,
        /// Cell size, m.
        resolution: f64,
        /// The greatest number of cells.
        bound: usize,
    },
    /// A number that must be positive and finite is not.
    #[error("{name} is {value}, it must be finite and above zero")]
    NotPositive {
        /// What it is.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A point that must be finite is not.
    #[error("{name} lies at ({x}, {y}), both coordinates must be finite")]
    NotFinite {
        /// What it is.
        name: String,
        /// Its x, m.
        x: f64,
        /// Its y, m.
        y: f64,
    },
    /// A polygon that encloses nothing.
    #[error(
        "obstacle {index} is a polygon that encloses no area: give at least three vertices that are not on one line"
    )]
    FlatPolygon {
        /// Index of the obstacle in the scene.
        index: usize,
    },
}

impl WorldError {
    /// The same with its lengths in meters, after a world was built in units of `length` meters.
    #[must_use]
    pub fn in_meters(self, length: f64) -> Self {
        match self {
            Self::TooManyCells {
                cells,
                width,
                height,
                resolution,
                bound,
            } => Self::TooManyCells {
                cells,
                width: width * length,
                height: height * length,
                resolution: resolution * length,
                bound,
            },
            Self::NotPositive { name, value } => Self::NotPositive {
                name,
                value: value * length,
            },
            Self::NotFinite { name, x, y } => Self::NotFinite {
                name,
                x: x * length,
                y: y * length,
            },
            Self::FlatPolygon { .. } => self,
        }
    }
}
