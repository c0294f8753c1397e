/// What is known of a cell as a place for a robot's center.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cell {
    /// No point of the closed cell keeps a robot radius from everything.
    Blocked,
    /// Every point does.
    Free,
    /// Some may.
    Mixed,
}
